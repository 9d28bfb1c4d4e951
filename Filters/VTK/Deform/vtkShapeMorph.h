/**
 * @class   vtkShapeMorph
 * @brief   move a shape to its image, or to a blend of targets, as time goes from 0 to 1
 *
 * The targets are the connected Targets or, without them, the image of the map array. Their
 * motions are blended with weights w_k. Let a point be at x, and at y_k in the targets. With Path
 * Straight, it is at x + t (w_1 (y_1 - x) + w_2 (y_2 - x) + ...) at time t.
 *
 * Inputs
 * - Input: any data set, which may be composite or distributed. Without Targets, it has the map
 *   array (3 components) at its points.
 * - Targets: optional, repeatable: data sets with the points of Input in the same order, in the
 *   same blocks and pieces.
 *
 * Output: the moved data, with the point array `SourcePosition` (double, 3), the position at t = 0.
 * Image data and rectilinear grids become structured grids. Point normals are dropped. The time
 * range is [0, 1], and any time in it can be requested. Earlier requests, and requests without a
 * time, give t = 0. Later requests give t = 1. The filter lists 41 time steps, which ParaView plays
 * by default. If an input has time steps, the first one is used. With Animate off, t = 1.
 *
 * The mathematics of Path Rigid: shape::RigidMorph. That of Straight is the formula above.
 */
#ifndef vtkShapeMorph_h
#define vtkShapeMorph_h

#include "vtkShapeAlgorithm.h"

#include <memory> // for the cache
#include <vector> // for weights

class VTKSHAPEFILTERS_EXPORT vtkShapeMorph : public vtkShapeAlgorithm
{
public:
  static vtkShapeMorph* New();
  vtkTypeMacro(vtkShapeMorph, vtkShapeAlgorithm);

  /// How points move.
  enum class PathType
  {
    Straight, ///< along straight lines
    Rigid     ///< as rigidly as possible
  };

  ///@{
  /// The targets: connections of port 1.
  void AddTargets(vtkAlgorithmOutput* target);
  void RemoveAllTargets();
  ///@}

  ///@{
  /// The properties. Effects and ranges: vtkShapeMorph.xml.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  vtkShapeEnumOptionAs(Path, Path, PathType, PathType::Straight, PathType::Rigid);
  void SetNumberOfWeights(int count);
  void SetWeights(int index, double weight);
  std::vector<double> GetWeights() { return this->Weights; }
  vtkShapeOptionAs(Animate, Animate, bool);
  vtkBooleanMacro(Animate, bool);
  ///@}

protected:
  vtkShapeMorph();
  ~vtkShapeMorph() override;
  void Execute(const shape::Progress& progress) override;
  void DescribeOutputs(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void RequestInputs(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkShapeMorph(const vtkShapeMorph&) = delete;
  void operator=(const vtkShapeMorph&) = delete;

  std::vector<double> BlendWeights(std::size_t targets);

  std::string MapArray = "TargetPosition";
  PathType Path = PathType::Straight;
  std::vector<double> Weights;
  bool Animate = true;

  struct Kept;
  std::unique_ptr<Kept> Cache;
};

#endif
