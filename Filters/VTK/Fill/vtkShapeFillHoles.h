/**
 * @class   vtkShapeFillHoles
 * @brief   fill the holes of a surface, or closed curves, with smooth surfaces
 *
 * Input: a surface, manifold or not, whose open loops are holes. Polygons are triangulated
 * internally, and coincident points are connected. Blocks and distributed pieces are joined first.
 * Without polygons it is closed polylines or a network of lines, with or without point `Normals`.
 * Each face of the network gets a patch (shape::FindCurveLoops).
 *
 * Output: the input with the fills, whose triangles are as large as those at the loops, and the
 * cell array `Filled` (int, 1 in fills, otherwise 0). Points, cells and their data are those of
 * the input. On fills, floating-point values and colours continue smoothly from the loop, and
 * normals are those of the fill. Other point data are those of the nearest point of the loop, and
 * cell data those of a cell there. Loops that touch themselves at a point are split there. In
 * parallel the first process has the output.
 *
 * The parameters of the deformation apply to FillMethod Deformation and may change interactively.
 * The frames at the loop are optimised once, for the default parameters. A factorisation cannot be
 * interrupted, so an abort takes effect at its end.
 *
 * Field data, with the prefix FillHoles
 * - .Loops: number of loops found. .UnclosedSides: boundary edges in no closed loop.
 * - .LooseSegments, .SkippedFaces: of curves, see shape::CurveNetwork.
 * and a tuple for each filled loop
 * - .Loop: number of the loop, 0 for the longest. .LoopPoints. .Method and .Reason (strings).
 * - .Nonplanarity: maximum distance of the loop from its plane, divided by its diameter.
 * - .NormalDeviationBefore, .NormalDeviationAfter: mean angle between the normals of the fill at
 *   the loop and the prescribed ones, in degrees. Before: of the membrane, or before the frames
 *   are optimised.
 * - .SelfIntersections: pairs of triangles that intersect without a shared point, at least one of
 *   them of the fill.
 * - .Points, .Triangles: numbers of new points and triangles.
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
  /// The properties. Effects and ranges: vtkShapeFillHoles.xml. Enumerations and defaults:
  /// shape::FillHolesOptions, shape::LoopChoice.
  void SetFillMethod(int method);
  int GetFillMethod() { return static_cast<int>(this->Fill.Method); }
  vtkShapeOptionOf(Fill.Filler, OptimizeNormals, bool);
  vtkShapeEnumOptionOf(Choice, Loops, shape::LoopChoice::LoopsType,
    shape::LoopChoice::LoopsType::All, shape::LoopChoice::LoopsType::Chosen);
  void SetNumberOfLoopIndices(int count);
  void SetLoopIndices(int index, int loop);
  std::vector<int> GetLoopIndices() { return this->Choice.Indices; }
  vtkShapeOptionOf(Choice, MaximumLength, double);
  vtkShapeOptionOf(Fill.Filler, EdgeGrowth, double);
  vtkShapeOptionOf(Fill.Filler, MaximumPoints, int);
  vtkShapeOption(Scale, double);
  vtkShapeVectorOptionOf(Fill.Frames, BiasFrame);
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
