#include "Spectrum/SpectralAnalysis.h"

#include "Base/Errors.h"
#include "Spectrum/Private/ClassicalScaling.h"
#include "Spectrum/SpectralSignatures.h"

namespace shape
{

SpectralAnalysis AnalyseSpectrum(
  const Mesh& mesh, const LaplaceSpectrumOptions& options, const Progress& progress)
{
  RequireOption(options.EmbeddingDimensions >= 1, "EmbeddingDimensions",
    options.EmbeddingDimensions, "at least 1");
  const bool isSpectral = options.Embedding == LaplaceSpectrumOptions::EmbeddingType::Spectral;
  const double share = isSpectral ? 0.9 : 0.5; // of the time
  SpectralAnalysis analysis;
  analysis.Spectrum =
    FindLaplaceSpectrum(mesh, options.NumberOfEigenpairs, progress.Part(0.0, share));
  if (isSpectral) // first: it asks for most eigenpairs
  {
    analysis.Embedding = SpectralEmbedding(analysis.Spectrum, options.EmbeddingDimensions);
  }
  analysis.HeatKernel = HeatKernelSignature(analysis.Spectrum);
  analysis.WaveKernel = WaveKernelSignature(analysis.Spectrum);
  if (!isSpectral)
  {
    constexpr int samples = 500;
    analysis.Embedding =
      ClassicalScaling(mesh, options.EmbeddingDimensions, samples, progress.Part(share, 1.0));
  }
  progress(1.0);
  return analysis;
}

} // namespace shape
