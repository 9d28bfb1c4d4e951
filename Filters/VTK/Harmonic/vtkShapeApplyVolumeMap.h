/**
 * @class   vtkShapeApplyVolumeMap
 * @brief   move any data set by a volume map that is stored as a charge set, or by its inverse
 *
 * The map f(y) = A y + b + sum_j Charge_j / (4 pi |y - x_j|) is evaluated at each point inside the
 * surface that bounds its domain. For a map of vtkShapeHarmonicVolumeMap without FoldFree, the
 * result is the same as its first output, bit for bit. The inverse finds for each point y a point x
 * of the domain with f(x) = y, by Newton's method with the analytic derivative. Where f folds, y
 * has several preimages, and the same one is always found.
 *
 * Inputs
 * - Input: any data set, which may be composite or distributed.
 * - Map: one charge set. It has the point array `Charge` (double, 3 components) and the field data
 *   array `Affine` (3 tuples of 4 components). Its cells are the closed surface that bounds the
 *   domain; the points of this surface have charge 0. If the map has several layers (Exact of
 *   vtkShapeHarmonicVolumeMap), it also has the point array `RegionId` (int), and `Affine` has one
 *   tuple of 12 components for each region. A point is then moved by the charges and the affine
 *   part of the region that contains it.
 *   A map of finite elements (vtkShapeFiniteElements) has the field data array `Tetrahedra` instead
 *   of `Affine`, and is linear in each tetrahedron. So is its inverse in the images of the
 *   tetrahedra, which needs no search by Newton's method.
 *
 * Output: the input moved, without point normals, with the point arrays
 * - `SourcePosition` (double, 3).
 * - `OutsideDomain` (int): 0 if the point moved. It is 1 if the point is outside the domain or,
 *   with Inverse, outside the image of the domain. It is 2 if the point is inside this image, but
 *   no preimage was found. Points with the values 1 and 2 keep their position.
 *
 * Facts: ApplyVolumeMap.OutsidePoints and ApplyVolumeMap.NotInverted, the numbers of points
 * with the values 1 and 2 (over all processes, without ghosts).
 *
 * The mathematics: shape::ApplyVolumeMap, shape::PiecewiseInverseMap, shape::FiniteElementMap.
 */
#ifndef vtkShapeApplyVolumeMap_h
#define vtkShapeApplyVolumeMap_h

#include "vtkShapeAlgorithm.h"

#include "Fmm/SumDevice.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeApplyVolumeMap : public vtkShapeAlgorithm
{
public:
  static vtkShapeApplyVolumeMap* New();
  vtkTypeMacro(vtkShapeApplyVolumeMap, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeApplyVolumeMap.xml.
  vtkSetMacro(Inverse, bool);
  vtkGetMacro(Inverse, bool);
  vtkBooleanMacro(Inverse, bool);
  vtkShapeEnumOptionAs(Device.Kind, Device, shape::SumDevice::KindType,
    shape::SumDevice::KindType::Automatic, shape::SumDevice::KindType::OpenCL);
  ///@}

protected:
  vtkShapeApplyVolumeMap();
  ~vtkShapeApplyVolumeMap() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeApplyVolumeMap(const vtkShapeApplyVolumeMap&) = delete;
  void operator=(const vtkShapeApplyVolumeMap&) = delete;

  bool Inverse = false;
  shape::SumDevice Device;
};

#endif
