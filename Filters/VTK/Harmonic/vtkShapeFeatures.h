#pragma once

#include "Harmonic/PiecewiseVolumeMap.h"

#include <string>
#include <vector>

class vtkPolyData;

/// Conversion of the features of a harmonic volume map to kernel types. Features are points, curves
/// or surfaces with known images.
namespace vtkShapeFeatures
{

/**
 * Returns the points of `features`, their images and their weights.
 *
 * If a feature has the point array `mapArray`, this array contains its images. Among the features
 * without this array, the i-th is paired with the i-th of `targets`. Curves are paired with curves
 * by arc length. Points are added to a curve if its points are more than `longestStep` apart.
 * Two-point lines that are connected end to end form one curve. Features without curves are paired
 * with their targets point by point, in order.
 *
 * The weights are the point array `Weight` (1 component) if it exists, otherwise `defaultWeight`.
 *
 * Throws shape::InvalidInput if a feature has no target, a feature and its target do not match, a
 * weight is not greater than 0, or a value is not finite.
 */
shape::VolumeFeatures Read(const std::vector<vtkPolyData*>& features,
  const std::vector<vtkPolyData*>& targets, const std::string& mapArray, double defaultWeight,
  double longestStep);

/// Features that are fitted exactly (Surfaces), and the other features with their targets.
struct Split
{
  std::vector<shape::ExactSurface> Surfaces;
  std::vector<vtkPolyData*> Features, Targets;
};

/**
 * Separates the surfaces from the other features. Surfaces are features with polygons. Their images
 * are `mapArray` or the points of their target, in order. The other features must have the point
 * array `Weight`.
 *
 * Throws shape::InvalidInput if points or curves have no `Weight`, because they would then have to
 * be fitted exactly. Throws the exceptions of Read.
 */
Split TakeSurfaces(const std::vector<vtkPolyData*>& features,
  const std::vector<vtkPolyData*>& targets, const std::string& mapArray);

} // namespace vtkShapeFeatures
