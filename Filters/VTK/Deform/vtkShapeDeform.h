/**
 * @class   vtkShapeDeform
 * @brief   deform a shape by its boundary or another handle, and preserve its detail
 *
 * Inputs
 * - Input: surfaces, solids, curves, polygon soups and points of any data set, which may be
 *   composite or distributed. Image data become structured grids. Coincident points move together.
 *   Cells of any type may be degenerate or non-manifold. Parts that are not connected to the handle
 *   follow the nearest connected part.
 * - Boundary (optional): the handle: one or several curves, surfaces or points. Without this input,
 *   the handle is the boundary curves of the surface cells of Input. Point arrays, all optional:
 *   - `SourcePosition` (double, 3): the old position, on Input or near it. The handle is then at
 *     its new position. Without this array, the handle is at rest and lies on Input. Points of
 *     Input that lie on the old handle follow it exactly.
 *   - `SourceNormal`, `TargetNormal` (double, 3; both or neither): the normal of Input at the
 *     handle, before and after the deformation. Without these arrays, the frames are estimated from
 *     the old and the new handle by the same rule, which is invariant to rotation.
 *   - `FrameRotation` (double, 3; with `FrameSet`): further rotations of the frames, as the axis
 *     times the angle in radians. They apply at points with a non-zero `FrameSet`. Between such
 *     points, they are interpolated along the curve.
 *
 * The motion of the handle by properties follows that of its arrays. Rotations are the axis times
 * the angle in degrees.
 * - HandleMotions: eight numbers for each motion: the part of the handle, a translation (3), a
 *   rotation (3) and a scale. It is a similarity about the centre of the part. Parts are the
 *   connected components of the handle; part 0 is the longest.
 * - FrameRotations: six numbers for each frame: a position (3) and a rotation (3) of the frame at
 *   the closest point of the handle at rest. They are interpolated like `FrameRotation`. A frame
 *   moves with its part.
 *
 * Outputs
 * - Deformed: Input with the point arrays `SourcePosition` (double, 3) and `ArrivalTime` (double):
 *   when the front reached the point, as its distance from the handle along edges. If SegmentBy is
 *   Protrusions, `Protrusion` (int) is the label of the part that contains the point: 0 next to the
 *   handle, then from the farthest tip on (shape::FindProtrusions). Normals of points rotate, and
 *   normals of cells are dropped. A rigid motion of the handle moves the shape rigidly. If the
 *   handle is scaled by the factor Scale, the entire shape undergoes the same similarity. If the
 *   handle does not move, the shape does not change.
 * - Handle: the handle at its target, on the first process. Its point arrays are `SourcePosition`,
 *   `SourceNormal` and `TargetNormal` (double, 3), `Part` (int) and `FrameTurn` (double, 3).
 *   FrameTurn is the rotation that FrameRotations adds at each point, in degrees. The
 *   output carries the point data of Boundary or, without this input, of Input.
 *
 * Facts, with the prefix Deform
 * - .Parts: number of parts of the handle.
 * - .Islands: number of parts of the shape that are not connected to the handle.
 * - .EmptyBands: number of points without upwind points within UpwindRadius. .ZeroWeights: number
 *   of points whose upwind points all have weight 0.
 * - .WeldedPoints: number of points that coincide with another one. .Segments: number of connected
 *   parts with the same value of SegmentArray or `Protrusion`.
 * - .BasePoints: number of points of the coarse shape, or 0 if no coarse shape is used.
 * - .Streamed: 1 if there are too many weights to be stored, otherwise 0. .Prepared: 1 if the
 *   weights were computed in this run, 0 if they were reused because only the new position of the
 *   handle or the frames changed.
 *
 * The mathematics: shape::Deformer, shape::ShapeDeformation, shape::HandleMotion.
 */
#ifndef vtkShapeDeform_h
#define vtkShapeDeform_h

#include "vtkShapeDeformingAlgorithm.h"

#include <memory> // for what is kept
#include <vector> // for lists

class VTKSHAPEFILTERS_EXPORT vtkShapeDeform : public vtkShapeDeformingAlgorithm
{
public:
  static vtkShapeDeform* New();
  vtkTypeMacro(vtkShapeDeform, vtkShapeDeformingAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeDeform.xml. Defaults: shape::DeformOptions.
  vtkShapeOption(Scale, double);
  vtkShapeFieldOptions();
  void SetNumberOfHandleMotions(int count);
  void SetHandleMotions(int index, double part, double x, double y, double z, double rotationX,
    double rotationY, double rotationZ, double scale);
  std::vector<double> GetHandleMotions() { return this->HandleMotions; }
  void SetNumberOfFrameRotations(int count);
  void SetFrameRotations(
    int index, double x, double y, double z, double rotationX, double rotationY, double rotationZ);
  std::vector<double> GetFrameRotations() { return this->FrameRotations; }
  ///@}

protected:
  vtkShapeDeform();
  ~vtkShapeDeform() override;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeDeform(const vtkShapeDeform&) = delete;
  void operator=(const vtkShapeDeform&) = delete;

  std::vector<double> HandleMotions, FrameRotations;
  struct Kept;
  std::unique_ptr<Kept> Cache;
};

#endif
