#pragma once

#include "Base/Progress.h"
#include "Mesh/Graph.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Computes the length of the shortest path along edges from the sources to each point. Returns n
/// distances in the model's units. A distance is never less than the geodesic distance, and
/// infinite if there is no path. Throws InvalidInput when RequireIndices does, and Aborted.
Eigen::VectorXd ComputeEdgeGeodesics(
  const Surface& surface, const GraphSources& sources, const Progress& progress = {});

} // namespace shape
