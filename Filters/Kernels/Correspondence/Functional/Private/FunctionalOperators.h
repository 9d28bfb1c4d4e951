#pragma once

#include "Base/Progress.h"
#include "Correspondence/Functional/FunctionalMapFitOptions.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The operators of one surface in the basis of its first k eigenfunctions: an operator T is the
/// k x k matrix phi' M T phi.
struct FunctionalOperators
{
  Eigen::MatrixXd Coefficients; ///< k x q: the descriptors' inner products with the basis
  ///@{
  /// P and O of FitFunctionalMap, one of each for every chosen descriptor; empty where the weight
  /// is 0.
  std::vector<Eigen::MatrixXd> Products, Turns;
  ///@}
  std::vector<Eigen::MatrixXd> Displacements; ///< N; none if the weight is 0
  std::vector<Eigen::MatrixXd> Curves;        ///< K of FitFunctionalMap; none if the weight is 0
};

/// Throws Aborted.
FunctionalOperators ComputeFunctionalOperators(const SurfaceDescriptors& surface,
  const FunctionalMapFitOptions& options, const Progress& progress = {});

} // namespace shape
