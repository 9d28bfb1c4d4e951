#pragma once

#include "Fmm/Private/FmmOperators.h"
#include "Fmm/Private/FmmTree.h"

namespace shape
{

/// How well, and at what price, the multipole method does.
struct FmmEffort
{
  FmmAccuracy Boxes;
  RootError BoxError = RootError::Small;  ///< between charges or points and their box
  RootError NearError = RootError::Small; ///< of the near terms
  int Leaf = 64;                          ///< most sources of a box that is not split
};

/**
 * The passes of the multipole method over the boxes: charges to boxes, up, over, down, and to the
 * points, where the sources of touching boxes are summed pair by pair.
 *
 * Real: of the numbers that stand for the boxes; sums over charges and at points are double.
 */
template <typename Real>
class FmmEvaluation
{
public:
  /// sources: m x 3, m > 0; points: n x 3. Throws Aborted.
  FmmEvaluation(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points,
    const FmmEffort& effort, const Progress& progress);

  /// charges: m x k, k <= 3. Returns n x k, or n x 3k for the gradients. Throws Aborted.
  Eigen::MatrixXd Sum(
    const Eigen::MatrixXd& charges, bool gradients, const Progress& progress) const;

private:
  struct Workspace;
  void Collect(Workspace& work, const Progress& progress) const;
  void Translate(Workspace& work, const Progress& progress) const;
  void Evaluate(Workspace& work, const Progress& progress) const;
  Eigen::MatrixXd Around(const FmmTree::Box& box, const Eigen::MatrixXd& cube) const;
  void EvaluateCharges(Workspace& work, const Eigen::MatrixXd& positions, const double* charges,
    int stride, int begin, int end) const;

  FmmEffort Effort;
  FmmOperators<Real> Operators;
  FmmTree Tree;
  Eigen::MatrixXd Sources; ///< 3 x m, scaled, in the tree's order
  Eigen::MatrixXd Points;  ///< n x 3, the same
  std::vector<int> SourceLeaves;
};

extern template class FmmEvaluation<float>;
extern template class FmmEvaluation<double>;

} // namespace shape
