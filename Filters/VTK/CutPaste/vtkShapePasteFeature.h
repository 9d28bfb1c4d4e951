/**
 * @class   vtkShapePasteFeature
 * @brief   sets a feature down on a surface: smoothly joined, one manifold
 *
 * Inputs
 * - Feature: triangles around an open loop, such as the first output of vtkShapeCutFeature, whose
 *   arrays `LoopCoordinates` and `LoopNormal` and field data CutFeature.SeedNormal and
 *   CutFeature.SeedDirection say how it stood. Of a feature without them the hole at its loop is
 *   filled (shape::FillHole), and it stands on that. What is not at the loop may hang together in
 *   any way.
 * - Target: an oriented 2-manifold, open or closed.
 * Of both, polygons are cut into triangles, seams are closed (shape::WeldedSurface), and points
 * that no triangle uses are left out.
 *
 * Output: the target without what the feature covers, a band of triangles, and the feature,
 * deformed to stand on the target: watertight where the target is and the feature has no other
 * loop. Points and cells keep their arrays (see vtkShapePastedData); the cell array `Part` is 0 on
 * the target, 1 on the band, 2 on the feature. Field data:
 * - PasteFeature.Seed, .Normal, .Direction (3 numbers each): the place on the target, its normal,
 *   and the tangent there that Rotation is counted from;
 * - PasteFeature.DeviationBefore, .DeviationAfter: degrees between the normals of the feature and
 *   those of the target at the loop, the median before and after they were optimised;
 *   .Deviation95Before and .Deviation95After, the 95th percentile;
 * - PasteFeature.Refused: 1 while Dragging where the feature does not fit, and .Refusal, why; else
 * 0;
 * - PasteFeature.Layout: "exponential map", "conformal" where that flips triangles at the loop, or
 *   "least distortion" where the conformal map does, too;
 * - PasteFeature.Base: "where it was cut" or "own fill"; .EulerNumber, .BandTriangles,
 *   .WeldedPoints (of both inputs), .NonManifold (edges and points of the feature);
 *   .FlippedTriangles: those of the target under the feature that its layout in the plane flips.
 *
 * What depends on the feature alone, or on the target alone, is kept while only the place changes.
 * In parallel the result is on the first process.
 *
 * The mathematics: shape::FeatureToPaste, shape::PasteTarget.
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
  /// Where the middle of the feature goes: the closest place of the target. Default: the origin.
  vtkSetVector3Macro(Seed, double);
  vtkGetVector3Macro(Seed, double);
  ///@}
  ///@{
  /// Degrees, about the target's normal at the seed. Default: 0.
  vtkShapeOptionOf(Placement, Rotation, double);
  ///@}
  ///@{
  /// How much larger the feature becomes. > 0. Default: 1.
  vtkShapeOptionOf(Placement, Scale, double);
  ///@}
  ///@{
  /// Which of the feature's open loops is joined, the longest being 0. Default: 0.
  vtkSetMacro(LoopIndex, int);
  vtkGetMacro(LoopIndex, int);
  ///@}
  ///@{
  /// Whether the frames at the loop are turned until feature and target meet smoothly. Default: on.
  vtkShapeOptionOf(Paste, OptimizeNormals, bool);
  ///@}
  ///@{
  /// How far into the feature, as a share of its depth, its point data are blended with the
  /// target's. 0: not at all. Default: 0.25.
  vtkSetMacro(BlendWidth, double);
  vtkGetMacro(BlendWidth, double);
  ///@}
  ///@{
  /// While the feature is being dragged: one angle for all frames of the loop, and the result is
  /// not checked. Default: off.
  vtkShapeOptionOf(Paste, Dragging, bool);
  ///@}

protected:
  vtkShapePasteFeature();
  ~vtkShapePasteFeature() override;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapePasteFeature(const vtkShapePasteFeature&) = delete;
  void operator=(const vtkShapePasteFeature&) = delete;

  void PasteInto(vtkPolyData* output, const shape::Progress& progress);
  void PrepareFeature(const shape::Progress& progress);
  void PrepareTarget(const shape::Progress& progress);

  double Seed[3] = { 0.0, 0.0, 0.0 };
  int LoopIndex = 0;
  double BlendWidth = 0.25;
  shape::PastePlacement Placement;
  shape::PasteFeatureOptions Paste;
  struct Kept;
  std::unique_ptr<Kept> Cache;
};

#endif
