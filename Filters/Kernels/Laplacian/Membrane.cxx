#include "Laplacian/Membrane.h"

#include "Laplacian/CotangentWeights.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Linear/DirichletProblem.h"

#include <numeric>
#include <vector>

namespace shape
{

Eigen::MatrixXd SolveHarmonicValues(const Surface& patch, const Eigen::MatrixXd& loopValues)
{
  const Eigen::Index points = patch.Points().rows();
  // minimum weight; that of an edge between equilateral triangles is 0.58. Cocircular points
  // have weights of 0, or slightly below by rounding. Positive weights keep each value between
  // those of the loop.
  constexpr double minimum = 1e-9;
  const Eigen::SparseMatrix<double> stiffness =
    BuildPositiveStiffness(GetIntrinsicLaplacian(patch)->Stiffness, minimum);
  std::vector<int> loop(loopValues.rows());
  std::iota(loop.begin(), loop.end(), 0);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(points, loopValues.cols());
  values.topRows(loopValues.rows()) = loopValues;
  DirichletProblem(stiffness, loop).Solve(values, Eigen::MatrixXd::Zero(points, loopValues.cols()));
  return values;
}

Eigen::MatrixXd SolveMembrane(
  const Surface& disk, const Eigen::MatrixXd& loop, int rounds, const Progress& progress)
{
  progress(0.0);
  Eigen::MatrixXd positions = SolveHarmonicValues(disk, loop);
  for (int round = 1; round <= rounds; ++round)
  {
    progress(static_cast<double>(round) / (rounds + 1));
    // Pinkall and Polthier 1993: the harmonic map of the current surface replaces it.
    positions = SolveHarmonicValues(disk.WithPoints(positions), loop);
  }
  return positions;
}

} // namespace shape
