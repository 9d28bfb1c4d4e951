/**
 * @class   vtkShapeCoupling
 * @brief   couple two shapes of any kind by the distances along them
 *
 * Inputs: ShapeA and ShapeB, any data sets with points, also composite or distributed. Landmarks
 * and TargetLandmarks, optional: pairs of corresponding positions, as in vtkShapeCorrespondence.
 *
 * Outputs: ShapeA and ShapeB with the point arrays `TargetPosition` (double, 3), `TargetPointId`
 * (id) and `SampleWeight` (double; 0 where there is no sample). The first two are the image, a
 * point of the other shape. Its id counts the points of all blocks and pieces. Then follow the
 * facts, and a table with the columns `SampleOfA`, `SampleOfB` (ids of points) and `Mass`.
 *
 * The mathematics: shape::CoupleShapes.
 */
#ifndef vtkShapeCoupling_h
#define vtkShapeCoupling_h

#include "vtkShapeAlgorithm.h"

#include "Correspondence/Transport/Coupling.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeCoupling : public vtkShapeAlgorithm
{
public:
  static vtkShapeCoupling* New();
  vtkTypeMacro(vtkShapeCoupling, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeCoupling.xml. Defaults:
  /// shape::ShapeCouplingOptions.
  vtkShapeOption(Samples, int);
  vtkShapeOption(Starts, int);
  vtkShapeOption(SameSize, bool);
  vtkShapeOptionOf(Options.Coupling, FirstEntropy, double);
  vtkShapeOptionOf(Options.Coupling, Entropy, double);
  vtkShapeOptionOf(Options.Coupling, EntropyFactor, double);
  vtkShapeOptionOf(Options.Coupling, IterationsPerEntropy, int);
  vtkShapeOptionOf(Options.Coupling, SinkhornIterations, int);
  vtkSetMacro(SmallestMass, double);
  vtkGetMacro(SmallestMass, double);
  ///@}

protected:
  vtkShapeCoupling();
  ~vtkShapeCoupling() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeCoupling(const vtkShapeCoupling&) = delete;
  void operator=(const vtkShapeCoupling&) = delete;

  shape::Landmarks ReadLandmarks(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
  void WriteImages(int port, const Eigen::VectorXi& images, const Eigen::MatrixXd& targets,
    const std::vector<int>& samples, const Eigen::VectorXd& weights);

  shape::ShapeCouplingOptions Options;
  double SmallestMass = 1e-9;
};

#endif
