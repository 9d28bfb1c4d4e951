/**
 * @class   vtkShapeCertificate
 * @brief   prove that a volume map folds nowhere, or show where it does
 *
 * Inputs
 * - Map: a charge set with one region, such as the output Charges of vtkShapeHarmonicVolumeMap
 *   without Exact. vtkShapeApplyVolumeMap describes its arrays.
 * - Domain (optional): the closed surface of the solid to examine, within the domain of the Map. It
 *   may be composite or distributed. Without it, the whole domain of the Map is examined.
 *
 * Outputs. In parallel, the first process has all of them.
 * - Boxes (vtkUnstructuredGrid): voxels that cover the solid, with these cell arrays.
 *   - `Certified` (int): 1 certified, 0 undecided, -1 inverted.
 *   - `VolumeInside` (double): the volume of the part of the box inside the solid.
 *   - `MinimumDeterminant` (double): a lower bound in a certified box. In an inverted box, it is
 * the determinant at its witness; in an undecided box, 0.
 * - Witnesses (vtkPolyData): a vertex for each position in the solid where the determinant is not
 *   positive, with the point arrays `Determinant` (double) and `TargetPosition` (double, 3), the
 *   image. There is at most one in each inverted box.
 *
 * Facts: Certificate.Certified, .Undecided and .Inverted, shares of the volume; .Bijective (1 or
 * 0); .BoundaryCrossings; .Witnesses, .Boxes (of the output), .ExaminedBoxes. The fact
 * .BoundaryReversed is 1 if the image of the boundary faces inwards as a whole, else 0.
 *
 * The mathematics: shape::CertifyMap.
 */
#ifndef vtkShapeCertificate_h
#define vtkShapeCertificate_h

#include "vtkShapeAlgorithm.h"

#include "Harmonic/Certificate.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeCertificate : public vtkShapeAlgorithm
{
public:
  static vtkShapeCertificate* New();
  vtkTypeMacro(vtkShapeCertificate, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeCertificate.xml. Defaults:
  /// shape::MapCertificateOptions.
  vtkShapeOption(Tolerance, double);
  vtkShapeOption(MaximumBoxes, int);
  ///@}

protected:
  vtkShapeCertificate();
  ~vtkShapeCertificate() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeCertificate(const vtkShapeCertificate&) = delete;
  void operator=(const vtkShapeCertificate&) = delete;

  shape::MapCertificateOptions Options;
};

#endif
