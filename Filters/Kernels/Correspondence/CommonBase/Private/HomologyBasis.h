#pragma once

#include "Correspondence/CommonBase/Private/PathSurface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// 2 g loops that span the homology of a closed surface of genus g, and how they link.
struct HomologyBasis
{
  std::vector<std::vector<int>> Loops; ///< points along edges; the last is joined to the first
  /// 2 g x 2 g, the Seifert matrix: entry i, j is the linking number of loop i and of loop j pushed
  /// outwards.
  Eigen::MatrixXi Linking;
};

/**
 * Finds a basis of the homology of a closed connected surface, and sets the surface's forms so that
 * form i has the integral 1 over loop i, 0 over the other loops, and 0 along the marked paths of a
 * tree. isClosing: for each path, whether it closes a loop with earlier ones; paths beyond are not.
 *
 * A spanning tree of the dual graph crosses no path of the tree, and a spanning tree of the points
 * contains all of these and crosses no edge of the former. 2 g edges are in neither. Each closes a
 * loop with the tree of points, and a dual loop with the dual tree, whose crossings with edges are
 * the form (Eppstein, "Dynamic generators of topologically embedded graphs", 2003).
 *
 * The linking numbers are Gauss's integrals. Throws InvalidInput if they are not those of an
 * embedded surface, since then it intersects itself. name: of the surface, in the message.
 */
HomologyBasis FindHomologyBasis(
  PathSurface& surface, const std::vector<bool>& isClosing, const std::string& name);

/// Returns the linking number of two disjoint closed polylines (k x 3 each), up to rounding:
/// Gauss's integral, which for two segments is the solid angle of the directions between them
/// (Klenin and Langowski, "Computation of writhe in modeling of supercoiled DNA", 2000, method 1a).
double ComputeLinkingNumber(const Eigen::MatrixXd& one, const Eigen::MatrixXd& other);

} // namespace shape
