#include "Hex/Releasing.h"

#include "Hex/HexOptimization.h"
#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr int MostRings = 4;
/// The scaled Jacobian below which hexahedra are taken for inverted, once some are.
constexpr double Bad = 0.2;

class Releasing : public PointConstraint
{
public:
  Releasing(const PointConstraint& others, Eigen::Index points)
    : IsFree(points, 0)
    , Others(others)
  {
  }

  int Freedom(int point) const override
  {
    return this->IsFree[point] ? 3 : this->Others.Freedom(point);
  }
  PointDirections Directions(int point, const Eigen::RowVector3d& place) const override
  {
    return this->Others.Directions(point, place);
  }
  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& place) const override
  {
    return this->Others.Nearest(point, place);
  }

  std::vector<char> IsFree;

private:
  const PointConstraint& Others;
};

/// Marks the points of hexahedra of this scaled Jacobian or less; none where there are none.
std::vector<char> PointsOfBad(const HexMesh& mesh, double bad)
{
  const Eigen::VectorXd values = ScaledJacobians(mesh);
  std::vector<char> marked;
  for (Eigen::Index hex = 0; hex < values.size(); ++hex)
  {
    if (values(hex) <= bad)
    {
      marked.resize(mesh.Points.rows(), 0);
      const auto points = mesh.Hexahedra.row(hex);
      std::for_each(points.begin(), points.end(), [&](int point) { marked[point] = 1; });
    }
  }
  return marked;
}

} // namespace

int ReleaseInverted(HexMesh& mesh, const PointConstraint& constraint, const Progress& progress)
{
  if (PointsOfBad(mesh, 0.0).empty())
  {
    return 0;
  }
  const Eigen::MatrixXd before = mesh.Points;
  Releasing releasing(constraint, mesh.Points.rows());
  for (int rings = 0; rings <= MostRings; ++rings)
  {
    std::vector<char> marked = PointsOfBad(mesh, Bad);
    if (marked.empty())
    {
      break;
    }
    GrowRings(mesh.Hexahedra, rings, marked);
    for (std::size_t point = 0; point < marked.size(); ++point)
    {
      releasing.IsFree[point] |= marked[point];
    }
    const Progress part =
      progress.Part(rings / (MostRings + 1.0), (rings + 1.0) / (MostRings + 1.0));
    constexpr int around = 2;
    GrowRings(mesh.Hexahedra, around, marked);
    HexOptimizationOptions options;
    options.Marked = std::move(marked);
    OptimizeHexahedra(mesh, releasing, options, part);
  }
  progress(1.0);
  if (!PointsOfBad(mesh, 0.0).empty())
  {
    mesh.Points = before;
    return 0;
  }
  int count = 0;
  for (Eigen::Index point = 0; point < mesh.Points.rows(); ++point)
  {
    const int id = static_cast<int>(point);
    count += releasing.IsFree[point] && constraint.Freedom(id) < 3 ? 1 : 0;
  }
  return count;
}

} // namespace shape
