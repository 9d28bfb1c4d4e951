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
  /// The smallest ones, those of the constants included; see SolveLaplaceEigenproblem.
  int NumberOfEigenpairs = 100;
  EmbeddingType Embedding = EmbeddingType::Spectral;
  int EmbeddingDimensions = 3; ///< >= 1
};

struct LaplaceSpectrumResult
{
  LaplaceEigenpairs Spectrum;
  Eigen::MatrixXd HeatKernel; ///< n x 100: HeatKernelSignature
  Eigen::MatrixXd WaveKernel; ///< n x 100: WaveKernelSignature
  Eigen::MatrixXd Embedding;  ///< n x EmbeddingDimensions
};

/**
 * The spectrum of a surface, its signatures and an embedding.
 *
 * surface: a consistently oriented 2-manifold, open or closed; for MDS of one component. Throws
 * InvalidInput if it is not, or if an option is out of range or asks for more eigenpairs than there
 * are; SolveFailure, Aborted.
 */
LaplaceSpectrumResult ComputeLaplaceSpectrum(const Surface& surface,
  const LaplaceSpectrumOptions& options = {}, const Progress& progress = {});

} // namespace shape
