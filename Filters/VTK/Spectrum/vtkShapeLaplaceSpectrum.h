/**
 * @class   vtkShapeLaplaceSpectrum
 * @brief   compute eigenfunctions, spectral signatures and an embedding of a surface
 *
 * Input: an oriented 2-manifold, open or closed, of any number of components. Polygons are
 * triangulated internally. Blocks and distributed pieces are joined first, and each process gets
 * its own pieces back.
 *
 * Output: the same surface with these point arrays, which are 0 at points without a triangle:
 * - `Eigenfunctions` (double, one component for each eigenpair): orthonormal in the inner product
 *   weighted by the area around each point.
 * - `HeatKernelSignature`, `WaveKernelSignature` (double, 100 components): the mean of each
 *   component over the surface is 1.
 * - `Embedding` (double, EmbeddingDimensions components): coordinates of the point; for MDS, in the
 *   units of the surface.
 *
 * Field data: LaplaceSpectrum.Eigenvalues, ascending, in 1 / length^2.
 *
 * The mathematics: shape::ComputeLaplaceSpectrum, shape::SolveLaplaceEigenproblem.
 */
#ifndef vtkShapeLaplaceSpectrum_h
#define vtkShapeLaplaceSpectrum_h

#include "vtkShapeAlgorithm.h"

#include "Spectrum/LaplaceSpectrum.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeLaplaceSpectrum : public vtkShapeAlgorithm
{
public:
  static vtkShapeLaplaceSpectrum* New();
  vtkTypeMacro(vtkShapeLaplaceSpectrum, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeLaplaceSpectrum.xml. Enumerations and defaults:
  /// shape::LaplaceSpectrumOptions.
  vtkShapeOption(NumberOfEigenpairs, int);
  vtkShapeEnumOption(Embedding, shape::LaplaceSpectrumOptions::EmbeddingType,
    shape::LaplaceSpectrumOptions::EmbeddingType::Spectral,
    shape::LaplaceSpectrumOptions::EmbeddingType::MDS);
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
