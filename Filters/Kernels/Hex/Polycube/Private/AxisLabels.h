#pragma once

#include "Hex/Polycube/Private/WorkingSolid.h"

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

/**
 * Labels 0..5 = +x, -x, +y, -y, +z, -z of the triangles of a solid's surface, by the normals that
 * they have elsewhere, with short borders along creases (Livesu, Vining, Sheffer, Gregson and
 * Scateni, "PolyCut: monotone graph-cuts for PolyCube base-complex construction", 2013, section 3):
 * the cost of a label is 1 - exp(-((n . axis - 1) / 0.2)^2 / 2) for a triangle of the mean area,
 * that of a border compactness exp(-((n . m - 1) / 0.25)^2 / 2) for an edge of the mean length
 * between triangles whose normals at rest are n and m. Opposite labels are never neighbours.
 *
 * positions (n x 3): where the normals are taken. further (m x 6): added to the costs, or empty.
 */
Eigen::VectorXi FindAxisLabels(const WorkingSolid& solid, const Eigen::MatrixXd& positions,
  double compactness, const Eigen::MatrixXd& further = {});

} // namespace shape
