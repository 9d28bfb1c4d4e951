#include "Hex/Releasing.h"

#include "Hex/GivenFreedoms.h"
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
  GivenFreedoms releasing(constraint, mesh.Points.rows());
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
      releasing.Freedoms[point] = marked[point] ? 3 : releasing.Freedoms[point];
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
    count += releasing.Freedom(id) > constraint.Freedom(id) ? 1 : 0;
  }
  return count;
}

} // namespace shape
