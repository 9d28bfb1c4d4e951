#pragma once

#include "Base/Progress.h"
#include "Correspondence/CommonBase/BaseDomain.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// Positions in the plane are multiples of this.
constexpr double BaseGridStep = 0x1p-44;

/**
 * Each patch of a base domain in the plane, as the triangle with the corners (0, 0), (1, 0), (0,
 * 1), at the beginnings of its three sides.
 */
struct BaseEmbedding
{
  /// One for each patch: its points, a row each. A point of a path is in the patches on both sides.
  std::vector<Mesh> Patches;
  std::vector<std::vector<int>> Triangles; ///< for each patch, its triangles on the divided surface
  Eigen::VectorXi RowOf; ///< for each corner 3 t + k of the divided surface, its row in its patch
};

/**
 * Maps each patch of a surface to a triangle by a convex combination map with mean value weights
 * (Floater, "Mean value coordinates", 2003), with each path at constant speed. Two surfaces with
 * one base domain therefore agree along the paths. All positions are multiples of 2^-44, so a path
 * has exactly the same positions in the patches on both of its sides.
 *
 * Every triangle of the plane is counter-clockwise, by exact predicates, so each patch is mapped
 * one to one. name: of the surface, in messages. Throws SolveFailure if triangles are too small for
 * this precision; Aborted.
 */
BaseEmbedding EmbedPatches(const BaseDomain& domain, const PatchedSurface& surface,
  const std::string& name, const Progress& progress = {});

} // namespace shape
