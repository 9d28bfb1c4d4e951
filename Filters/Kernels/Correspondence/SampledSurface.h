#pragma once

#include "Core/Mesh.h"
#include "Core/Progress.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// A surface of area 1 as a few points that are evenly spread over it.
struct SampledSurface
{
  std::vector<int> Points;   ///< s: of the mesh, the farthest from each other
  Eigen::MatrixXd Distances; ///< n x s: along the surface, over the root of its area
  Eigen::VectorXd Weights;   ///< s: the share of the area that is nearest to each; the sum is 1
  double Length = 0.0;       ///< the root of the area, in the model's units
  Eigen::MatrixXd Between() const; ///< s x s: Distances of the samples, made symmetric
};

/// The same points, and all points' distances from them (HeatDistances). mesh: RequireConnected.
/// Fewer than `count` where the mesh has not so many. Throws SolveFailure, Aborted.
SampledSurface SampleSurface(const Mesh& mesh, int count, const Progress& progress = {});

/// Throws InvalidInput unless the mesh is a consistently oriented 2-manifold of one component with
/// an area, open or closed, and a triangle at each point. `name`: "surface A".
void RequireConnected(const Mesh& mesh, const std::string& name);

} // namespace shape
