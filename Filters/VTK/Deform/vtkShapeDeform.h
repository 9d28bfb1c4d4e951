/**
 * @class   vtkShapeDeform
 * @brief   deform a shape by its boundary or another handle, and preserve its detail
 *
 * Inputs
 * - Input: surfaces, solids, curves, polygon soups and points of any data set, also composite or
 *   distributed. Image data become structured grids. Coincident points move as one. Cells of any
 *   type may be degenerate or non-manifold. Parts that are not connected to the handle follow the
 *   nearest part.
 * - Boundary: the handle at its new position: one or several curves, surfaces or points, with
 *   point arrays
 *   - `SourcePosition` (double, 3): the old position, on Input or near it. Points of Input at its
 *     points, on its lines and in its triangles follow it exactly.
 *   - `SourceNormal`, `TargetNormal` (double, 3; optional, both or neither): the normal of Input
 *     there, and its image. Without them the frames are estimated by one rule that rotates with
 *     the shape.
 *   - `FrameRotation` (double, 3; optional, with `FrameSet`): rotations of the frames as axis
 *     times radians. They apply at points with a non-zero `FrameSet` and are interpolated along the
 *     curve in between.
 *
 * Output: the deformed Input with the point array `SourcePosition` (double, 3). Normals of points
 * rotate, and normals of cells are dropped. A rigid motion of the handle moves the shape rigidly.
 * If the handle is scaled by Scale, the shape follows that similarity. A handle at rest leaves the
 * shape unchanged.
 *
 * Field data, with the prefix Deform
 * - .Islands: parts that are not connected to the handle.
 * - .EmptyBands: points without upwind points within UpwindRadius. .ZeroWeights: points whose
 *   upwind points all have weight 0.
 * - .WeldedPoints. .Segments: connected parts of one value of SegmentArray.
 * - .BasePoints: points of the coarse shape, 0 if none is used.
 * - .Streamed: 1 if the weights are too many to be stored. .Prepared: 1 if the weights were
 *   computed in this run, 0 if only the handle's new position or the frames changed.
 *
 * The mathematics: shape::Deformer, shape::ShapeDeformation.
 */
#ifndef vtkShapeDeform_h
#define vtkShapeDeform_h

#include "vtkShapeDeformingAlgorithm.h"

#include "Deform/HandleFrames.h" // for the options

#include <memory> // for what is kept
#include <string> // for array names

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
  /// The properties. Effects and ranges: vtkShapeDeform.xml. Enumerations and defaults:
  /// shape::PoseOptions.
  vtkSetStdStringFromCharMacro(RigidityArray);
  vtkGetCharFromStdStringMacro(RigidityArray);
  vtkShapeOption(Scale, double);
  vtkSetStdStringFromCharMacro(ScaleArray);
  vtkGetCharFromStdStringMacro(ScaleArray);
  vtkShapeVectorOptionOf(Frames, BiasFrame);
  vtkShapeOptionOf(Frames, BiasWeight, double);
  vtkSetStdStringFromCharMacro(SegmentArray);
  vtkGetCharFromStdStringMacro(SegmentArray);
  vtkShapeOption(LaplacianSmoothing, bool);
  ///@}

protected:
  vtkShapeDeform();
  ~vtkShapeDeform() override;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeDeform(const vtkShapeDeform&) = delete;
  void operator=(const vtkShapeDeform&) = delete;

  std::string RigidityArray = "None", ScaleArray = "None", SegmentArray = "None";
  shape::PoseOptions Frames;
  std::unique_ptr<shape::Deformer> Deformer; ///< stores the weights
};

#endif
