#include "Deform/Private/LaplacianSmoothing.h"

namespace shape
{
namespace
{

double WeightOf(const Eigen::MatrixXd& positions, int a, int b)
{
  return 1.0 / (positions.row(a) - positions.row(b)).norm();
}

} // namespace

LaplacianSmoothing::LaplacianSmoothing(const NodeProblem& problem)
  : Positions(problem.Graph.Positions)
  , Scales(problem.Scales)
  , Links(ListLinks(problem.Graph))
  , Unknown(problem.Graph.Size(), 0)
{
  for (const int source : problem.Sources)
  {
    this->Unknown[source] = -1;
  }
  for (int& row : this->Unknown)
  {
    row = row < 0 ? -1 : this->Count++;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [a, b] : this->Links)
  {
    const double weight = WeightOf(this->Positions, a, b);
    const int row = this->Unknown[a], column = this->Unknown[b];
    for (const int one : { row, column })
    {
      if (one >= 0)
      {
        entries.emplace_back(one, one, weight);
      }
    }
    if (row >= 0 && column >= 0)
    {
      entries.emplace_back(row, column, -weight);
      entries.emplace_back(column, row, -weight);
    }
  }
  Eigen::SparseMatrix<double> matrix(this->Count, this->Count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  if (this->Count > 0)
  {
    this->Factor.Factorize(matrix);
  }
}

void LaplacianSmoothing::Apply(NodeTransforms& motions) const
{
  if (this->Count == 0)
  {
    return;
  }
  // What is solved for is the change: none, to the last bit, where nothing moves.
  Eigen::MatrixXd residual = Eigen::MatrixXd::Zero(this->Count, 3);
  for (const auto& [a, b] : this->Links)
  {
    const Eigen::Vector3d way = (this->Positions.row(a) - this->Positions.row(b)).transpose();
    const double scale = 0.5 * (this->Scales(a) + this->Scales(b));
    const Eigen::Matrix3d turn = 0.5 * scale * (motions.Rotations[a] + motions.Rotations[b]);
    const Eigen::Vector3d wanted = turn * way - way;
    const Eigen::Vector3d off =
      WeightOf(this->Positions, a, b) * (wanted - (motions.Shifts.col(a) - motions.Shifts.col(b)));
    if (this->Unknown[a] >= 0)
    {
      residual.row(this->Unknown[a]) += off.transpose();
    }
    if (this->Unknown[b] >= 0)
    {
      residual.row(this->Unknown[b]) -= off.transpose();
    }
  }
  const Eigen::MatrixXd change = this->Factor.Solve(residual);
  for (std::size_t i = 0; i < this->Unknown.size(); ++i)
  {
    if (this->Unknown[i] >= 0)
    {
      motions.Shifts.col(static_cast<Eigen::Index>(i)) += change.row(this->Unknown[i]).transpose();
    }
  }
}

} // namespace shape
