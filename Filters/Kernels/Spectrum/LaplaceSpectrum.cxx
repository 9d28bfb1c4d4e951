#include "Spectrum/LaplaceSpectrum.h"

#include "Base/Errors.h"
#include "Spectrum/Private/ClassicalMds.h"
#include "Spectrum/SpectralSignatures.h"

namespace shape
{

LaplaceSpectrumResult ComputeLaplaceSpectrum(
  const Surface& surface, const LaplaceSpectrumOptions& options, const Progress& progress)
{
  RequireOption(options.EmbeddingDimensions >= 1, "EmbeddingDimensions",
    options.EmbeddingDimensions, "at least 1");
  const bool isSpectral = options.Embedding == LaplaceSpectrumOptions::EmbeddingType::Spectral;
  const double share = isSpectral ? 0.97 : 0.5; // share of the time
  LaplaceSpectrumResult analysis;
  analysis.Spectrum = SolveLaplaceEigenproblem(
    surface, options.NumberOfEigenpairs, progress.Part(0.0, share, "computing the eigenfunctions"));
  if (isSpectral) // comes first, because it needs the most eigenpairs
  {
    analysis.Embedding = ComputeSpectralEmbedding(analysis.Spectrum, options.EmbeddingDimensions);
  }
  analysis.HeatKernel = ComputeHeatKernelSignature(analysis.Spectrum);
  progress(share);
  analysis.WaveKernel = ComputeWaveKernelSignature(analysis.Spectrum);
  if (!isSpectral)
  {
    // The default of EmbedByClassicalMds.
    constexpr int samples = 500;
    analysis.Embedding = EmbedByClassicalMds(surface, options.EmbeddingDimensions, samples,
      progress.Part(share, 1.0, "embedding the surface"));
  }
  progress(1.0);
  return analysis;
}

} // namespace shape
