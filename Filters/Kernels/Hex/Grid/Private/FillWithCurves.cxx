#include "Hex/Grid/Private/FillWithCurves.h"

#include "Hex/Features/PatchedBoundary.h"

#include <set>
#include <utility>

namespace shape
{
namespace
{

/// Whether the boundary of hexahedra has a chain of edges for each curve of the features.
bool HasAllCurves(const HexMesh& mesh, const Surface& surface, const SurfaceFeatures& features)
{
  std::set<int> unmatched;
  return features.Curves.empty() || MatchFeatures(mesh, surface, features, unmatched).has_value();
}

} // namespace

std::optional<GridCells> FillWithCurves(MultiMaterialVoxels& regions, const Surface& surface,
  const HexMeshOptions& options, double size, double minimum, const GridDensity& warp,
  const Progress& progress)
{
  constexpr int sizes = 4;
  constexpr double smaller = 0.97;
  std::optional<GridCells> first;
  for (int i = 0; i < sizes && size >= minimum; ++i, size *= smaller)
  {
    for (const VoxelRule rule :
      { options.Draft ? VoxelRule::Any : VoxelRule::Connected, VoxelRule::Centres })
    {
      std::optional<RegionCells> cells = regions.Fill(size, warp, progress, rule);
      if (!cells)
      {
        if (!first)
        {
          return std::nullopt;
        }
        continue;
      }
      SurfaceFeatures features = FindFeatures(surface, options, size);
      // The topology of a surface that crosses itself is guessed from grids: no other ones.
      if (HasAllCurves(cells->Solid, surface, features) || regions.Outer().Boundary().Crossings > 0)
      {
        return GridCells{ std::move(*cells), std::move(features), size };
      }
      if (!first)
      {
        first = GridCells{ std::move(*cells), std::move(features), size };
      }
    }
  }
  return first;
}

} // namespace shape
