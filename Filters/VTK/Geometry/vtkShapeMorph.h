/**
 * @class   vtkShapeMorph
 * @brief   move a shape along its map as time goes from 0 to 1
 *
 * At time t, a point is at (1 - t) x + t y. Here, x is its position in the input, and y is the
 * value of its map array. So t = 0 gives the input, and t = 1 gives the image under the map.
 *
 * Input: any data set, which may be composite or distributed, with the map array (3 components) at
 * its points.
 *
 * Output: the moved data, with the point array `SourcePosition` (double, 3), the position at t = 0.
 * Image data and rectilinear grids become structured grids. Point normals are dropped. The time
 * range is [0, 1], and any time in it can be requested. Earlier requests, and requests without a
 * time, give t = 0. Later requests give t = 1. The filter lists 41 time steps, which ParaView plays
 * by default. If the input has time steps, the first one is used.
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
