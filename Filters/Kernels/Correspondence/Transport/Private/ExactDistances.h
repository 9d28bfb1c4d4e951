#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

namespace shape
{

/// Computes the exact distances (n x k) of all points of a surface from each of k positions on it
/// (ComputeExactGeodesics). surface: one that RequireConnected accepts. The time is about that of k
/// n^2 steps. Throws SolveFailure, Aborted.
Eigen::MatrixXd ComputeExactDistances(
  const Surface& surface, const SurfacePoints& sources, const Progress& progress = {});

} // namespace shape
