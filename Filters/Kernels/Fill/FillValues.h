#pragma once

#include "Fill/FillHoles.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Where the fill of a hole has its data from.
struct FillSources
{
  std::vector<int> Points;    ///< of each of its points: the nearest one of the rim
  std::vector<int> Triangles; ///< of each triangle: one of the surface's at the rim, the nearest
};

/// Of each fill. surface: with the fills, whose triangles are behind all others. Neither is empty
/// where the fill is not; a triangle is -1 where the rim has none.
std::vector<FillSources> FindFillSources(const Mesh& surface, const std::vector<FilledHole>& holes);

/// Values of a fill's points (hole.Points x d) from those at its rim: smooth continuations
/// (SolveHarmonicValues). values: n x d, of all points; the others' rows mean nothing.
Eigen::MatrixXd ExtendValuesOntoFill(
  const Mesh& surface, const FilledHole& hole, const Eigen::MatrixXd& values);

} // namespace shape
