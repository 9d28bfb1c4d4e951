#include "Hex/Optimize/BoundaryRelaxation.h"

#include "Hex/Optimize/HexOptimization.h"
#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr int MaximumRings = 4;
/// If some hexahedra are inverted, those below this scaled Jacobian are treated as inverted, too.
constexpr double Bad = 0.2;

bool HasInverted(const HexMesh& mesh)
{
  return ComputeScaledJacobians(mesh).minCoeff() <= 0.0;
}

/// Releases points around inverted hexahedra that have at least this freedom, in rounds with
/// growing neighbourhoods.
void ReleaseInverted(
  HexMesh& mesh, OverridableConstraint& freedoms, char least, const Progress& progress)
{
  for (int rings = 0; rings <= MaximumRings; ++rings)
  {
    std::vector<char> marked = MarkPointsOfBadHexahedra(mesh, Bad);
    if (marked.empty())
    {
      break;
    }
    GrowRings(mesh.Hexahedra, rings, marked);
    for (std::size_t point = 0; point < marked.size(); ++point)
    {
      char& freedom = freedoms.Freedoms[point];
      freedom = marked[point] && freedom >= least ? 3 : freedom;
    }
    // Points that keep to the surface move with the released ones.
    constexpr int around = 2;
    GrowRings(mesh.Hexahedra, around, marked);
    HexOptimizationOptions options;
    options.Marked = std::move(marked);
    OptimizeHexahedra(mesh, freedoms, options,
      progress.Part(rings / (MaximumRings + 1.0), (rings + 1.0) / (MaximumRings + 1.0)));
  }
}

} // namespace

void RelaxBoundaryOfInverted(
  HexMesh& mesh, OverridableConstraint& freedoms, const Progress& progress)
{
  const Eigen::MatrixXd before = mesh.Points;
  const std::vector<char> given = freedoms.Freedoms;
  double begin = 0.0;
  for (const char least : { 2, 0 })
  {
    if (!HasInverted(mesh))
    {
      break;
    }
    ReleaseInverted(mesh, freedoms, least, progress.Part(begin, begin + 0.5));
    begin += 0.5;
    if (HasInverted(mesh))
    {
      mesh.Points = before;
      freedoms.Freedoms = given;
    }
  }
  progress(1.0);
}

// In each round one more ring around the worst hexahedra leaves the surface. On a femur this raises
// the worst scaled Jacobian from 0.29 to 0.59, on bones from 0.30 to 0.55.
void RelaxBoundaryOfWorst(HexMesh& mesh, OverridableConstraint& freedoms, double wanted,
  const std::function<bool(const HexMesh& mesh)>& accepts, const Progress& progress)
{
  for (int rings = 0; rings <= MaximumRings; ++rings)
  {
    std::vector<char> marked = MarkPointsOfBadHexahedra(mesh, wanted);
    if (marked.empty())
    {
      break;
    }
    const Eigen::MatrixXd before = mesh.Points;
    const std::vector<char> given = freedoms.Freedoms;
    GrowRings(mesh.Hexahedra, rings, marked);
    for (std::size_t point = 0; point < marked.size(); ++point)
    {
      // Points on creases and corners keep their lower freedom.
      const bool isOnSurface = freedoms.Freedoms[point] == 2;
      freedoms.Freedoms[point] = marked[point] && isOnSurface ? 3 : freedoms.Freedoms[point];
    }
    HexOptimizationOptions options;
    options.Sweeps = 0; // moving points near the worst suffices and stays closer to the surface
    options.RaiseTo = wanted;
    options.Bad = std::min(options.Bad, wanted + BadAbove);
    const HexOptimizationResult result = OptimizeHexahedra(mesh, freedoms, options,
      progress.Part(rings / (MaximumRings + 1.0), (rings + 1.0) / (MaximumRings + 1.0)));
    // A round without gain is undone, and the next one tries a larger neighbourhood.
    if (result.MinimumAfter <= result.MinimumBefore || !accepts(mesh))
    {
      mesh.Points = before;
      freedoms.Freedoms = given;
    }
  }
  progress(1.0);
}

} // namespace shape
