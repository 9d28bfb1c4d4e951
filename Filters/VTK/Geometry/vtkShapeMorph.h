/**
 * @class   vtkShapeMorph
 * @brief   moves a shape from its place to where its map sends it, as time goes from 0 to 1
 *
 * At time t each point is at (1 - t) x + t y, where x is its place and y its map array: t = 0 gives
 * the input, t = 1 the image of the map, and ParaView's player what lies between.
 *
 * Input: points or cells of any dataset, also composite or distributed, with the map array
 * (3 components) at its points.
 *
 * Output: the same data moved (image data and rectilinear grids become structured grids), with
 * `SourcePosition` (double, 3), the place at t = 0. Point normals are dropped. The time range is
 * [0, 1], and every time in it can be asked for; earlier ones give t = 0, as no request does, later
 * ones t = 1. It is listed in 41 steps, which ParaView's player snaps to as it is set up by
 * default. An input with time steps of its own is taken at the first of them.
 *
 * The mathematics is the line above: there is no kernel.
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
  /// The point array that says where each point goes. Default: TargetPosition.
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
