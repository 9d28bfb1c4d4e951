#pragma once

#include "Linear/SparseSolve.h"
#include "Untangle/EnergyProblem.h"

#include <Eigen/SparseCore>

#include <array>
#include <vector>

namespace shape
{

/**
 * The regularised elliptic energy of a patch, and its Newton directions, on points of its own:
 * columns, those of patch.FreePoints first. The patch and the constraint must outlive it.
 */
class FoldoverFreeProblem : public EnergyProblem
{
public:
  FoldoverFreeProblem(
    const Eigen::MatrixXd& points, const SimplexPatch& patch, const PointConstraint* constraint);

  int CountNegative(const Eigen::Matrix3Xd& x) const override;
  State Evaluate(const Eigen::Matrix3Xd& x, double epsilon) const override;
  Descent NewtonDirection(const Eigen::Matrix3Xd& x, double epsilon) override;
  void Move(Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& direction, double step) const override;

  Eigen::Matrix3Xd Start; ///< 3 x local points

private:
  Eigen::Matrix3d JacobianOf(std::size_t simplex, const Eigen::Matrix3Xd& x) const;

  int Width(int point) const { return this->FirstUnknown[point + 1] - this->FirstUnknown[point]; }

  PointDirections BasisOf(int point, const Eigen::Matrix3Xd& x) const;

  void NumberUnknowns();

  /// All columns of a point have the same rows: block (u, v) starts at Slots in the first of them.
  void MakePattern();

  void AddSimplex(std::size_t i, const Eigen::Matrix3Xd& x, double epsilon, double share,
    const std::vector<PointDirections>& bases, Eigen::VectorXd& gradient);

  void Scatter(int column, int slot, const Eigen::Ref<const Eigen::MatrixXd>& block);

  Descent Solve(const std::vector<PointDirections>& bases, const Eigen::VectorXd& gradient);

  const SimplexPatch& Patch;
  const PointConstraint* Constraint;
  int FreeCount;
  std::vector<std::array<int, 4>> Corners;
  std::vector<std::array<int, 16>> Slots; ///< see MakePattern; -1: a point that is not free
  std::vector<int> FirstUnknown;          ///< of each free point, and how many there are
  std::vector<int> ColumnLengths;

  Eigen::SparseMatrix<double> Matrix;
  SparseCholesky Cholesky;
};

} // namespace shape
