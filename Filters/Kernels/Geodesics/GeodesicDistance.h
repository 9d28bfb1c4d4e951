#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

namespace shape
{

struct GeodesicDistanceOptions
{
  enum class MethodType
  {
    Heat,    ///< HeatGeodesics: smooth, close to the exact distance
    Exact,   ///< ComputeExactGeodesics
    Dijkstra ///< ComputeEdgeGeodesics: along edges, never less than the exact distance
  };
  MethodType Method = MethodType::Heat;
};

struct GeodesicDistanceResult
{
  Eigen::VectorXd Distances; ///< n distances in the model's units; -1 if no path leads to a seed
  int Unreached = 0;         ///< number of points whose distance is -1
};

/**
 * Computes, for each point of a surface, the distance along the surface to the nearest of `seeds`.
 *
 * surface: triangles (RequireTriangles), or a 2-manifold for Exact. seeds: k x 3 positions, at
 * least one; each is projected to the closest position on the surface. Throws InvalidInput if the
 * surface is not a 2-manifold, a coordinate is not finite or there is no seed; SolveFailure,
 * Aborted.
 */
GeodesicDistanceResult ComputeGeodesicDistance(const Surface& surface, const Eigen::MatrixXd& seeds,
  const GeodesicDistanceOptions& options = {}, const Progress& progress = {});

} // namespace shape
