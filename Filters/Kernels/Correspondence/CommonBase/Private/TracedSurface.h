#pragma once

#include "Correspondence/CommonBase/Private/BaseGraph.h"
#include "Correspondence/CommonBase/Private/HomologyBasis.h"
#include "Correspondence/CommonBase/Private/PathSurface.h"
#include "Correspondence/CommonBase/Private/StripPaths.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace shape
{

/// One of the two surfaces while paths are traced on it.
struct TracedSurface
{
  PathSurface Surface;
  std::string Name;
  std::vector<int> Nodes; ///< the landmarks, and where curves are divided
  double Size;            ///< the root of the area
  std::vector<std::vector<int>> Paths = {};
  HomologyBasis Basis = {};
  /// For each handle that has been cut, the homology of the loops of its two paths.
  std::vector<std::array<Eigen::VectorXi, 2>> Cuts = {};

  /// Returns the gap of a corner.
  SurfaceGap GapOf(const BaseGraph& graph, int corner) const;
  /// Returns the corner to the right of an edge that leaves a node: where a path along it begins.
  int CornerBefore(const BaseGraph& graph, int node, int next) const;
  /// Returns the integrals of the forms along a path.
  FormValues FormsAlong(int path) const;
  /// Returns the homology of the loop of a path and the tree, without its turns around handles that
  /// have been cut: its intersection numbers with the loops of the cuts are 0.
  Eigen::VectorXi HomologyOf(const FormValues& forms) const;
  /// Whether a loop bounds inside the surface, or outside: it is then not linked with any loop on
  /// the other side (BaseDomain.h).
  bool Bounds(const Eigen::VectorXi& loop, bool inside) const;
  /// Returns how often two loops cross, with signs.
  int Crossings(const Eigen::VectorXi& one, const Eigen::VectorXi& other) const;
  /// Returns the patch of each triangle. patches: their sides (BaseDomain::Patches).
  Eigen::VectorXi FindPatches(const std::vector<std::array<int, 3>>& patches) const;
};

} // namespace shape
