/**
 * @class   vtkShapeStructuredBlocks
 * @brief   turn the grid of hexahedra into structured grids and splines
 *
 * Input (vtkUnstructuredGrid): hexahedra with the cell arrays `Block` (int) and `BlockIndex` (int,
 * 3) and a map array at their points, such as output 2 of vtkShapeHexRemesh. Each block is a box of
 * cells.
 *
 * Output 0 (vtkMultiBlockDataSet): a structured grid for each block, with the input's arrays except
 * for the map array, `Block` and `BlockIndex`. Its points are at the values of the map array. The
 * point array `SourcePosition` (double, 3) is the position in the input, `SplinePosition`
 * (double, 3) that of the spline, and `SplineError` (double) the distance between spline and point.
 *
 * Output 1 (vtkMultiBlockDataSet): the control points of each block as a structured grid. Its field
 * data `KnotsI`, `KnotsJ` and `KnotsK` (double) are the knots in [0, 1]; the first is repeated
 * degree + 1 times.
 *
 * Splines of blocks that share a side agree on it. In parallel, the first process has all outputs.
 *
 * Facts, with the prefix StructuredBlocks
 * - .Blocks, .Nodes, .ControlPoints: their numbers, over all blocks.
 * - .SplineError, .MeanSplineError: the largest and the mean distance at the nodes.
 * - .RelativeError: the largest distance divided by the diagonal of the bounding box of the map's
 *   values.
 *
 * The mathematics: shape::FitBlockSpline.
 */
#ifndef vtkShapeStructuredBlocks_h
#define vtkShapeStructuredBlocks_h

#include "vtkShapeAlgorithm.h"

#include "Hex/StructuredBlocks.h" // for the options

#include <string> // for names

class VTKSHAPEFILTERS_EXPORT vtkShapeStructuredBlocks : public vtkShapeAlgorithm
{
public:
  static vtkShapeStructuredBlocks* New();
  vtkTypeMacro(vtkShapeStructuredBlocks, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeStructuredBlocks.xml. Defaults:
  /// shape::BlockSplineOptions.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  vtkShapeOption(Degree, int);
  vtkShapeOption(NodesPerControl, double);
  ///@}

protected:
  vtkShapeStructuredBlocks();
  ~vtkShapeStructuredBlocks() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeStructuredBlocks(const vtkShapeStructuredBlocks&) = delete;
  void operator=(const vtkShapeStructuredBlocks&) = delete;

  std::string MapArray = "TargetPosition";
  shape::BlockSplineOptions Options;
};

#endif
