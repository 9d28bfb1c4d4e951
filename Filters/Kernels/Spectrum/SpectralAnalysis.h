#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Spectrum/LaplaceSpectrum.h"

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
  int NumberOfEigenpairs =
    100; ///< the least, with those of the constants; see SolveLaplaceEigenproblem
  EmbeddingType Embedding = EmbeddingType::Spectral;
  int EmbeddingDimensions = 3; ///< >= 1
};

struct SpectralAnalysis
{
  LaplaceSpectrum Spectrum;
  Eigen::MatrixXd HeatKernel; ///< n x 100: HeatKernelSignature
  Eigen::MatrixXd WaveKernel; ///< n x 100: WaveKernelSignature
  Eigen::MatrixXd Embedding;  ///< n x EmbeddingDimensions
};

/**
 * The spectrum of a surface and what is made of it.
 *
 * mesh: a consistently oriented 2-manifold, open or closed; for MDS of one component. Throws
 * InvalidInput where not, or an option is out of range or asks for more eigenpairs than there are;
 * SolveFailure, Aborted.
 */
SpectralAnalysis ComputeLaplaceSpectrum(
  const Mesh& mesh, const LaplaceSpectrumOptions& options = {}, const Progress& progress = {});

} // namespace shape
