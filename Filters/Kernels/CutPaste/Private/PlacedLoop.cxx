#include "CutPaste/Private/PlacedLoop.h"

#include "Base/Errors.h"
#include "Planar/PlanarLocator.h"

namespace shape
{

double MeanEdgeOf(const Eigen::MatrixXd& loop)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < loop.rows(); ++i)
  {
    sum += (loop.row((i + 1) % loop.rows()) - loop.row(i)).norm();
  }
  return sum / static_cast<double>(loop.rows());
}

bool Contains(const Eigen::MatrixXd& polygon, const Eigen::RowVector2d& position)
{
  bool inside = false;
  for (Eigen::Index i = 0, j = polygon.rows() - 1; i < polygon.rows(); j = i++)
  {
    const Eigen::RowVector2d a = polygon.row(i), b = polygon.row(j);
    if ((a.y() > position.y()) != (b.y() > position.y()) &&
      position.x() < (b.x() - a.x()) * (position.y() - a.y()) / (b.y() - a.y()) + a.x())
    {
      inside = !inside;
    }
  }
  return inside;
}

PlacedLoop PlaceLoop(const ExponentialPatch& patch, const Eigen::MatrixXd& points,
  const Eigen::MatrixXd& normals, const Eigen::MatrixXd& loop, const std::string& elements)
{
  const PlanarLocator locator(patch.Positions, patch.Corners, patch.Torn);
  PlacedLoop placed{ Eigen::MatrixXd(loop.rows(), 3), Eigen::MatrixXd(loop.rows(), 3) };
  int beyond = 0;
  for (Eigen::Index i = 0; i < loop.rows(); ++i)
  {
    const SurfacePoint at = locator.Find(loop.row(i));
    if (at.Triangle < 0)
    {
      ++beyond;
      continue;
    }
    const Eigen::RowVector3i corners = patch.Corners.row(at.Triangle);
    placed.Positions.row(i) = at.Barycentric * points(corners, Eigen::all);
    placed.Normals.row(i) = (at.Barycentric * normals(corners, Eigen::all)).normalized();
  }
  if (beyond > 0)
  {
    throw InvalidInput("the feature does not fit at the seed: " + std::to_string(beyond) +
      " of the " + std::to_string(loop.rows()) + " points of its loop would lie beyond the " +
      elements + " there, or in a gap that is too wide; lower Scale or move Seed");
  }
  return placed;
}

} // namespace shape
