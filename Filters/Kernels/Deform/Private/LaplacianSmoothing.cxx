#include "Deform/Private/LaplacianSmoothing.h"

namespace shape
{
namespace
{

double ComputeLinkWeight(const Eigen::MatrixXd& positions, int a, int b)
{
  return 1.0 / (positions.row(a) - positions.row(b)).norm();
}

} // namespace

Eigen::SparseMatrix<double> BuildGraphLaplacian(
  const Eigen::MatrixXd& positions, const std::vector<std::pair<int, int>>& links)
{
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [a, b] : links)
  {
    const double weight = ComputeLinkWeight(positions, a, b);
    entries.emplace_back(a, a, weight);
    entries.emplace_back(b, b, weight);
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
  }
  Eigen::SparseMatrix<double> laplacian(positions.rows(), positions.rows());
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

LaplacianSmoothing::LaplacianSmoothing(const NodeProblem& problem, const Progress& progress)
  : Positions(problem.Graph.Positions)
  , Scales(problem.Scales)
  , Links(ListLinks(problem.Graph))
  , Laplacian(BuildGraphLaplacian(this->Positions, this->Links))
  , Problem(this->Laplacian, problem.Sources, progress)
{
}

/// Equation 3 as a post-process (section 5, Fig. 16): the edge vectors are rotated by the rotations
/// found, and the positions that fit them best are solved for, with the sources fixed.
void LaplacianSmoothing::Apply(NodeTransforms& motions) const
{
  // The unknown is the change, which is exactly 0 if nothing moves.
  Eigen::MatrixXd residual = Eigen::MatrixXd::Zero(this->Positions.rows(), 3);
  for (const auto& [a, b] : this->Links)
  {
    const Eigen::Vector3d edge = (this->Positions.row(a) - this->Positions.row(b)).transpose();
    const double scale = 0.5 * (this->Scales(a) + this->Scales(b));
    // An edge rotates like the mean of its ends.
    const Eigen::Matrix3d turn = 0.5 * scale * (motions.Rotations[a] + motions.Rotations[b]);
    const Eigen::Vector3d wanted = turn * edge - edge;
    const Eigen::Vector3d missing = ComputeLinkWeight(this->Positions, a, b) *
      (wanted - (motions.Shifts.col(a) - motions.Shifts.col(b)));
    residual.row(a) += missing.transpose();
    residual.row(b) -= missing.transpose();
  }
  Eigen::MatrixXd change = Eigen::MatrixXd::Zero(this->Positions.rows(), 3);
  this->Problem.Solve(change, residual);
  motions.Shifts += change.transpose();
}

} // namespace shape
