/**
 * @class   vtkShapeLandmarks
 * @brief   pick pairs of corresponding landmarks on two surfaces, or landmarks on one
 *
 * Inputs
 * - SurfaceA: a surface. Blocks and distributed pieces are joined first.
 * - SurfaceB (optional): another surface. With it, landmark i of PointsA and landmark i of PointsB
 *   are a pair. Without it, PointsB must be empty.
 *
 * Each position is moved to the closest position on its surface. No landmarks give empty outputs.
 *
 * Outputs: 0 and 1 are the landmarks on SurfaceA and on SurfaceB, as vertices. Output 2 has a line
 * between the two landmarks of each pair. The points of outputs 0 and 1, and the cells of output 2,
 * have these arrays:
 * - `Name` (string): the name of the landmark.
 * - `Number` (int): its number, from 1.
 * The points of outputs 0 and 1 also have `TargetPosition` (double, 3), the position of the
 * landmark on the other surface. Without SurfaceB, there is no such array, and outputs 1 and 2 are
 * empty. In parallel, the first process has all outputs.
 *
 * Facts: Landmarks.LargestDistanceFromA and Landmarks.LargestDistanceFromB, the
 * largest distance of the given positions from each surface. It is 0 without positions.
 *
 * The mathematics: shape::ProjectLandmarks.
 */
#ifndef vtkShapeLandmarks_h
#define vtkShapeLandmarks_h

#include "vtkShapeAlgorithm.h"

#include "Correspondence/Landmarks/Landmarks.h" // for the options

#include <string> // for names
#include <vector> // for positions

class vtkDataSetAttributes;

class VTKSHAPEFILTERS_EXPORT vtkShapeLandmarks : public vtkShapeAlgorithm
{
public:
  static vtkShapeLandmarks* New();
  vtkTypeMacro(vtkShapeLandmarks, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeLandmarks.xml. Enumerations and defaults:
  /// shape::LandmarksOptions.
  void SetNumberOfPointsA(int count);
  void SetPointsA(int index, double x, double y, double z);
  void SetPointsA(const std::vector<double>& values);
  std::vector<double> GetPointsA() { return this->PointsA; }
  void SetNumberOfPointsB(int count);
  void SetPointsB(int index, double x, double y, double z);
  void SetPointsB(const std::vector<double>& values);
  std::vector<double> GetPointsB() { return this->PointsB; }
  void SetNumberOfNames(int count);
  void SetNames(int index, const std::string& name);
  std::vector<std::string> GetNames() { return this->Names; }
  vtkShapeOption(MaximumDistance, double);
  ///@}

protected:
  vtkShapeLandmarks();
  ~vtkShapeLandmarks() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeLandmarks(const vtkShapeLandmarks&) = delete;
  void operator=(const vtkShapeLandmarks&) = delete;

  /// Returns the landmarks on the surface of an input, and fills the output with the same number.
  Eigen::MatrixXd Project(int port, const shape::Progress& progress);
  /// Adds Name and Number, which both are per point or per cell.
  void Label(vtkDataSetAttributes* attributes) const;

  std::vector<double> PointsA, PointsB;
  std::vector<std::string> Names;
  shape::LandmarksOptions Options;
};

#endif
