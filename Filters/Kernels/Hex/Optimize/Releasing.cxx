#include "Hex/Optimize/Releasing.h"

#include "Hex/Optimize/HexOptimization.h"
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

void ReleaseInverted(HexMesh& mesh, GivenFreedoms& freedoms, const Progress& progress)
{
  if (!HasInverted(mesh))
  {
    return;
  }
  const Eigen::MatrixXd before = mesh.Points;
  const std::vector<char> given = freedoms.Freedoms;
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
      freedoms.Freedoms[point] = marked[point] ? 3 : freedoms.Freedoms[point];
    }
    const Progress part =
      progress.Part(rings / (MostRings + 1.0), (rings + 1.0) / (MostRings + 1.0));
    constexpr int around = 2;
    GrowRings(mesh.Hexahedra, around, marked);
    HexOptimizationOptions options;
    options.Marked = std::move(marked);
    OptimizeHexahedra(mesh, freedoms, options, part);
  }
  progress(1.0);
  if (HasInverted(mesh))
  {
    mesh.Points = before;
    freedoms.Freedoms = given;
  }
}

void ReleaseWorst(HexMesh& mesh, GivenFreedoms& freedoms, double wanted,
  const std::function<bool(const HexMesh& mesh)>& accepts, const Progress& progress)
{
  for (int rings = 0; rings <= MostRings; ++rings)
  {
    std::vector<char> marked = PointsOfBad(mesh, wanted);
    if (marked.empty())
    {
      break;
    }
    const Eigen::MatrixXd before = mesh.Points;
    const std::vector<char> given = freedoms.Freedoms;
    GrowRings(mesh.Hexahedra, rings, marked);
    for (std::size_t point = 0; point < marked.size(); ++point)
    {
      const bool isOnSurface = freedoms.Freedoms[point] == 2;
      freedoms.Freedoms[point] = marked[point] && isOnSurface ? 3 : freedoms.Freedoms[point];
    }
    HexOptimizationOptions options;
    options.Sweeps = 0; // over all: those near the worst are enough, and stay nearer to the surface
    options.RaiseTo = wanted;
    const HexOptimizationResult result = OptimizeHexahedra(mesh, freedoms, options,
      progress.Part(rings / (MostRings + 1.0), (rings + 1.0) / (MostRings + 1.0)));
    if (result.LeastAfter <= result.LeastBefore || !accepts(mesh))
    {
      mesh.Points = before;
      freedoms.Freedoms = given;
    }
  }
  progress(1.0);
}

} // namespace shape
