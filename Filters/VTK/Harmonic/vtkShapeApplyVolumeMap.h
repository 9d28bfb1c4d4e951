/**
 * @class   vtkShapeApplyVolumeMap
 * @brief   move any data set by a volume map that is stored as a charge set, or by its inverse
 *
 * The map f(y) = A y + b + sum_j Charge_j / (4 pi |y - x_j|) is evaluated at each point inside the
 * surface that bounds its domain. For a map of vtkShapeHarmonicVolumeMap the result is bit for bit
 * its first output. The inverse finds for each point y the x in the domain with f(x) = y, by
 * Newton's method with the analytic derivative. Where f folds, a point has several preimages, of
 * which the same one is always found.
 *
 * Inputs
 * - Input: points or cells of any data set, also composite or distributed.
 * - Map: one charge set. It consists of points with `Charge` (double, 3), field data `Affine` (3
 *   tuples of 4), and as cells the closed surface that bounds the domain, whose points have no
 *   charge. For several layers (Exact of vtkShapeHarmonicVolumeMap), `RegionId` (int) is at the
 *   points and `Affine` has a tuple of 12 for each region. A point is then moved by the charges
 *   and the affine part of the region that contains it.
 *
 * Output: the input moved, without point normals, with the point arrays
 * - `SourcePosition` (double, 3).
 * - `OutsideDomain`: 0 if the point moved. 1: outside the domain of the map, or for Inverse
 *   outside its image. 2, for Inverse: inside the image of the domain's boundary, but no preimage
 *   was found. Points with 1 and 2 keep their position.
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
  /// The properties. Effects and ranges: vtkShapeApplyVolumeMap.xml.
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
