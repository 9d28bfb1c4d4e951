#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

struct ContractionOptions
{
  double VelocityWeight = 0.1; ///< weight of a point's place; > 0
  double MedialWeight = 0.2;   ///< weight of the centre of a point's medial ball; >= 0
  int MaximumIterations = 100; ///< >= 1
  double ShortestEdge = 0.0;   ///< shorter edges are collapsed, in the surface's units; > 0
};

/**
 * Contracts a closed surface towards its skeleton (Tagliasacchi, Alhashim, Olson and Zhang, "Mean
 * curvature skeletons", 2012). It has almost no volume then, and still the topology of the surface.
 *
 * Each iteration is an implicit step of mean curvature flow that medial balls attract: it solves
 * (L + w_H I + w_M I) x' = w_H x + w_M c, with the cotangent stiffness L, the points x and the
 * centres c of their medial balls (equation 5 of that paper, as the minimum of Dirichlet's energy
 * instead of that of the squared Laplacian: the system is then sparser, and points remain inside
 * the hull of their surroundings). Negative weights of L are 0. Then edges that are too short
 * collapse, if this preserves the topology, and edges between two obtuse angles are split. Points
 * where a part has become as thin as a triangle of shortest edges are fixed.
 *
 * surface: closed, evenly fine. centres: n x 3. Throws SolveFailure if the system cannot be solved;
 * Aborted.
 */
Mesh ContractSurface(const Mesh& surface, const Eigen::MatrixXd& centres,
  const ContractionOptions& options, const Progress& progress = {});

} // namespace shape
