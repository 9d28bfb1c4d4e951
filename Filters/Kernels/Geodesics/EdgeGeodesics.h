#pragma once

#include "Base/Progress.h"
#include "Mesh/Graph.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// The length of the shortest path along edges from the sources to each point: n distances in the
/// model's units, never less than the geodesic ones; infinite if no path leads there. Throws
/// InvalidInput as RequireIndices, Aborted.
Eigen::VectorXd ComputeEdgeGeodesics(
  const Surface& surface, const GraphSources& sources, const Progress& progress = {});

} // namespace shape
