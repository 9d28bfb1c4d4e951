#pragma once

#include "Fmm/Private/FmmOperators.h"
#include "Fmm/Private/FmmTree.h"
#include "Fmm/SumDevice.h"

namespace shape
{

/// Accuracy and cost parameters of the multipole method.
struct FmmEffort
{
  FmmAccuracy Boxes;
  RootError BoxError = RootError::Small;  ///< error of 1/r between a box and its charges or points
  RootError NearError = RootError::Small; ///< error of 1/r between near points and sources
  int Leaf = 64;                          ///< maximum number of sources in a box that is not split
};

/**
 * The passes of the multipole method: from charges to boxes, up to parents, across to the boxes of
 * the V list, down to children, and to the points. The sources of near boxes are summed directly,
 * on an OpenCL device if it is worth it.
 *
 * Real: number type of the box expansions. Sums over charges and sums at points are in double.
 */
template <typename Real>
class FmmEvaluation
{
public:
  /// sources: m x 3, m > 0; points: n x 3. Throws Aborted.
  FmmEvaluation(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points,
    const FmmEffort& effort, const Progress& progress);

  /// charges: m x k, with k <= 3. Returns the potentials (n x k) or the gradients (n x 3k). device:
  /// where near sources are summed. Throws InvalidInput if there is no such device, and Aborted.
  Eigen::MatrixXd Sum(const Eigen::MatrixXd& charges, bool gradients, const SumDevice& device,
    const Progress& progress) const;

private:
  struct Workspace;
  void Collect(Workspace& work, const Progress& progress) const;
  void Translate(Workspace& work, const Progress& progress) const;
  bool SetNearOnDevice(Workspace& work, const SumDevice& device, const Progress& progress) const;
  void AddNear(Workspace& work, int leaf) const;
  void Evaluate(Workspace& work, bool nearIsSet, const Progress& progress) const;
  Eigen::MatrixXd Around(const FmmTree::Box& box, const Eigen::MatrixXd& cube) const;
  void EvaluateCharges(Workspace& work, const Eigen::MatrixXd& positions, const double* charges,
    int stride, int begin, int end) const;

  FmmEffort Effort;
  FmmOperators<Real> Operators;
  FmmTree Tree;
  Eigen::MatrixXd Sources; ///< 3 x m, scaled, in the order of the tree
  Eigen::MatrixXd Points;  ///< n x 3, scaled, in the order of the tree
  std::vector<int> SourceLeaves;
  double NearPairs = 0.0; ///< number of pairs of points and near sources
};

extern template class FmmEvaluation<float>;
extern template class FmmEvaluation<double>;

} // namespace shape
