#include "Untangle/Private/TutteEmbedding.h"

#include "Linear/DirichletProblem.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <vector>

namespace shape
{

namespace
{

/// Means over the boundary's edges at each of its points, and how many edges.
void MeasureBoundary(const SolidCells& solid, Eigen::VectorXd& sums, Eigen::VectorXd& counts)
{
  for (const std::array<int, 3>& triangle : solid.BoundaryTriangles())
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = triangle[k], b = triangle[(k + 1) % 3];
      const double length = (solid.Points.row(a) - solid.Points.row(b)).norm();
      const double atRest =
        solid.Rest.rows() > 0 ? (solid.Rest.row(a) - solid.Rest.row(b)).norm() : 1.0;
      if (length > 0.0 && atRest > 0.0)
      {
        const double size = std::log(length / atRest);
        sums(a) += size;
        sums(b) += size;
        counts(a) += 1.0;
        counts(b) += 1.0;
      }
    }
  }
}

/// Divides by the diagonal in each iteration, and reports progress there. Throws Aborted.
class ReportingPreconditioner : public Eigen::DiagonalPreconditioner<double>
{
public:
  Progress Report;

  template <typename Values>
  auto solve(const Eigen::MatrixBase<Values>& values) const
  {
    this->Report(1.0);
    return Eigen::DiagonalPreconditioner<double>::solve(values);
  }
};

} // namespace

Eigen::MatrixXd SolveTutteEmbedding(const SolidCells& solid, const Progress& progress)
{
  std::vector<int> fixed;
  std::vector<Eigen::Triplet<double>> entries;
  for (int point = 0; point < solid.PointCount(); ++point)
  {
    if (point % ReportInterval == 0)
    {
      progress(0.0);
    }
    const std::vector<int> neighbours = solid.NeighboursOf(point);
    // The boundary and loose points are fixed; every other row says: the sum of (x - neighbour) is
    // 0.
    if (solid.OnBoundary(point) || neighbours.empty())
    {
      fixed.push_back(point);
    }
    entries.emplace_back(point, point, static_cast<double>(neighbours.size()));
    for (const int other : neighbours)
    {
      entries.emplace_back(point, other, -1.0);
    }
  }
  Eigen::SparseMatrix<double> laplacian(solid.PointCount(), solid.PointCount());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  Eigen::MatrixXd positions = Eigen::MatrixXd::Zero(solid.PointCount(), 3);
  positions(fixed, Eigen::all) = solid.Points(fixed, Eigen::all);
  DirichletProblem(laplacian, fixed, progress)
    .Solve(positions, Eigen::MatrixXd::Zero(solid.PointCount(), 3), progress.Part(1.0, 1.0));
  return positions;
}

Eigen::VectorXd ComputeLogarithmicSizes(const SolidCells& solid, const Progress& progress)
{
  const int count = solid.PointCount();
  Eigen::VectorXd sizes = Eigen::VectorXd::Zero(count), counts = Eigen::VectorXd::Zero(count);
  MeasureBoundary(solid, sizes, counts);
  const double mean = counts.sum() > 0.0 ? sizes.sum() / counts.sum() : 0.0;
  std::vector<int> unknown(count, -1);
  int unknowns = 0;
  for (int point = 0; point < count; ++point)
  {
    if (counts(point) > 0.0)
    {
      sizes(point) /= counts(point);
    }
    else
    {
      sizes(point) = mean;
      unknown[point] = unknowns++;
    }
  }
  if (unknowns == 0)
  {
    return sizes;
  }
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
  for (int point = 0; point < count; ++point)
  {
    if (point % ReportInterval == 0)
    {
      progress(static_cast<double>(point) / count);
    }
    const int row = unknown[point];
    if (row < 0)
    {
      continue;
    }
    const std::vector<int> neighbours = solid.NeighboursOf(point);
    // Points not connected to a boundary stay at the mean.
    const double pull = 1e-9;
    right(row) = pull * mean;
    entries.emplace_back(row, row, static_cast<double>(neighbours.size()) + pull);
    for (const int other : neighbours)
    {
      if (unknown[other] < 0)
      {
        right(row) += sizes(other);
      }
      else
      {
        entries.emplace_back(row, unknown[other], -1.0);
      }
    }
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> laplacian(unknowns, unknowns);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double, Eigen::RowMajor>,
    Eigen::Lower | Eigen::Upper, ReportingPreconditioner>
    solver(laplacian);
  solver.preconditioner().Report = progress;
  // Sizes need only a few digits, which is much faster than a factorisation.
  solver.setTolerance(1e-4);
  solver.setMaxIterations(1000);
  const Eigen::VectorXd solved =
    solver.solveWithGuess(right, Eigen::VectorXd::Constant(unknowns, mean));
  for (int point = 0; point < count; ++point)
  {
    sizes(point) = unknown[point] < 0 ? sizes(point) : solved(unknown[point]);
  }
  return sizes;
}

} // namespace shape
