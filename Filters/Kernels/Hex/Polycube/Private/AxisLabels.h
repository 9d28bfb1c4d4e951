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
 * Assigns one of six labels (+x, -x, +y, -y, +z, -z) to each of n sites. The labels approximately
 * minimise a sum: their costs, plus the weights of the edges whose two sites have different labels.
 * The sum is lowered by alpha-expansion with graph cuts (Boykov, Veksler and Zabih, "Fast
 * approximate energy minimization via graph cuts", 2001). Adjacent sites never have opposite
 * labels.
 *
 * costs (n x 6): the cost of each label at each site, finite. All sites start with the same label.
 */
Eigen::VectorXi SolveGraphCutLabelling(
  const Eigen::MatrixXd& costs, const std::vector<LabelEdge>& edges);

/**
 * Assigns a label 0..5 = +x, -x, +y, -y, +z, -z to each triangle of a solid's surface, according to
 * its normal when the points are at `positions`. Borders between labels are short and follow
 * creases (Livesu, Vining, Sheffer, Gregson and Scateni, "PolyCut: monotone graph-cuts for PolyCube
 * base-complex construction", 2013, section 3).
 *
 * For a triangle of mean area with normal n, a label costs 1 - exp(-((n . axis - 1) / 0.2)^2 / 2).
 * For an edge of mean length, a border costs compactness times exp(-((n . m - 1) / 0.25)^2 / 2).
 * Here n and m are the normals of the edge's triangles in the undeformed solid. Adjacent triangles
 * never have opposite labels.
 *
 * positions (n x 3): the points of the deformed solid. further (m x 6, or empty): additional costs
 * of each label for each triangle.
 */
Eigen::VectorXi FindAxisLabels(const WorkingSolid& solid, const Eigen::MatrixXd& positions,
  double compactness, const Eigen::MatrixXd& further = {});

} // namespace shape
