/**
 * @class   vtkShapeDeform
 * @brief   deform a shape by its boundary or another handle, and preserve its detail
 *
 * Inputs
 * - Input: surfaces, solids, curves, polygon soups and points of any data set, which may be
 *   composite or distributed. Image data become structured grids. Coincident points move together.
 *   Cells of any type may be degenerate or non-manifold. Parts that are not connected to the handle
 *   follow the nearest connected part.
 * - Boundary: the handle at its new position: one or several curves, surfaces or points, with
 *   point arrays
 *   - `SourcePosition` (double, 3): the old position, on Input or near it. Points of Input that lie
 *     on the old handle follow it exactly.
 *   - `SourceNormal`, `TargetNormal` (double, 3; optional, both or neither): the normal of Input at
 *     the handle, before and after the deformation. Without these arrays, the frames are estimated
 *     from the old and the new handle by the same rule, which is invariant to rotation.
 *   - `FrameRotation` (double, 3; optional, with `FrameSet`): further rotations of the frames, as
 *     the axis times the angle in radians. They apply at points with a non-zero `FrameSet`. Between
 *     such points, they are interpolated along the curve.
 *
 * Output: the deformed Input with the point arrays `SourcePosition` (double, 3) and `ArrivalTime`
 * (double): when the front reached the point, as its distance from the handle along edges. If
 * SegmentBy is Protrusions, `Protrusion` (int) is the label of the part that contains the point: 0
 * next to the handle, then from the farthest tip on (shape::FindProtrusions). Normals of points
 * rotate, and normals of cells are dropped. A rigid motion of the handle moves the shape
 * rigidly. If the handle is scaled by the factor Scale, the entire shape undergoes the same
 * similarity. If the handle does not move, the shape does not change.
 *
 * Facts, with the prefix Deform
 * - .Islands: number of parts that are not connected to the handle.
 * - .EmptyBands: number of points without upwind points within UpwindRadius. .ZeroWeights: number
 *   of points whose upwind points all have weight 0.
 * - .WeldedPoints: number of points that coincide with another one. .Segments: number of connected
 *   parts with the same value of SegmentArray or `Protrusion`.
 * - .BasePoints: number of points of the coarse shape, or 0 if no coarse shape is used.
 * - .Streamed: 1 if there are too many weights to be stored, otherwise 0. .Prepared: 1 if the
 *   weights were computed in this run, 0 if they were reused because only the new position of the
 *   handle or the frames changed.
 *
 * The mathematics: shape::Deformer, shape::ShapeDeformation.
 */
#ifndef vtkShapeDeform_h
#define vtkShapeDeform_h

#include "vtkShapeDeformingAlgorithm.h"

#include <memory> // for what is kept

namespace shape
{
class Deformer;
}

class VTKSHAPEFILTERS_EXPORT vtkShapeDeform : public vtkShapeDeformingAlgorithm
{
public:
  static vtkShapeDeform* New();
  vtkTypeMacro(vtkShapeDeform, vtkShapeDeformingAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeDeform.xml. Defaults: shape::DeformOptions.
  vtkShapeOption(Scale, double);
  vtkShapeFieldOptions();
  ///@}

protected:
  vtkShapeDeform();
  ~vtkShapeDeform() override;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeDeform(const vtkShapeDeform&) = delete;
  void operator=(const vtkShapeDeform&) = delete;

  std::unique_ptr<shape::Deformer> Deformer; ///< stores the weights
};

#endif
