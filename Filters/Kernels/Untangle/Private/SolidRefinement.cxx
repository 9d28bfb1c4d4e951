#include "Untangle/Private/SolidRefinement.h"

#include "Quality/CellSimplices.h"
#include "Untangle/Private/TutteEmbedding.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

/// The corner tetrahedra of the cells that are not inverted. moves: for each point, whether it may
/// move; points of inverted cells may not.
SimplexElements<3> BuildElements(
  SolidCells& solid, std::vector<char>& moves, const Progress& progress)
{
  // With rest positions, the measure is that of the map from them. Else the size is the target's.
  const bool hasRest = solid.Rest.rows() > 0;
  const Eigen::VectorXd sizes =
    hasRest ? Eigen::VectorXd() : ComputeLogarithmicSizes(solid, progress);
  std::vector<std::array<int, 4>> simplices;
  std::vector<Eigen::Matrix3d> edges;
  std::vector<double> volumes;
  for (int cell = 0; cell < solid.CellCount(); ++cell)
  {
    if (cell % ReportInterval == 0)
    {
      progress(static_cast<double>(cell) / solid.CellCount());
    }
    if (solid.Inverted(cell))
    {
      for (const int point : solid.PointsOf(cell))
      {
        moves[point] = 0;
      }
      continue;
    }
    const std::vector<std::array<int, 4>> own = solid.SimplicesOf(cell);
    for (std::size_t k = 0; k < own.size(); ++k)
    {
      double size = 0.0;
      for (const int point : own[k])
      {
        size += hasRest ? 0.0 : 0.25 * sizes(point);
      }
      simplices.push_back(own[k]);
      edges.push_back(solid.Reference(cell, static_cast<int>(k), std::exp(size)));
      volumes.push_back(solid.ShareOf(cell) * edges.back().determinant());
    }
  }
  const auto count = static_cast<Eigen::Index>(simplices.size());
  Eigen::MatrixXi corners(count, 4);
  for (Eigen::Index t = 0; t < count; ++t)
  {
    corners.row(t) << simplices[t][0], simplices[t][1], simplices[t][2], simplices[t][3];
  }
  return { std::move(corners), edges, Eigen::Map<const Eigen::VectorXd>(volumes.data(), count) };
}

} // namespace

InjectiveRefinementResult RefineSolid(SolidCells& solid, const SlidingBoundary* sliding,
  const InjectiveRefinementOptions& options, const Progress& progress)
{
  std::vector<char> moves(solid.PointCount(), 1);
  const SimplexElements<3> elements = BuildElements(solid, moves, progress.Part(0.0, 0.0));
  if (elements.Count() == 0)
  {
    return { solid.Points, 0.0, 0.0, 0 };
  }
  PointMotion<3> motion;
  motion.Freedom.assign(solid.PointCount(), 0);
  for (int point = 0; point < solid.PointCount(); ++point)
  {
    if (moves[point])
    {
      motion.Freedom[point] = !solid.OnBoundary(point) ? 3 : sliding ? sliding->Freedom(point) : 0;
    }
  }
  if (sliding)
  {
    motion.Directions = [sliding](int point, const Eigen::RowVector3d& position)
    { return sliding->Directions(point, position); };
    motion.Nearest = [sliding](int point, const Eigen::RowVector3d& position)
    { return sliding->Nearest(point, position); };
  }
  InjectiveRefinementResult result =
    RefineInjectively<3>(elements, solid.Points, motion, options, progress);
  solid.Points = result.Points;
  return result;
}

} // namespace shape
