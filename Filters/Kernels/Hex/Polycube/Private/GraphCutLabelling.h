#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Two sites side by side, and what it costs where their labels differ.
struct LabelEdge
{
  int First, Second;
  double Weight; ///< >= 0
};

/**
 * One of six labels, +x, -x, +y, -y, +z, -z, for each site, such that the sum of the sites' costs
 * and the weights of edges between different labels is low: alpha-expansion by graph cuts (Boykov,
 * Veksler and Zabih, "Fast approximate energy minimization via graph cuts", 2001). Neighbours never
 * have opposite labels.
 *
 * costs: n x 6, finite. Starts from one label for all.
 */
Eigen::VectorXi SolveGraphCutLabelling(
  const Eigen::MatrixXd& costs, const std::vector<LabelEdge>& edges);

} // namespace shape
