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
  /// Number of eigenpairs with the smallest eigenvalues, constant eigenfunctions included; see
  /// SolveLaplaceEigenproblem.
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
 * surface: triangles (RequireTriangles); for MDS a consistently oriented 2-manifold with one
 * component. Throws InvalidInput if the surface does not meet these conditions, if an option is out
 * of range, or if there are fewer eigenpairs than requested. Throws SolveFailure and Aborted.
 */
LaplaceSpectrumResult ComputeLaplaceSpectrum(const Surface& surface,
  const LaplaceSpectrumOptions& options = {}, const Progress& progress = {});

} // namespace shape
