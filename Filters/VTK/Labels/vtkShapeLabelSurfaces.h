/**
 * @class   vtkShapeLabelSurfaces
 * @brief   extract the surfaces between the labels of an image
 *
 * Input: a vtkImageData, also with directions, one block or distributed, with an array of labels at
 * its points or cells. Label 0 and everything beyond the image are the outside. With Thresholds,
 * the array has grey values: the label of a value is the number of thresholds that it reaches.
 *
 * Output 0: one surface of triangles (vtkPolyData), each between two regions. In parallel, the
 * first process has all of it.
 * - Cell array `Regions` (int, 2): the labels on both sides. The normal leaves the first, which is
 *   the greater.
 * - Cell array `Patch` (int): a number for each pair of labels, from 0, in the order of the pairs.
 *
 * Output 1: the curves where three or more regions meet, as polylines, and the points where curves
 * end or meet, as vertices. Point array `SurfacePointId` (vtkIdType): the point of output 0.
 *
 * Facts: LabelSurfaces.Points, .Triangles, .Regions, .Curves, .Corners, .Islands (parts
 * that were dissolved), .IslandVoxels, .SplitPoints, .Intersections; .Labels, .Components,
 * .EulerNumbers, .Volumes, .VoxelVolumes: a number for each region, ascending by label.
 *
 * The mathematics: shape::ExtractLabelSurfaces.
 */
#ifndef vtkShapeLabelSurfaces_h
#define vtkShapeLabelSurfaces_h

#include "vtkShapeAlgorithm.h"

#include "Labels/LabelSurfaces.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeLabelSurfaces : public vtkShapeAlgorithm
{
public:
  static vtkShapeLabelSurfaces* New();
  vtkTypeMacro(vtkShapeLabelSurfaces, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeLabelSurfaces.xml. Defaults:
  /// shape::LabelSurfacesOptions.
  vtkSetStdStringFromCharMacro(LabelArray);
  vtkGetCharFromStdStringMacro(LabelArray);
  vtkShapeOption(Smoothing, double);
  vtkShapeOption(SmallestIsland, int);
  void SetNumberOfLabels(int count);
  void SetLabels(int index, int label);
  std::vector<int> GetLabels() { return this->Options.Labels; }
  void SetNumberOfThresholds(int count);
  void SetThresholds(int index, double threshold);
  std::vector<double> GetThresholds() { return this->Thresholds; }
  ///@}

protected:
  vtkShapeLabelSurfaces();
  ~vtkShapeLabelSurfaces() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeLabelSurfaces(const vtkShapeLabelSurfaces&) = delete;
  void operator=(const vtkShapeLabelSurfaces&) = delete;

  std::string LabelArray;
  std::vector<double> Thresholds;
  shape::LabelSurfacesOptions Options;
};

#endif
