/**
 * @class   vtkShapeBoundaryDistance
 * @brief   compute the distance of points to a surface, negative inside the solid that it bounds
 *
 * Inputs
 * - Input: any data set, which may be composite or distributed.
 * - Surface: a surface, gathered from all blocks and processes. Polygons are triangulated
 *   internally. If Signed is on, Surface must be closed. It may have several components, of any
 *   orientation, and a component inside another component bounds a void. If Signed is off, Surface
 *   may be open.
 *
 * Output: a data set like Input, of the same type, with the additional point array
 * `BoundaryDistance` (double, in the units of Surface).
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
