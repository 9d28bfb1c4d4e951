/**
 * @class   vtkShapeStructuredBlocks
 * @brief   turn the grid of hexahedra into structured grids and splines
 *
 * Input (vtkUnstructuredGrid): hexahedra with the cell arrays `Block` (int) and `BlockIndex` (int,
 * 3) and a map array at their points, such as output 2 of vtkShapeHexRemesh. Each block is a box of
 * cells.
 *
 * Input 1, optional (vtkPolyData): the closed surface of the solid. If it is given, nodes of the
 * boundary slide along it and those inside move, so that splines follow the map closely.
 *
 * Output 0 (vtkMultiBlockDataSet): a structured grid for each block, with the input's arrays except
 * for the map array, `Block` and `BlockIndex`. Its points are at the values of the map array, or
 * where they moved. The
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
 * - .LargestMotion: the largest distance by which a node moved; 0 without Surface.
 *
 * The mathematics: shape::FitBlockSpline, shape::SmoothMapOfBlocks.
 */
#ifndef vtkShapeStructuredBlocks_h
#define vtkShapeStructuredBlocks_h

#include "vtkShapeAlgorithm.h"

#include "Hex/SmoothBlockMap.h" // for the options

#include <string> // for names

class VTKSHAPEFILTERS_EXPORT vtkShapeStructuredBlocks : public vtkShapeAlgorithm
{
public:
  static vtkShapeStructuredBlocks* New();
  vtkTypeMacro(vtkShapeStructuredBlocks, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeStructuredBlocks.xml. Defaults:
  /// shape::SmoothBlockMapOptions.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  vtkShapeOption(Degree, int);
  vtkShapeOption(NodesPerControl, double);
  vtkShapeOption(FeatureAngle, double);
  ///@}

protected:
  vtkShapeStructuredBlocks();
  ~vtkShapeStructuredBlocks() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeStructuredBlocks(const vtkShapeStructuredBlocks&) = delete;
  void operator=(const vtkShapeStructuredBlocks&) = delete;

  std::string MapArray = "TargetPosition";
  shape::SmoothBlockMapOptions Options;
};

#endif
