/**
 * @class   vtkShapeFillHoles
 * @brief   fill the holes of a surface, or closed curves, with smooth surfaces
 *
 * Input: a surface, manifold or not, whose open loops are holes. Polygons are triangulated
 * internally, and coincident points are connected. Blocks and distributed pieces are joined first.
 * An input with lines and without polygons is treated as closed polylines or a network of lines,
 * with or without the point array `Normals`. Each face of the network is filled with a patch
 * (shape::FindCurveLoops). Points alone, or with vertices, are a point cloud, which samples a
 * surface with its normals or estimated ones; its holes are found (shape::FindCloudBoundary).
 *
 * Output: the input, followed by the fills, with the cell array `Filled` (int, 1 in fills,
 * otherwise 0). The triangles of a fill are as large as the triangles at its loop. The points and
 * cells of the input and their data do not change. On fills, floating-point values and colours
 * continue smoothly from the loop, and normals are computed from the fill. Other point data are
 * copied from the nearest point of the loop, and cell data from a cell at this point. Loops that
 * touch themselves at a point are split at this point. Of the fills of a point cloud, only the
 * points are used: the output has a vertex at each point, and normals. If SplitSheets is on, a
 * point where sheets of the filled surface touch gets a copy for each further sheet, after all
 * other points. In parallel, the first process has the output.
 *
 * The parameters of vtkShapeDeformingAlgorithm apply to the FillMethod Deformation and may be
 * changed interactively. The frames at the loop are optimised once, for the default parameters.
 *
 * Facts, with the prefix FillHoles
 * - .Loops: number of loops found. .UnclosedSides: number of boundary edges that belong to no
 *   closed loop.
 * - .PointCloud: 1 if Input is a point cloud. .EstimatedNormals: 1 if it has no normals.
 *   .OuterLoops: number of its boundary loops that are around the surface and are not filled.
 * - .CopiedPoints: number of copies of points where sheets touch.
 * - .LooseSegments, .SkippedFaces: for input without polygons, see shape::CurveNetwork.
 * These facts have an entry for each filled loop:
 * - .Loop: index of the loop, 0 for the longest. .LoopPoints: number of its points. .Method and
 *   .Reason (strings).
 * - .Nonplanarity: maximum distance of a point of the loop from the plane of the loop, divided by
 *   the diameter of the loop.
 * - .NormalDeviationBefore, .NormalDeviationAfter: mean angle between the normals of the fill at
 *   the loop and the prescribed normals, in degrees. "Before" refers to the membrane or, for
 *   Deformation, to the fill before the frames are optimised.
 * - .SelfIntersections: number of pairs of triangles that intersect but share no point. At least
 *   one triangle of each pair is in the fill.
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
  vtkShapeEnumOptionAs(Fill.Method, FillMethod, shape::FillMethod, shape::FillMethod::Automatic,
    shape::FillMethod::Membrane);
  vtkShapeOptionOf(Fill.Filler, OptimizeNormals, bool);
  vtkShapeEnumOptionOf(Choice, Loops, shape::LoopChoice::LoopsType,
    shape::LoopChoice::LoopsType::All, shape::LoopChoice::LoopsType::Chosen);
  void SetNumberOfLoopIndices(int count);
  void SetLoopIndices(int index, int loop);
  std::vector<int> GetLoopIndices() { return this->Choice.Indices; }
  vtkShapeOptionOf(Choice, MaximumLength, double);
  vtkSetMacro(SplitSheets, bool);
  vtkGetMacro(SplitSheets, bool);
  vtkShapeOptionOf(Fill.Filler, EdgeGrowth, double);
  vtkShapeOptionOf(Fill.Filler, MaximumPoints, int);
  vtkShapeOption(Scale, double);
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
  bool SplitSheets = true;
  std::unique_ptr<Kept> Cache;
};

#endif
