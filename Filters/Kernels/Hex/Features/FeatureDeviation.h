#pragma once

#include "Distance/HausdorffDistance.h"
#include "Mesh/Mesh.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// How well the boundary of hexahedra has the creases and corners of a surface.
struct FeatureDeviation
{
  /// The larger one-sided Hausdorff distance between the surface's curves and the edges between
  /// quads of different patches, at places along both; to the whole boundary where it is of one
  /// patch. 0 where the surface has no curves.
  double Distance = 0.0;
  std::vector<int> CornerPoints; ///< of the boundary, those exactly at a corner of the surface
};

/// quads: q x 4, of points. patchOf: q.
FeatureDeviation CompareCreases(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf);

/// Positions along the surface's curves, and how far each is from the edges between quads of
/// different patches; from the whole boundary where it is of one patch.
SampledDistances ComputeDistancesToCurves(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf);

} // namespace shape
