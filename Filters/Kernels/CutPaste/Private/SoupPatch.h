#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// The soup with split edges near the seed.
struct RefinedSoup
{
  Mesh Surface;
  std::vector<int> Original;                 ///< for each triangle, the given one
  std::vector<std::array<int, 2>> Midpoints; ///< for each new point, the ends of its edge
};

/// Splits edges of triangles within `radius` of the seed in two, until none is longer than
/// `length`. Throws Aborted.
RefinedSoup RefineSoup(const Mesh& soup, const Eigen::RowVector3d& seed, double radius,
  double length, const Progress& progress);

/// The patch of the samples, and the part of the refined soup that it maps to the plane.
struct SoupPatch
{
  ExponentialPatch Patch;
  Eigen::MatrixXd Points, Normals; ///< of the samples in the patch, in its order
  std::vector<int> PointOf;        ///< k points of the refined soup: first the samples
  Eigen::MatrixXd Images;          ///< k x 2
  std::vector<int> RowOf;          ///< for each point of the refined soup, its row, or -1
  std::vector<int> Triangles;      ///< of the refined soup, with all corners in the patch
};

/// Maps the points within `radius` of the seed to the plane, by the exponential map of samples
/// among them. length: that of RefineSoup. The plane is that of the base, on the side on which most
/// triangles are counter-clockwise, by area. Throws InvalidInput if there are no triangles;
/// Aborted.
SoupPatch FlattenSoup(const RefinedSoup& refined, const FeatureFootprint& base,
  const Eigen::RowVector3d& seed, double radius, double length,
  const ExponentialMapOptions& options, const Progress& progress);

} // namespace shape
