#pragma once

#include "Hex/Polycube/Private/WorkingSolid.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Two adjacent sites, and the cost of giving them different labels.
struct LabelEdge
{
  int First, Second;
  double Weight; ///< >= 0
};

/**
 * Assigns one of six labels, +x, -x, +y, -y, +z, -z, to each site. It minimises approximately the
 * sum of the sites' costs and of the weights of edges between different labels, by alpha-expansion
 * with graph cuts (Boykov, Veksler and Zabih, "Fast approximate energy minimization via graph
 * cuts", 2001). Neighbours never have opposite labels.
 *
 * costs: n x 6, finite. All sites start with the same label.
 */
Eigen::VectorXi SolveGraphCutLabelling(
  const Eigen::MatrixXd& costs, const std::vector<LabelEdge>& edges);

/**
 * Assigns labels 0..5 = +x, -x, +y, -y, +z, -z to the triangles of a solid's surface, by their
 * normals at `positions`. Borders between labels are short and follow creases (Livesu, Vining,
 * Sheffer, Gregson and Scateni, "PolyCut: monotone graph-cuts for PolyCube base-complex
 * construction", 2013, section 3).
 *
 * A label costs 1 - exp(-((n . axis - 1) / 0.2)^2 / 2) for a triangle of the mean area. A border
 * costs compactness exp(-((n . m - 1) / 0.25)^2 / 2) for an edge of the mean length between
 * triangles with normals n and m in the undeformed solid. Neighbours never have opposite labels.
 *
 * positions (n x 3): the deformed points. further (m x 6): additional costs, or empty.
 */
Eigen::VectorXi FindAxisLabels(const WorkingSolid& solid, const Eigen::MatrixXd& positions,
  double compactness, const Eigen::MatrixXd& further = {});

} // namespace shape
