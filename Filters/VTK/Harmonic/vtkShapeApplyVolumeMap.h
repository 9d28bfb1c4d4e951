/**
 * @class   vtkShapeApplyVolumeMap
 * @brief   moves any dataset by a volume map that is kept as a charge set, or by its inverse
 *
 * The map f(y) = A y + b + sum_j Charge_j / (4 pi |y - x_j|) is evaluated at every point inside the
 * surface that bounds its domain: for a map of Shape Harmonic Volume Map the result is, bit for
 * bit, that filter's first output. The inverse finds for every point y of the input the x in the
 * domain with f(x) = y, by Newton's method with the analytic derivative. Where f folds, a point has
 * several preimages: one of them is found, always the same.
 *
 * Inputs
 * - Input: what is moved: points or cells of any dataset, also composite or distributed.
 * - Map: one charge set: points with `Charge` (double, 3), field data `Affine` (3 tuples of 4), and
 *   as cells the closed surface that bounds the domain, at whose points there is no charge. That of
 *   a map of several layers has `RegionId` (int) at its points, and a tuple of 12 in `Affine` for
 *   each region: a point is moved by the charges and the affine part of the region that it lies in
 *   (Exact of vtkShapeHarmonicVolumeMap).
 *
 * Output
 * - 0: the input moved, with `SourcePosition` (double, 3). Points that are not moved keep their
 *   place, and `OutsideDomain` says why: 1 = outside the map's domain (Inverse: outside its image),
 *   2 = Inverse: inside the image of the domain's boundary, but no preimage was found. Point
 *   normals are dropped.
 *
 * Field data: ApplyVolumeMap.OutsidePoints and ApplyVolumeMap.NotInverted count the points with 1
 * and with 2 (over all processes, without ghosts).
 *
 * The mathematics: shape::ApplyVolumeMap, shape::PiecewiseInverseMap.
 */
#ifndef vtkShapeApplyVolumeMap_h
#define vtkShapeApplyVolumeMap_h

#include "vtkShapeAlgorithm.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeApplyVolumeMap : public vtkShapeAlgorithm
{
public:
  static vtkShapeApplyVolumeMap* New();
  vtkTypeMacro(vtkShapeApplyVolumeMap, vtkShapeAlgorithm);

  ///@{
  /// Whether points go back to where the map takes them from. Default: false.
  vtkSetMacro(Inverse, bool);
  vtkGetMacro(Inverse, bool);
  vtkBooleanMacro(Inverse, bool);
  ///@}

protected:
  vtkShapeApplyVolumeMap();
  ~vtkShapeApplyVolumeMap() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeApplyVolumeMap(const vtkShapeApplyVolumeMap&) = delete;
  void operator=(const vtkShapeApplyVolumeMap&) = delete;

  bool Inverse = false;
};

#endif
