/**
 * @class   vtkShapeLaplaceSpectrum
 * @brief   eigenfunctions of a surface's Laplacian, and what is made of them
 *
 * Input: an oriented 2-manifold, open or closed, of any number of components (polygons are
 * triangulated inside). Blocks and distributed pieces are joined first; each process gets its own
 * back.
 *
 * Output: the same surface with the point arrays `Eigenfunctions` (double, one component for each
 * eigenpair; orthonormal in the areas around points), `HeatKernelSignature` and
 * `WaveKernelSignature` (double, 100 components; their mean over the surface is 1) and `Embedding`
 * (double, EmbeddingDimensions components; MDS: in the surface's units), all 0 at points without a
 * triangle. Field data: LaplaceSpectrum.Eigenvalues, ascending, in 1 / length^2.
 *
 * Each factorisation, and each decomposition of a surface with few points for the number of
 * eigenpairs, is one library call: an abort takes effect at its end.
 *
 * The mathematics: shape::ComputeLaplaceSpectrum, shape::SolveLaplaceEigenproblem.
 */
#ifndef vtkShapeLaplaceSpectrum_h
#define vtkShapeLaplaceSpectrum_h

#include "vtkShapeAlgorithm.h"

#include "Spectrum/SpectralAnalysis.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeLaplaceSpectrum : public vtkShapeAlgorithm
{
public:
  static vtkShapeLaplaceSpectrum* New();
  vtkTypeMacro(vtkShapeLaplaceSpectrum, vtkShapeAlgorithm);

  ///@{
  /// How many of the least eigenvalues are looked for, one 0 for each component among them.
  /// Default: 100.
  vtkShapeOption(NumberOfEigenpairs, int);
  ///@}

  ///@{
  /// 0 = Spectral: eigenfunctions over the roots of their eigenvalues (Rustamov 2007). 1 = MDS:
  /// straight distances are near to geodesic ones. Default: Spectral.
  vtkShapeEnumOption(Embedding, shape::LaplaceSpectrumOptions::EmbeddingType,
    shape::LaplaceSpectrumOptions::EmbeddingType::Spectral,
    shape::LaplaceSpectrumOptions::EmbeddingType::MDS);
  ///@}

  ///@{
  /// Components of `Embedding`. Default: 3.
  vtkShapeOption(EmbeddingDimensions, int);
  ///@}

protected:
  vtkShapeLaplaceSpectrum();
  ~vtkShapeLaplaceSpectrum() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeLaplaceSpectrum(const vtkShapeLaplaceSpectrum&) = delete;
  void operator=(const vtkShapeLaplaceSpectrum&) = delete;

  shape::LaplaceSpectrumOptions Options;
};

#endif
