#include "Linear/DirichletProblem.h"

namespace shape
{

DirichletProblem::DirichletProblem(const Eigen::SparseMatrix<double>& stiffness,
  const std::vector<int>& fixed, const Progress& progress)
  : Stiffness(stiffness)
{
  // The matrix of the inner points; -1 marks fixed ones.
  std::vector<int> row(stiffness.rows(), 0);
  for (const int point : fixed)
  {
    row[point] = -1;
  }
  for (int point = 0; point < static_cast<int>(row.size()); ++point)
  {
    if (row[point] == 0)
    {
      row[point] = static_cast<int>(this->Inner.size());
      this->Inner.push_back(point);
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (int column = 0; column < stiffness.outerSize(); ++column)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(stiffness, column); entry; ++entry)
    {
      if (row[entry.row()] >= 0 && row[column] >= 0)
      {
        entries.emplace_back(row[entry.row()], row[column], entry.value());
      }
    }
  }
  const auto count = static_cast<Eigen::Index>(this->Inner.size());
  Eigen::SparseMatrix<double> inner(count, count);
  inner.setFromTriplets(entries.begin(), entries.end());
  if (count > 0)
  {
    this->Solver.Factorize(inner, progress);
  }
}

void DirichletProblem::Solve(
  Eigen::MatrixXd& values, const Eigen::MatrixXd& right, const Progress& progress) const
{
  if (!this->Inner.empty())
  {
    // Values at inner points are 0, so the product has only the contribution of the fixed points.
    const Eigen::MatrixXd rest = right - this->Stiffness * values;
    values(this->Inner, Eigen::all) = this->Solver.Solve(rest(this->Inner, Eigen::all), progress);
  }
}

} // namespace shape
