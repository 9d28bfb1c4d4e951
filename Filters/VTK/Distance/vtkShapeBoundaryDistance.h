/**
 * @class   vtkShapeBoundaryDistance
 * @brief   compute the distance of points to a surface, negative inside the solid that it bounds
 *
 * Inputs
 * - Input: points or cells of any data set, also composite or distributed.
 * - Surface: gathered from all its blocks and processes. Polygons are triangulated internally.
 *   With Signed it is closed, with one or several components of any orientation. A component
 *   inside another one bounds a void. Without Signed it may be open.
 *
 * Output: the same data (image data stay image data) with the point array `BoundaryDistance`
 * (double, in the units of the surface).
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
  /// The properties. Effects and ranges: vtkShapeBoundaryDistance.xml. Enumerations and defaults:
  /// shape::BoundaryDistanceOptions.
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
