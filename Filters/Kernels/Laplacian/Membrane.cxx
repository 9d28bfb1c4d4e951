#include "Laplacian/Membrane.h"

#include "Laplacian/CotangentWeights.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Linear/DirichletProblem.h"

#include <numeric>
#include <vector>

namespace shape
{

Eigen::MatrixXd SolveHarmonicValues(
  const Surface& patch, const Eigen::MatrixXd& loopValues, const Progress& progress)
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
  DirichletProblem(stiffness, loop, progress)
    .Solve(values, Eigen::MatrixXd::Zero(points, loopValues.cols()), progress.Part(1.0, 1.0));
  return values;
}

Eigen::MatrixXd SolveMembrane(
  const Surface& disk, const Eigen::MatrixXd& loop, int rounds, const Progress& progress)
{
  progress(0.0);
  const auto part = [&](int round)
  { return progress.Part(round / (rounds + 1.0), (round + 1.0) / (rounds + 1.0)); };
  Eigen::MatrixXd positions = SolveHarmonicValues(disk, loop, part(0));
  for (int round = 1; round <= rounds; ++round)
  {
    // Pinkall and Polthier 1993: the harmonic map of the current surface replaces it.
    positions = SolveHarmonicValues(disk.WithPoints(positions), loop, part(round));
  }
  return positions;
}

} // namespace shape
