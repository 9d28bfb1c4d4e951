/**
 * @class   vtkShapeBoundaryDistance
 * @brief   the distance of points to a surface, negative inside the solid that it bounds
 *
 * Inputs
 * - Input: points or cells of any dataset, also composite or distributed.
 * - Surface: the surface, gathered from all its blocks and processes (polygons are triangulated
 *   inside). With Signed it is closed, of one or several components that face any way: one that
 *   lies within another bounds a void. Without Signed it may also be open.
 *
 * Output: the same data (image data stay image data) with the point array `BoundaryDistance`
 * (double, in the surface's units).
 *
 * The mathematics: shape::BoundaryDistance.
 */
#ifndef vtkShapeBoundaryDistance_h
#define vtkShapeBoundaryDistance_h

#include "vtkShapeAlgorithm.h"

#include "Distance/BoundaryDistance.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeBoundaryDistance : public vtkShapeAlgorithm
{
public:
  static vtkShapeBoundaryDistance* New();
  vtkTypeMacro(vtkShapeBoundaryDistance, vtkShapeAlgorithm);

  ///@{
  /// Negative inside the solid that the surface bounds, which must be closed; else the distance is
  /// positive everywhere. Default: on.
  vtkShapeOption(Signed, bool);
  ///@}

protected:
  vtkShapeBoundaryDistance();
  ~vtkShapeBoundaryDistance() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeBoundaryDistance(const vtkShapeBoundaryDistance&) = delete;
  void operator=(const vtkShapeBoundaryDistance&) = delete;

  shape::BoundaryDistanceOptions Options;
};

#endif
