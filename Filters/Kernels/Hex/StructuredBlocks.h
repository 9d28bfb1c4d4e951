#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

struct BlockSplineOptions
{
  int Degree = 3; ///< of the splines along each axis; 1 to 9, lower where a block has few nodes
  /// The number of nodes along each axis for one control point; >= 1. With 2, a spline has about an
  /// eighth of the nodes.
  double NodesPerControl = 2.0;
};

/// A trivariate tensor-product B-spline over a structured block, on [0, 1] along each axis.
struct BlockSpline
{
  Eigen::RowVector3i Counts;            ///< control points along each axis
  std::array<Eigen::VectorXd, 3> Knots; ///< clamped: the first and last are repeated
  Eigen::MatrixXd Controls;             ///< rows along the first axis first
};

/// A structured block of a grid.
struct GridBlock
{
  Eigen::RowVector3i Counts; ///< nodes along each axis
  Eigen::VectorXi Nodes;     ///< point of the grid for each node, along the first axis first
};

/// Collects the nodes of each block. cells: m x 8, in VTK's order along the axes of positions
/// (n x 3). blockOf: from 0. indices: m x 3. Throws InvalidInput if a block is not a box of cells.
std::vector<GridBlock> FindGridBlocks(const Eigen::MatrixXi& cells,
  const Eigen::MatrixXd& positions, const Eigen::VectorXi& blockOf, const Eigen::MatrixXi& indices);

/**
 * Fits a spline to values at the nodes of a block, which have equal distances in each direction.
 *
 * Along an axis, the ends are interpolated, and the other control points minimise the sum of
 * squares (Piegl and Tiller, "The NURBS Book", 1997, section 9.4.1). Three such fits, one along
 * each axis, give the control points. Those of a side depend on its nodes alone, so that splines of
 * blocks that share a side agree on it.
 *
 * values (n x d): one row for each node. Throws InvalidInput if an option is out of range.
 */
BlockSpline FitBlockSpline(const Eigen::RowVector3i& counts, const Eigen::MatrixXd& values,
  const BlockSplineOptions& options = {});

/// Returns the values of the basis functions (columns) of such a spline along an axis, at its nodes
/// (rows). nodes: >= 2. Throws InvalidInput if an option is out of range.
Eigen::MatrixXd ComputeNodeBasis(int nodes, const BlockSplineOptions& options = {});

/// Evaluates a spline. parameters: k x 3, in [0, 1]; others are moved to the nearest of these.
/// Throws Aborted.
Eigen::MatrixXd Evaluate(
  const BlockSpline& spline, const Eigen::MatrixXd& parameters, const Progress& progress = {});

/// Returns the parameters of the nodes of a block: k x 3, along the first axis first.
Eigen::MatrixXd NodeParameters(const Eigen::RowVector3i& counts);

} // namespace shape
