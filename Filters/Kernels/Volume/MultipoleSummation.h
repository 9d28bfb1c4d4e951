#pragma once

#include "Volume/BoxOperators.h"
#include "Volume/SummationTree.h"

namespace shape
{

/// How well, and at what price, the multipole method does.
struct MultipoleEffort
{
  int Nodes = 6;           ///< Gauss points along an edge of a box's cubes, even
  double Threshold = 1e-5; ///< the smallest numbers that are kept, relative to the largest
  int Leaf = 64;           ///< most sources of a box that is not split
  RootError Error = RootError::Small; ///< of the near terms
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
  Eigen::MatrixXd CubeOf(const SummationTree::Box& box, double cube) const;
  void EvaluateCharges(Workspace& work, const Eigen::MatrixXd& places, const double* charges,
    int begin, int end) const;

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
