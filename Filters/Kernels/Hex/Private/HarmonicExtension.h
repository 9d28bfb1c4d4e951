#pragma once

#include "Base/Progress.h"
#include "Linear/DirichletProblem.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <utility>
#include <vector>

namespace shape
{

/// Extends values from some points to others by the discrete harmonic functions of edges: each
/// other value is the mean of its neighbours'.
class HarmonicExtension
{
public:
  /// edges: pairs of points; a repeated edge counts repeatedly. isGiven: one flag for each point.
  /// Throws SolveFailure if a point is not connected to a given one, and Aborted.
  HarmonicExtension(const std::vector<std::pair<int, int>>& edges, const std::vector<char>& isGiven,
    const Progress& progress = {});

  /// values: one row for each point. Replaces those that are not given. Throws Aborted.
  void Extend(Eigen::MatrixXd& values, const Progress& progress = {}) const;

private:
  std::vector<int> Others; ///< points without a given value
  Eigen::SparseMatrix<double> Stiffness;
  std::unique_ptr<DirichletProblem> Problem; ///< null if all values are given
};

/// Returns the edges of hexahedra (m x 8, in VTK's order), once for each hexahedron.
std::vector<std::pair<int, int>> ListHexEdges(const Eigen::MatrixXi& hexahedra);

} // namespace shape
