#include "Laplacian/Membrane.h"

#include "Laplacian/CotangentWeights.h"
#include "Linear/DirichletProblem.h"
#include "Laplacian/IntrinsicDelaunay.h"

#include <numeric>
#include <vector>

namespace shape
{

Eigen::MatrixXd HarmonicValues(const Mesh& patch, const Eigen::MatrixXd& rimValues)
{
  const Eigen::Index points = patch.Points.rows();
  const IntrinsicTriangles flat = IntrinsicDelaunay(patch);
  constexpr double least = 1e-9; // of a weight: those of equilateral triangles are 0.58
  const Eigen::SparseMatrix<double> stiffness = PositiveStiffness(
    CotangentStiffness(flat.Triangles, AnglesOfSides(flat.Sides).Cotangents, points), least);
  std::vector<int> rim(rimValues.rows());
  std::iota(rim.begin(), rim.end(), 0);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(points, rimValues.cols());
  values.topRows(rimValues.rows()) = rimValues;
  DirichletProblem(stiffness, rim).Solve(values, Eigen::MatrixXd::Zero(points, rimValues.cols()));
  return values;
}

Eigen::MatrixXd MembranePoints(
  const Mesh& disk, const Eigen::MatrixXd& rim, int rounds, const Progress& progress)
{
  Mesh membrane = disk;
  for (int round = 0; round <= rounds; ++round)
  {
    progress(static_cast<double>(round) / (rounds + 1));
    membrane.Points = HarmonicValues(membrane, rim);
  }
  return membrane.Points;
}

} // namespace shape
