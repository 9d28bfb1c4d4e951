#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

namespace shape
{

struct GeodesicDistanceOptions
{
  enum class MethodType
  {
    Heat,    ///< HeatGeodesics: smooth, near to the shortest paths
    Exact,   ///< ComputeExactGeodesics
    Dijkstra ///< ComputeEdgeGeodesics: along edges, never too short
  };
  MethodType Method = MethodType::Heat;
};

struct GeodesicDistanceResult
{
  Eigen::VectorXd Distances; ///< n, in the model's units; -1 where no path leads to a seed
  int Unreached = 0;         ///< points with -1
};

/**
 * How far it is along a surface from the nearest of `seeds` to each point.
 *
 * mesh: a 2-manifold, open or closed. seeds: k x 3 places, at least one, each taken to the closest
 * place of the surface. Throws InvalidInput where the surface is no such one, a coordinate is not
 * finite or there is no seed, SolveFailure, Aborted.
 */
GeodesicDistanceResult ComputeGeodesicDistance(const Mesh& mesh, const Eigen::MatrixXd& seeds,
  const GeodesicDistanceOptions& options = {}, const Progress& progress = {});

} // namespace shape
