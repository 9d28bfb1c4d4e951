/**
 * @class   vtkShapeCutFeature
 * @brief   cut a feature from a surface and fill the hole
 *
 * Inputs
 * - Input: a surface, open or closed, which may be non-manifold. Polygons are triangulated
 *   internally, and seams are closed (shape::WeldedSurface). Blocks and distributed pieces are
 *   joined first.
 *   Points without polygons are a point cloud (below).
 * - Loop (optional): closed curves on the surface or near it. Their points are projected to the
 *   surface and joined by locally shortest paths. If they are on parts that are not connected, the
 *   paths cross gaps that are not wider than the mean edge. Lines connected end to end, in any
 *   order, are one curve.
 * - Selection (optional): selected cells, selected points, or the output of Extract Selection (with
 *   vtkOriginalCellIds). Selected points stand for the cells whose points are all selected. Loop,
 *   Selection or LoopPoints is required. LoopPoints are the positions (x, y, z) of a closed curve.
 *
 * Outputs: 0 is the feature, and 1 is the rest of the surface with the hole filled. Both consist of
 * triangles and have all point and cell data (see vtkShapeCutParts). Triangles that the loop
 * crosses are split, and the geometry does not change.
 * - Point array `OriginalPointId` (vtkIdType): the index of the point in Input, or -1 for a new
 *   point.
 * - Cell array `Filled` (int) of the rest: 1 on the fill, otherwise 0. If KeepOriginal is on,
 *   output 1 is the unchanged Input without further arrays.
 * In parallel, the first process has both outputs.
 *
 * The feature stores its bases (shape::FeatureFootprint), one for each filled loop: the surface on
 * which it stood. With them, vtkShapePasteFeature can paste the feature back at its original
 * position. The points of these loops have two arrays, which are 0 elsewhere:
 * - `LoopCoordinates` (double, 3): u and v, the coordinates of the point in the exponential map of
 *   the filled rest around the centre of the fill. The third number is that of the loop: 0 for the
 *   longest.
 * - `LoopNormal` (double, 3): the unit normal of the filled rest.
 * - `LoopOrder` (int), if a loop crosses gaps: the number of the point in its loop, from 1.
 * The feature also has field data, which are facts, too, with the prefix CutFeature and a tuple for
 * each of these loops:
 * - .Seed (3 numbers): the origin of the exponential map.
 * - .SeedNormal, .SeedDirection (3 numbers each): the normal and the u axis of the exponential map.
 * - .ConformalRadius: 0 unless the layout is conformal.
 * - .Refined: 1 if the layout minimises distortion.
 *
 * Facts, with the prefix CutFeature
 * - .ReturnsInPlace: 1 if each loop returns to its position when it is pasted there.
 * - .Loops: number of closed loops that were cut. .LoopsLeftOut: number of ignored parts of curves
 *   that touch themselves. Only the longest part of such a curve is used.
 * - .CutLength: length of the cut. .FeatureArea: area of the feature. .WeldedPoints: number of
 *   welded points of Input. .Holes: number of filled holes.
 * - .GapsCrossed: number of gaps that the loops cross. .WidestGap: length of the loop's longest
 *   side across a gap.
 * - .Refused: 1 if Dragging is on and the loop cannot be cut, otherwise 0. .Refusal is then the
 *   reason, and the outputs are the last valid ones.
 *
 * Point clouds: if Input has no polygons, its points sample a surface, with their normals or
 * estimated ones (shape::PointCutter). The loop runs from point to point along shortest links, and
 * the outputs are vertices with normals. Both have the points of the loop. The feature has a closed
 * line through them, and so has the rest if it was not filled: with it, vtkShapeFillHoles fills the
 * hole. The points of the fill are new vertices of the rest, with `Filled` 1. Selection, SnapShare
 * and the creases are not used. Further facts:
 * - .PointCloud: 1. .Spacing: mean distance of neighbouring points. .EstimatedNormals: 1 if normals
 *   were estimated.
 *
 * If only the loop changes, everything that depends only on Input is reused.
 *
 * The mathematics: shape::CutFeature, shape::PointCutter.
 */
#ifndef vtkShapeCutFeature_h
#define vtkShapeCutFeature_h

#include "vtkShapeAlgorithm.h"

#include "CutPaste/CutFeature.h" // for the options

#include <functional> // for the facts
#include <memory>     // for what is kept
#include <vector>

class vtkPolyData;

class VTKSHAPEFILTERS_EXPORT vtkShapeCutFeature : public vtkShapeAlgorithm
{
public:
  static vtkShapeCutFeature* New();
  vtkTypeMacro(vtkShapeCutFeature, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeCutFeature.xml. Enumerations and defaults:
  /// shape::CutFeatureOptions.
  void SetNumberOfLoopPoints(int count);
  void SetLoopPoints(int index, double x, double y, double z);
  std::vector<double> GetLoopPoints() { return this->LoopPoints; }
  vtkShapeEnumOptionOf(
    Options, Side, shape::LoopSide, shape::LoopSide::Smaller, shape::LoopSide::Right);
  vtkShapeOption(LoopIndex, int);
  vtkShapeOption(FillHole, bool);
  vtkSetMacro(KeepOriginal, bool);
  vtkGetMacro(KeepOriginal, bool);
  vtkShapeOption(SnapShare, double);
  vtkShapeEnumOptionAs(Options.Fill.Method, FillMethod, shape::FillMethod,
    shape::FillMethod::Automatic, shape::FillMethod::Membrane);
  vtkShapeOptionOf(Options.Path, CreaseWeight, double);
  vtkShapeEnumOptionOf(Options.Path, Creases, shape::CreaseOptions::CreasesType,
    shape::CreaseOptions::CreasesType::Concave, shape::CreaseOptions::CreasesType::Both);
  vtkShapeOptionOf(Options.Path, CreaseReach, double);
  vtkShapeOptionOf(Options.Fill.Filler, EdgeGrowth, double);
  vtkShapeOptionOf(Options.Fill.Filler, OptimizeNormals, bool);
  vtkShapeOptionOf(Options.Fill.Deformation, Scale, double);
  vtkShapeEnumOptionOf(Options.Fill.Frames, BiasBy, shape::PoseOptions::BiasByType,
    shape::PoseOptions::BiasByType::Direction, shape::PoseOptions::BiasByType::Frame);
  vtkShapeVectorOptionOf(Options.Fill.Frames, BiasFrame);
  vtkShapeVectorOptionOf(Options.Fill.Frames, BiasRotation);
  vtkShapeOptionOf(Options.Fill.Frames, BiasWeight, double);
  vtkSetMacro(Dragging, bool);
  vtkGetMacro(Dragging, bool);
  ///@}

protected:
  vtkShapeCutFeature();
  ~vtkShapeCutFeature() override;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeCutFeature(const vtkShapeCutFeature&) = delete;
  void operator=(const vtkShapeCutFeature&) = delete;

  using FactWriter = std::function<void(vtkPolyData*)>;
  void Cut(vtkPolyData* marked, const shape::Progress& progress);
  void Prepare(bool isCloud, const shape::Progress& progress);
  std::vector<Eigen::MatrixXd> ReadCurves();
  FactWriter CutSurface(vtkPolyData* marked, const shape::Progress& progress);
  FactWriter CutCloud(vtkPolyData* marked, const shape::Progress& progress);

  std::vector<double> LoopPoints;
  bool KeepOriginal = false;
  bool Dragging = false;
  shape::CutFeatureOptions Options;
  struct Kept;
  std::unique_ptr<Kept> Cache;
};

#endif
