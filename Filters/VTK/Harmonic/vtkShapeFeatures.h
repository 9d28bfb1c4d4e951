#pragma once

#include "Harmonic/PiecewiseVolumeMap.h"

#include <string>
#include <vector>

class vtkPolyData;

/// Conversion of the features of a harmonic volume map: points, curves or surfaces whose positions
/// in the target are known.
namespace vtkShapeFeatures
{

/**
 * Returns the points of `features`, their images and weights.
 *
 * If a feature has the point array `mapArray`, that contains its images. The i-th feature without
 * it is paired with the i-th of `targets`. Curves are paired with curves by arc length; points are
 * added if they are more than `longestStep` apart. Features without curves are paired point by
 * point, in order. Lines of two points that are connected end to end form one curve.
 *
 * The weights are the point array `Weight` (1 component) if it exists, otherwise `defaultWeight`.
 *
 * Throws shape::InvalidInput if a feature has no partner, partners do not match, a weight is not
 * greater than 0, or a number is not finite.
 */
shape::VolumeFeatures Read(const std::vector<vtkPolyData*>& features,
  const std::vector<vtkPolyData*>& targets, const std::string& mapArray, double defaultWeight,
  double longestStep);

/// Features that are matched exactly (Surfaces), and the other features with their targets.
struct Split
{
  std::vector<shape::ExactSurface> Surfaces;
  std::vector<vtkPolyData*> Features, Targets;
};

/**
 * Separates the surfaces from the other features. Surfaces are features with polygons; their images
 * are `mapArray` or the points of their target in order. The other features must have `Weight`.
 *
 * Throws shape::InvalidInput if points or curves have no `Weight`, since they would then have to be
 * matched exactly. Throws the exceptions of Read.
 */
Split TakeSurfaces(const std::vector<vtkPolyData*>& features,
  const std::vector<vtkPolyData*>& targets, const std::string& mapArray);

} // namespace vtkShapeFeatures
