/**
 * @class   vtkShapeCutFeature
 * @brief   cuts a feature from a surface and fills the hole that it leaves
 *
 * Inputs
 * - Input: a surface, open or closed, that may hang together in any way (polygons are triangulated
 *   inside; seams are closed, see shape::WeldedSurface). Blocks and distributed pieces are joined
 * first.
 * - Loop (optional): closed curves on the surface, or near it: each is taken to the closest places
 *   and joined over the surface by locally shortest paths. Lines that follow each other end to end,
 *   in any order, are one curve.
 * - Selection (optional): a selection of cells, or of points (of which cells have all of their
 *   points), or what Extract Selection makes of it (with vtkOriginalCellIds).
 * One of the two, or LoopPoints.
 *
 * Outputs: 0 the feature, 1 the rest, with the hole filled: surfaces of triangles with the point
 * array `OriginalPointId` (vtkIdType; -1: new) and all data of points and cells (see
 * vtkShapeCutParts); the rest also with the cell array `Filled` (int, 0 or 1). Triangles that the
 * loop goes through are split; the surface's shape is the same. In parallel the first process has
 * them.
 *
 * What the feature stood on goes with it, so that it can be set down in its old place (Shape Paste
 * Feature): the point arrays `LoopCoordinates` (double, 3: u, v, 0 in an exponential map of the
 * filled rest around the middle of the fill; 0 elsewhere) and `LoopNormal` (double, 3: the unit
 * normal of the filled rest; 0 elsewhere) at its longest loop that was cut and filled, and the
 * field data CutFeature.Seed, .SeedNormal and .SeedDirection (3 numbers each: the map's origin, its
 * normal and its u axis), .ConformalRadius (0 but where the layout is conformal), .Refined (1 where
 * it is that with the least distortion) and .ReturnsInPlace (1 where the loop comes back to its
 * place when it is set down there): see shape::FeatureFootprint.
 *
 * Field data of both outputs: CutFeature.Loops (closed loops that were cut), .LoopsLeftOut (parts
 * of a curve that touches itself: the longest one cuts), .CutLength, .FeatureArea, .Holes (that
 * were filled), .WeldedPoints, .Refused and .Refusal, why (see Dragging).
 *
 * What depends on the input alone is kept while only the loop changes.
 *
 * The mathematics: shape::CutFeature.
 */
#ifndef vtkShapeCutFeature_h
#define vtkShapeCutFeature_h

#include "vtkShapeAlgorithm.h"

#include "CutPaste/CutFeature.h" // for the options

#include <memory> // for what is kept
#include <vector>

class vtkPolyData;

class VTKSHAPEFILTERS_EXPORT vtkShapeCutFeature : public vtkShapeAlgorithm
{
public:
  static vtkShapeCutFeature* New();
  vtkTypeMacro(vtkShapeCutFeature, vtkShapeAlgorithm);

  ///@{
  /// Positions of a closed curve, the last joined to the first, where nothing is connected to Loop
  /// and Selection. x, y, z of each. Default: none.
  void SetNumberOfLoopPoints(int count);
  void SetLoopPoints(int index, double x, double y, double z);
  std::vector<double> GetLoopPoints() { return this->LoopPoints; }
  ///@}

  ///@{
  /// On which side of loops the feature is: 0 = Smaller, where there is less area. 1 = Larger. 2 =
  /// Left, seen from outside in the order of the loop's points. 3 = Right. Default: Smaller.
  vtkShapeEnumOption(Side, shape::LoopSide, shape::LoopSide::Smaller, shape::LoopSide::Right);
  ///@}

  ///@{
  /// Which of several curves cuts, from 0 on. -1: all. Default: -1.
  vtkShapeOption(LoopIndex, int);
  ///@}

  ///@{
  /// Whether the rest is filled where the feature was. Default: on.
  vtkShapeOption(FillHole, bool);
  ///@}

  ///@{
  /// Whether the rest is the Input as it is, without further arrays: the feature is copied, not
  /// cut. The hole is filled all the same where FillHole is on, for what the feature stood on.
  /// Default: off.
  vtkSetMacro(KeepOriginal, bool);
  vtkGetMacro(KeepOriginal, bool);
  ///@}

  ///@{
  /// How near to an end of an edge, as a share of its length, the loop is moved to it: else there
  /// are thin triangles. In [0, 0.5). Default: 0.05.
  vtkShapeOption(SnapShare, double);
  ///@}

  ///@{
  /// While a loop is being drawn: the hole is not filled, and where the loop cannot be cut the
  /// outputs are the last ones that could, with CutFeature.Refused = 1. Default: off.
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

  void Cut(vtkPolyData* marked, const shape::Progress& progress);

  std::vector<double> LoopPoints;
  bool KeepOriginal = false;
  bool Dragging = false;
  shape::CutFeatureOptions Options;
  struct Kept;
  std::unique_ptr<Kept> Cache;
};

#endif
