#include "Laplacian/Membrane.h"

#include "Laplacian/CotangentWeights.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Linear/DirichletProblem.h"

#include <numeric>
#include <vector>

namespace shape
{

Eigen::MatrixXd SolveHarmonicValues(const Mesh& patch, const Eigen::MatrixXd& loopValues)
{
  const Eigen::Index points = patch.Points.rows();
  const IntrinsicTriangles flat = BuildIntrinsicDelaunay(patch);
  constexpr double minimum = 1e-9; // of a weight: those of equilateral triangles are 0.58
  const Eigen::SparseMatrix<double> stiffness =
    BuildPositiveStiffness(BuildCotangentStiffness(flat.Triangles,
                             ComputeAnglesFromLengths(flat.Sides).Cotangents, points),
      minimum);
  std::vector<int> loop(loopValues.rows());
  std::iota(loop.begin(), loop.end(), 0);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(points, loopValues.cols());
  values.topRows(loopValues.rows()) = loopValues;
  DirichletProblem(stiffness, loop).Solve(values, Eigen::MatrixXd::Zero(points, loopValues.cols()));
  return values;
}

Eigen::MatrixXd SolveMembrane(
  const Mesh& disk, const Eigen::MatrixXd& loop, int rounds, const Progress& progress)
{
  Mesh membrane = disk;
  for (int round = 0; round <= rounds; ++round)
  {
    progress(static_cast<double>(round) / (rounds + 1));
    membrane.Points = SolveHarmonicValues(membrane, loop);
  }
  return membrane.Points;
}

} // namespace shape
