#pragma once

#include "Fmm/Private/BoxOperators.h"
#include "Fmm/Private/SummationTree.h"

namespace shape
{

/// How well, and at what price, the multipole method does.
struct MultipoleEffort
{
  BoxAccuracy Boxes;
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
class MultipoleSummation
{
public:
  /// sources: m x 3, m > 0; points: n x 3. Throws Aborted.
  MultipoleSummation(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points,
    const MultipoleEffort& effort, const Progress& progress);

  /// charges: m x k, k <= 3. Returns n x k, or n x 3k for the gradients. Throws Aborted.
  Eigen::MatrixXd Sum(
    const Eigen::MatrixXd& charges, bool gradients, const Progress& progress) const;

private:
  struct Workspace;
  void Collect(Workspace& work, const Progress& progress) const;
  void Translate(Workspace& work, const Progress& progress) const;
  void Evaluate(Workspace& work, const Progress& progress) const;
  Eigen::MatrixXd Around(const SummationTree::Box& box, const Eigen::MatrixXd& cube) const;
  void EvaluateCharges(Workspace& work, const Eigen::MatrixXd& places, const double* charges,
    int stride, int begin, int end) const;

  MultipoleEffort Effort;
  BoxOperators<Real> Operators;
  SummationTree Tree;
  Eigen::MatrixXd Sources; ///< 3 x m, scaled, in the tree's order
  Eigen::MatrixXd Points;  ///< n x 3, the same
  std::vector<int> SourceLeaves;
};

extern template class MultipoleSummation<float>;
extern template class MultipoleSummation<double>;

} // namespace shape
