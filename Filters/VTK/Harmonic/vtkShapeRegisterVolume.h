/**
 * @class   vtkShapeRegisterVolume
 * @brief   map a solid onto the solid inside another surface, without landmarks
 *
 * Inputs (polygons are triangulated internally)
 * - Input: the closed surface around the solid, as for vtkShapeTetrahedralize.
 * - Target: the surface that its image shall be, closed or open.
 *
 * Output 0: the Input with the point array `TargetPosition` (double, 3): where its points go. It is
 * the Boundary of a vtkShapeHarmonicVolumeMap.
 *
 * Output 1 (vtkUnstructuredGrid): the tetrahedra of the solid at their images. In parallel, the
 * first process has all of them. Points and arrays are those of vtkShapeTetrahedralize.
 * - Point array `SourcePosition` (double, 3): the position in the solid.
 *
 * Facts, with the prefix RegisterVolume
 * - .MeanDistanceBefore, .MaximumDistanceBefore, .DistortionBefore, and the same with After: as in
 *   shape::RegistrationQuality.
 * - .Iterations: number of steps. .Tetrahedra: number of them; none is inverted.
 *
 * The mathematics: shape::RegisterVolume.
 */
#ifndef vtkShapeRegisterVolume_h
#define vtkShapeRegisterVolume_h

#include "vtkShapeAlgorithm.h"

#include "Harmonic/RegisterVolume.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeRegisterVolume : public vtkShapeAlgorithm
{
public:
  static vtkShapeRegisterVolume* New();
  vtkTypeMacro(vtkShapeRegisterVolume, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeRegisterVolume.xml. Defaults:
  /// shape::RegisterVolumeOptions.
  vtkShapeOption(Align, bool);
  vtkShapeOption(DistortionWeight, double);
  vtkShapeOption(MaximumIterations, int);
  ///@}

protected:
  vtkShapeRegisterVolume();
  ~vtkShapeRegisterVolume() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeRegisterVolume(const vtkShapeRegisterVolume&) = delete;
  void operator=(const vtkShapeRegisterVolume&) = delete;

  shape::RegisterVolumeOptions Options;
};

#endif
