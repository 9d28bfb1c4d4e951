/**
 * @class   vtkShapeMorph
 * @brief   move a shape along its map as time goes from 0 to 1
 *
 * At time t each point is at (1 - t) x + t y. Here x is its position and y its map array, so t = 0
 * gives the input and t = 1 the image of the map.
 *
 * Input: points or cells of any data set, also composite or distributed, with the map array (3
 * components) at its points.
 *
 * Output: the same data moved, with `SourcePosition` (double, 3), the position at t = 0. Image
 * data and rectilinear grids become structured grids. Point normals are dropped. The time range is
 * [0, 1], and each time in it can be requested. An earlier time, or no time, gives t = 0, and a
 * later time gives t = 1. The range is listed in 41 steps, which the player of ParaView uses by
 * default. If the input has time steps, the first one is used.
 *
 * The mathematics is the formula above: there is no kernel.
 */
#ifndef vtkShapeMorph_h
#define vtkShapeMorph_h

#include "vtkShapeAlgorithm.h"

class VTKSHAPEFILTERS_EXPORT vtkShapeMorph : public vtkShapeAlgorithm
{
public:
  static vtkShapeMorph* New();
  vtkTypeMacro(vtkShapeMorph, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeMorph.xml.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  ///@}

protected:
  vtkShapeMorph();
  ~vtkShapeMorph() override = default;
  void Execute(const shape::Progress& progress) override;
  void DescribeOutputs(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void RequestInputs(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkShapeMorph(const vtkShapeMorph&) = delete;
  void operator=(const vtkShapeMorph&) = delete;

  std::string MapArray = "TargetPosition";
};

#endif
