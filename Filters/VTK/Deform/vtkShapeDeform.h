/**
 * @class   vtkShapeDeform
 * @brief   deforms a shape by its boundary, or another handle, with its detail kept
 *
 * Inputs
 * - Input: surfaces, solids, curves, soups and points of any dataset, also composite or distributed
 *   (image data become structured grids). Points at one place move as one; cells of any kinds may
 * be degenerate or meet in any way; parts that hang on nothing follow the nearest part.
 * - Boundary: the handle at its moved place: curves, closed or open, or a surface, or points, also
 *   several, with point arrays
 *   - `SourcePosition` (double, 3): where it was on (or near) Input. Points of Input there, at its
 *     points, on its lines and in its triangles, follow it exactly;
 *   - `SourceNormal`, `TargetNormal` (double, 3; optional, both or neither): of Input there, and of
 *     what it becomes. Without them the frames are estimated by one rule that turns with the shape;
 *   - `FrameRotation` (double, 3; optional, with FrameSet): turns of the frames, as axis times
 *     radians, set where `FrameSet` is not 0 and in between interpolated along the curve.
 *
 * Output: Input, moved; point array `SourcePosition` (double, 3): where each point was. Normals of
 * points are turned, those of cells dropped. A rigid motion of the boundary is that of the shape,
 * and where it is scaled by Scale, too, that similarity; an unmoved one leaves the shape as it is.
 *
 * Field data: Deform.Islands (parts that hang on nothing), .EmptyBands (points with nothing upwind
 * within UpwindRadius), .ZeroWeights (points upwind of which nothing has a weight), .WeldedPoints,
 * .Segments (connected parts of one value of SegmentArray), .BasePoints (of the coarse shape, 0 in
 * full), .Streamed (1 where the weights are too many to be kept), .Prepared (1 where the weights
 * were found in this run, 0 where only the boundary's target or the frames had changed).
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
  /// A point array of Input that multiplies Rigidity, >= 0; "None". Default: None.
  vtkSetStdStringFromCharMacro(RigidityArray);
  vtkGetCharFromStdStringMacro(RigidityArray);
  ///@}
  ///@{
  /// Of the offsets of points from those upwind; > 0. Default: 1.
  vtkShapeOption(Scale, double);
  ///@}
  ///@{
  /// A point array of Input that multiplies Scale, >= 0; "None". Default: None.
  vtkSetStdStringFromCharMacro(ScaleArray);
  vtkGetCharFromStdStringMacro(ScaleArray);
  ///@}
  ///@{
  /// A direction that the normals of the boundary's frames are drawn to. Default: (0, 0, 1).
  vtkShapeVectorOptionOf(Frames, BiasFrame);
  ///@}
  ///@{
  /// By which share of the angle; in [0, 1]. Default: 0.
  vtkShapeOptionOf(Frames, BiasWeight, double);
  ///@}
  ///@{
  /// A point or cell array of Input whose parts of one value follow one after the other; "None".
  /// Default: None.
  vtkSetStdStringFromCharMacro(SegmentArray);
  vtkGetCharFromStdStringMacro(SegmentArray);
  ///@}
  ///@{
  /// Afterwards, which spreads the distortion evenly. Default: off.
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
  std::unique_ptr<shape::Deformer> Deformer; ///< keeps the weights
};

#endif
