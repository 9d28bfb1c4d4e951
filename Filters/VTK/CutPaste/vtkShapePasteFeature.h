/**
 * @class   vtkShapePasteFeature
 * @brief   paste a feature on a surface with a smooth seam
 *
 * Inputs
 * - Feature: a surface with an open loop, such as the first output of vtkShapeCutFeature. That
 *   output also stores the base on which the feature stood. If no base is stored, the hole at the
 *   loop is filled (shape::FillHole), and the feature stands on the fill. Away from the loop, the
 *   feature may be non-manifold.
 * - Target: an oriented 2-manifold, open or closed. Another surface, or any if BridgeGaps is on, is
 *   treated as a polygon soup (shape::SoupTarget).
 * If one of both is a point cloud (points without polygons), the result is one, too. The vertices
 * of the other input are then its points. Edges of a target that are longer than those of the
 * feature's loop are split (shape::SampleTriangles). A feature that is a point cloud has its loop
 * as a closed line, as vtkShapeCutFeature writes it. Normals are estimated if there are none. In
 * both inputs, polygons are triangulated, seams are closed (shape::WeldedSurface), and points
 * without triangles are removed.
 *
 * Output 0: the target without its covered region, a seam band, and the feature, deformed to fit.
 * It is watertight if the target is watertight and the feature has no other loop. With several
 * joined loops, .Seed, .Normal and .Direction are those of the first. Points and cells keep their
 * arrays (see vtkShapePastedData). The cell array `Part` is 0 on the target, 1 on the seam band and
 * 2 on the feature. A soup is cut along the loop instead and has no band; triangles of it near the
 * loop are split. Of point clouds, the points are joined (shape::PointTarget): `Part` is 1 on
 * points that were added on the target where the seam would be wider than the spacing. Its points
 * have normals: those of the target, given or estimated, and those of the feature, which move with
 * it (shape::MoveNormals). Other results have no normals.
 *
 * Output 1: the loop of the feature on the target, as lines. With it as the Boundary and with the
 * same properties, vtkShapeDeform deforms anything that belongs to the feature in the same way. Its
 * point arrays (double, 3) are
 * - `SourcePosition`, `SourceNormal`: the position on the feature, and the normal of its base.
 * - `TargetNormal`: the normal of the target.
 * - `FrameRotation`, with `FrameSet` (int) 1: how the bias and OptimizeNormals rotate the frames.
 *
 * Facts, with the prefix PasteFeature
 * - .Seed, .Normal, .Direction (3 numbers each): the position on the target, its normal, and the
 *   tangent from which Rotation is measured.
 * - .DeviationBefore, .DeviationAfter: median angle between the normals of feature and target at
 *   the loop, in degrees, before and after optimisation. .Deviation95Before, .Deviation95After: the
 *   95th percentile of these angles.
 * - .Refused: 1 if Dragging is on and the feature does not fit, otherwise 0. .Refusal is then the
 *   reason.
 * - .Layout: "exponential map"; "conformal" if the exponential map flips triangles at the loop; or
 *   "least distortion" if the conformal map flips triangles, too. "samples" on a soup.
 * - .Soup: 1 if the target was treated as a polygon soup. .LargestGap: then the largest distance
 *   across a gap of the seam. .JoinedShare: the share of the seam's length where feature and target
 *   have common edges; 1 if the target is a manifold.
 * - .PointCloud: 1 if the result is a point cloud. .Spacing is then the mean distance of
 *   neighbouring points of the target. .AddedPoints: number of points added at the seam.
 *   .LargestGap is the largest distance of a point at the seam from the other side.
 *   .EstimatedNormals: 1 if an input is a point cloud without normals.
 * - .Base: "where it was cut" or "own fill".
 * - .EulerNumber, .BandTriangles, .WeldedPoints (number of welded points of both inputs),
 *   .NonManifold (number of non-manifold edges and points of the feature).
 * - .Loops: number of loops along which the feature was joined.
 * - .FlippedTriangles: number of triangles of the target, below the feature, that are flipped when
 *   the target is flattened.
 *
 * Everything that depends only on the feature, or only on the target, is reused while the position
 * changes. In parallel, the first process has the result.
 *
 * The mathematics: shape::FeatureToPaste, shape::PasteTarget, shape::SoupTarget,
 * shape::PointTarget.
 */
#ifndef vtkShapePasteFeature_h
#define vtkShapePasteFeature_h

#include "vtkShapeDeformingAlgorithm.h"

#include "CutPaste/PasteFeature.h" // for the options

#include <memory> // for what is kept

class vtkPolyData;

class VTKSHAPEFILTERS_EXPORT vtkShapePasteFeature : public vtkShapeDeformingAlgorithm
{
public:
  static vtkShapePasteFeature* New();
  vtkTypeMacro(vtkShapePasteFeature, vtkShapeDeformingAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapePasteFeature.xml. Enumerations and defaults:
  /// shape::PasteFeatureOptions, shape::PastePlacement, shape::JoinedLoops,
  /// shape::ExponentialMapOptions.
  vtkSetVector3Macro(Seed, double);
  vtkGetVector3Macro(Seed, double);
  vtkShapeOptionOf(Placement, Rotation, double);
  vtkShapeOptionOf(Placement, Scale, double);
  vtkShapeFieldOptions();
  vtkShapeEnumOptionOf(Joined, Loops, shape::JoinedLoops::LoopsType,
    shape::JoinedLoops::LoopsType::One, shape::JoinedLoops::LoopsType::All);
  vtkShapeOptionOf(Joined, LoopIndex, int);
  vtkShapeOptionOf(Paste, OptimizeNormals, bool);
  vtkSetMacro(BlendWidth, double);
  vtkGetMacro(BlendWidth, double);
  vtkSetMacro(BridgeGaps, bool);
  vtkGetMacro(BridgeGaps, bool);
  vtkShapeOptionOf(Paste, Dragging, bool);
  vtkShapeOptionOf(Flattening, UpwindAverage, bool);
  vtkShapeOptionOf(Flattening, NormalSmoothing, int);
  ///@}

protected:
  vtkShapePasteFeature();
  ~vtkShapePasteFeature() override;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapePasteFeature(const vtkShapePasteFeature&) = delete;
  void operator=(const vtkShapePasteFeature&) = delete;

  void PasteInto(vtkPolyData* output, vtkPolyData* loop, const shape::Progress& progress);
  void PrepareFeature(const shape::Progress& progress);
  void PrepareTarget(const shape::Progress& progress);
  double SpacingOnTarget() const;

  double Seed[3] = { 0.0, 0.0, 0.0 };
  shape::JoinedLoops Joined;
  double BlendWidth = 0.25;
  bool BridgeGaps = false;
  shape::PastePlacement Placement;
  shape::PasteFeatureOptions Paste;
  shape::ExponentialMapOptions Flattening;
  struct Kept;
  std::unique_ptr<Kept> Cache;
};

#endif
