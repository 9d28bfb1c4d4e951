/**
 * @class   vtkShapeFillHoles
 * @brief   fills the holes of a surface, or what curves bound
 *
 * Input: a surface, manifold or not, whose open loops are holes (polygons are triangulated inside;
 * points at one place hang together). Blocks and distributed pieces are joined first. Or, without
 * polygons, closed polylines or a network of lines, with point `Normals` or without: each face of
 * it gets a patch (shape::FindCurveLoops).
 *
 * Output: the input with the fills, whose triangles are as long as the sides of the loops, and the
 * cell array `Filled` (int, 1 in fills, else 0). Points, cells and their data are those of the
 * input; points of fills have numbers with a fraction as smooth continuations of those at the loop
 * (`Normals` those of the fill), other data from the nearest point of the loop; cells from the
 * nearest cell at it. Loops that touch themselves at a point are split there. In parallel the first
 * process has the output.
 *
 * The deformation's parameters count where FillMethod is Deformation, and may be tuned live: the
 * frames at the loop are optimised for their defaults, once. A factorisation is one library call:
 * an abort takes effect at its end.
 *
 * Field data: FillHoles.Loops (found), .UnclosedSides (of the border, in no closed loop),
 * .LooseSegments and .SkippedFaces (of curves: see shape::CurveNetwork). For each loop that was
 * filled, a tuple of .Loop (its number, the longest being 0), .LoopPoints, .Method and .Reason
 * (words), .Nonplanarity (its farthest point from its plane, over its diameter),
 * .NormalDeviationBefore and .NormalDeviationAfter (degrees between the fill's normals at the loop
 * and those wanted there, in the mean; before: of the membrane, or before the frames are
 * optimised), .SelfIntersections (pairs of triangles that meet where they share nothing, one of
 * them of the fill), .Points and .Triangles (new).
 *
 * The mathematics: shape::SurfaceFiller.
 */
#ifndef vtkShapeFillHoles_h
#define vtkShapeFillHoles_h

#include "vtkShapeDeformingAlgorithm.h"

#include "Fill/FillHoles.h"  // for the options
#include "Fill/LoopChoice.h" // for the options

#include <memory> // for what is kept
#include <vector> // for the indices

class VTKSHAPEFILTERS_EXPORT vtkShapeFillHoles : public vtkShapeDeformingAlgorithm
{
public:
  static vtkShapeFillHoles* New();
  vtkTypeMacro(vtkShapeFillHoles, vtkShapeDeformingAlgorithm);

  ///@{
  /// 0 = Automatic: Fair, and where that meets itself or the surface, Deformation, then Membrane. 1
  /// = Deformation: a flat disk deformed until its outline is the loop. 2 = Fair: tangent to the
  /// surface, of harmonic mean curvature. 3 = Membrane: as taut as can be, with a crease. Default:
  /// Automatic.
  void SetFillMethod(int method);
  int GetFillMethod() { return static_cast<int>(this->Fill.Method); }
  ///@}
  ///@{
  /// Deformation: whether the frames at the loop are turned until the fill is tangent to the
  /// surface. Default: on.
  vtkShapeOptionOf(Fill.Filler, OptimizeNormals, bool);
  ///@}
  ///@{
  /// Which loops are filled. 0 = All. 1 = Longest. 2 = Chosen: those of LoopIndices. Default: All.
  vtkShapeEnumOptionOf(Choice, Loops, shape::LoopChoice::LoopsType,
    shape::LoopChoice::LoopsType::All, shape::LoopChoice::LoopsType::Chosen);
  ///@}
  ///@{
  /// Loops by number, the longest being 0, where Loops is Chosen. Default: none.
  void SetNumberOfLoopIndices(int count);
  void SetLoopIndices(int index, int loop);
  std::vector<int> GetLoopIndices() { return this->Choice.Indices; }
  ///@}
  ///@{
  /// Longer loops stay open; in the model's units, 0: none. Default: 0.
  vtkShapeOptionOf(Choice, MaximumLength, double);
  ///@}
  ///@{
  /// By how much edges grow with the distance from the loop. >= 0. Default: 0.
  vtkShapeOptionOf(Fill.Filler, EdgeGrowth, double);
  ///@}
  ///@{
  /// New points in a hole, about: edges grow where more would be needed. >= 1. Default: 100000.
  vtkShapeOptionOf(Fill.Filler, MaximumPoints, int);
  ///@}
  ///@{
  /// Deformation: of the offsets of points from those upwind; > 0. Default: 1.
  vtkShapeOption(Scale, double);
  ///@}
  ///@{
  /// Deformation: a direction that the normals at the loop are drawn to. Default: (0, 0, 1).
  vtkShapeVectorOptionOf(Fill.Frames, BiasFrame);
  ///@}
  ///@{
  /// Deformation: by which share of the angle; in [0, 1]. Default: 0.
  vtkShapeOptionOf(Fill.Frames, BiasWeight, double);
  ///@}

protected:
  vtkShapeFillHoles();
  ~vtkShapeFillHoles() override;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeFillHoles(const vtkShapeFillHoles&) = delete;
  void operator=(const vtkShapeFillHoles&) = delete;

  struct Kept;
  void Prepare(const shape::Progress& progress);

  shape::FillHolesOptions Fill;
  shape::LoopChoice Choice;
  std::unique_ptr<Kept> Cache;
};

#endif
