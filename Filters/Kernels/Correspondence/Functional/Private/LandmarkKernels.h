#pragma once

#include "Correspondence/Pair/SurfaceMaps.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Core>

namespace shape
{

/// Computes the wave kernels from landmarks (ComputeWaveKernelFrom), `energies` of each. Of more
/// than 12 landmarks, such as along curves, 12 evenly chosen ones are used: they contain as much
/// information. which: the column of the landmarks, 0 or 1. Returns n x (energies * landmarks
/// used).
Eigen::MatrixXd ComputeLandmarkKernels(
  const LaplaceEigenpairs& spectrum, const Landmarks& landmarks, int which, int energies);

} // namespace shape
