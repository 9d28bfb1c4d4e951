#include "Hex/Releasing.h"

#include "Hex/HexOptimization.h"
#include "Quality/ScaledJacobian.h"

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

bool HasInverted(const HexMesh& mesh)
{
  return ScaledJacobians(mesh).minCoeff() <= 0.0;
}

} // namespace

int ReleaseInverted(HexMesh& mesh, const PointConstraint& constraint, const Progress& progress)
{
  if (!HasInverted(mesh))
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
  if (HasInverted(mesh))
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
