/**
 * @class   vtkShapeSynthesize
 * @brief   make a new sample of a statistical shape, and carry data inside it along
 *
 * A sample at the weights w is Mean + sum_k w_k Mode_k. A weight is a number of standard
 * deviations.
 *
 * Inputs
 * - Atlas: the mean shape, a surface with the point arrays `Mode0`, `Mode1`, ... (3 components
 *   each): the displacement for a weight of 1. Point arrays `<Name>Mean`, `<Name>Mode0`, ... are a
 *   quantity that varies with the shape, of any number of components. With Data, the Atlas needs
 *   the point array `SourcePosition` (3 components), the template's own position of the point, and
 *   it must be closed.
 * - Data (optional): any data set in the template's coordinates, which may be composite or
 *   distributed, such as hexahedra of Shape Hex Remesh.
 *
 * Outputs
 * - 0: the sample: the Atlas moved, without point normals. Each quantity has the array `<Name>`,
 * and the field data array `Weights` has the weight of each mode.
 * - 1: Data moved by the harmonic map from the template to the sample, without point normals, with
 *   the point arrays `SourcePosition` (double, 3) and `OutsideDomain` (int). `OutsideDomain` is 1
 * at points that are farther from the template than 1 % of its longest side; they keep their
 *   position. Data with cells have the cell array `Inverted` (int), and hexahedra also
 *   `ScaledJacobian`. Without Data, the output is empty.
 *
 * The maps of the mean and of the modes are kept while Atlas and Data are the same: for other
 * weights they are only added.
 *
 * If Untangle is on, inverted solid cells are untangled with a fixed boundary (shape::Untangle),
 * in each block by itself. Tetrahedra may be split; the output then has the arrays of
 * vtkShapeUntangle. Hexahedra below WantedScaledJacobian are improved; boundary points then slide
 * on the sample (shape::RaiseSampleQuality). Data on several processes are not repaired.
 *
 * With Animate, the outputs have 41 time steps in [0, 1]. The weight of the mode Animate is then
 * Amplitude times the sine of 2 pi times the time. Inputs with time steps are read at the first.
 *
 * Facts, with the prefix Synthesize
 * - .Modes: number of modes. The others need Data.
 * - .Tetrahedra: number of tetrahedra in the template.
 * - .OutsidePoints: number of points with OutsideDomain = 1. .TemplateDistance: the largest
 * distance of a point outside the template, divided by the template's longest side.
 * - .InvertedBefore, .InvertedAfter: numbers of cells that the map inverts, before and after they
 *   are untangled.
 * - .MinimumScaledJacobian: only if Data have hexahedra.
 * - .BoundaryPoints: number of boundary points of Data that are at most 1 % of the longest side
 * from the template. If there are no solid cells, all points of surface cells count as boundary
 * points. .BoundaryDistance: their largest distance from the sample, divided by its longest side.
 *
 * The mathematics: shape::Synthesize, shape::SolveModes, shape::CarryModes.
 */
#ifndef vtkShapeSynthesize_h
#define vtkShapeSynthesize_h

#include "vtkShapeAlgorithm.h"

#include "Atlas/Synthesize.h" // for the options

#include <memory>
#include <vector>

class vtkShapeSynthesizedData;

class VTKSHAPEFILTERS_EXPORT vtkShapeSynthesize : public vtkShapeAlgorithm
{
public:
  static vtkShapeSynthesize* New();
  vtkTypeMacro(vtkShapeSynthesize, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeSynthesize.xml. Defaults:
  /// shape::SynthesizeOptions.
  void SetNumberOfWeights(int count);
  void SetWeights(int mode, double weight);
  std::vector<double> GetWeights() { return this->Weights; }
  vtkSetMacro(Animate, int);
  vtkGetMacro(Animate, int);
  vtkSetMacro(Amplitude, double);
  vtkGetMacro(Amplitude, double);
  vtkShapeOption(Untangle, bool);
  vtkShapeOption(WantedScaledJacobian, double);
  vtkShapeOption(Tetrahedra, int);
  ///@}

protected:
  vtkShapeSynthesize();
  ~vtkShapeSynthesize() override;
  void Execute(const shape::Progress& progress) override;
  void DescribeOutputs(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  void RequestInputs(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkShapeSynthesize(const vtkShapeSynthesize&) = delete;
  void operator=(const vtkShapeSynthesize&) = delete;

  /// Returns the weight of each mode, at the requested time.
  Eigen::VectorXd ReadWeights(int modes);
  /// Warns of points outside, the farthest at a share of the size, of inverted cells that cannot be
  /// untangled, and of cells that stay inverted.
  void WarnOfResult(double outside, double farthest, double notUntangled, double left);

  std::vector<double> Weights;
  int Animate = -1;
  double Amplitude = 3.0;
  shape::SynthesizeOptions Options;
  std::unique_ptr<vtkShapeSynthesizedData> Carried; ///< reused if the inputs do not change
};

#endif
