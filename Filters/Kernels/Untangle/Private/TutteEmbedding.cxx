#include "Untangle/Private/TutteEmbedding.h"

#include "Linear/SparseSolve.h"

#include <set>
#include <vector>

namespace shape
{

Eigen::MatrixXd SolveTutteEmbedding(const SolidCells& solid)
{
  Eigen::VectorXi row = Eigen::VectorXi::Constant(solid.PointCount(), -1);
  std::vector<int> inside;
  for (int point = 0; point < solid.PointCount(); ++point)
  {
    if (!solid.OnBoundary(point) && !solid.CellsOf(point).empty())
    {
      row(point) = static_cast<int>(inside.size());
      inside.push_back(point);
    }
  }
  Eigen::MatrixXd positions = solid.Points;
  if (inside.empty())
  {
    return positions;
  }
  const auto n = static_cast<Eigen::Index>(inside.size());
  Eigen::MatrixXd fixed = Eigen::MatrixXd::Zero(n, 3);
  std::vector<Eigen::Triplet<double>> entries;
  for (const int point : inside)
  {
    std::set<int> neighbours;
    for (const int cell : solid.CellsOf(point))
    {
      neighbours.insert(solid.PointsOf(cell).begin(), solid.PointsOf(cell).end());
    }
    neighbours.erase(point);
    entries.emplace_back(row(point), row(point), static_cast<double>(neighbours.size()));
    for (const int other : neighbours)
    {
      if (row(other) < 0)
      {
        fixed.row(row(point)) += solid.Points.row(other);
      }
      else
      {
        entries.emplace_back(row(point), row(other), -1.0);
      }
    }
  }
  Eigen::SparseMatrix<double> laplacian(n, n);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  SparseCholesky cholesky;
  cholesky.Factorize(laplacian);
  positions(inside, Eigen::all) = cholesky.Solve(fixed);
  return positions;
}

} // namespace shape
