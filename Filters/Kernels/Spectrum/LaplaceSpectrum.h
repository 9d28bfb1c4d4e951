#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Core>

namespace shape
{

struct LaplaceSpectrumOptions
{
  enum class EmbeddingType
  {
    Spectral, ///< ComputeSpectralEmbedding
    MDS       ///< EmbedByClassicalMds
  };
  /// Number of smallest eigenpairs, including the constants; see SolveLaplaceEigenproblem.
  int NumberOfEigenpairs = 100;
  EmbeddingType Embedding = EmbeddingType::Spectral;
  int EmbeddingDimensions = 3; ///< >= 1
};

struct LaplaceSpectrumResult
{
  LaplaceEigenpairs Spectrum;
  Eigen::MatrixXd HeatKernel; ///< n x 100: ComputeHeatKernelSignature
  Eigen::MatrixXd WaveKernel; ///< n x 100: ComputeWaveKernelSignature
  Eigen::MatrixXd Embedding;  ///< n x EmbeddingDimensions
};

/**
 * Computes the spectrum of a surface, its signatures and an embedding.
 *
 * surface: a consistently oriented 2-manifold, open or closed; for MDS with one component. Throws
 * InvalidInput if it is not, if an option is out of range, or if it has fewer eigenpairs than
 * requested; SolveFailure, Aborted.
 */
LaplaceSpectrumResult ComputeLaplaceSpectrum(const Surface& surface,
  const LaplaceSpectrumOptions& options = {}, const Progress& progress = {});

} // namespace shape
