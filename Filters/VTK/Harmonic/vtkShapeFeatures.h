#pragma once

#include "Harmonic/PiecewiseVolumeMap.h"

#include <string>
#include <vector>

class vtkPolyData;

/// The features of a harmonic volume map as data: points, curves or surfaces whose positions in the
/// target are known.
namespace vtkShapeFeatures
{

/**
 * The points of `features`, their images and weights.
 *
 * A feature with the point array `mapArray` brings its own images. The i-th of those without is
 * paired with the i-th of `targets`: its curves with that one's curves by arc length, with points
 * between where they are more than `longestStep` apart; or, where it has no curves, its points with
 * that one's points by order. Lines of two points that follow each other end to end are one curve.
 *
 * `Weight` (1 component) at the features' points, where it is there, else `defaultWeight`.
 *
 * Throws shape::InvalidInput if a feature is left without a partner, partners do not match, a
 * weight is not greater than 0, or a number is not finite.
 */
shape::VolumeFeatures Read(const std::vector<vtkPolyData*>& features,
  const std::vector<vtkPolyData*>& targets, const std::string& mapArray, double defaultWeight,
  double longestStep);

/// Features that are to be met exactly, and those that are not, with the targets left for them.
struct Split
{
  std::vector<shape::ExactSurface> Surfaces;
  std::vector<vtkPolyData*> Features, Targets;
};

/**
 * Takes the surfaces out: features with polygons, whose images are `mapArray` or the points of
 * their target by order. What is left must carry `Weight`.
 *
 * Throws shape::InvalidInput if points or curves have no `Weight`, which would ask for them to
 * be met exactly, and as Read does.
 */
Split TakeSurfaces(const std::vector<vtkPolyData*>& features,
  const std::vector<vtkPolyData*>& targets, const std::string& mapArray);

} // namespace vtkShapeFeatures
