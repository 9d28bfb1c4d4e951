#include "Correspondence/Consistent/Private/CycleErrors.h"

#include "Correspondence/Evaluate/InvertMap.h"
#include "Correspondence/Pair/MapPositions.h"
#include "Geodesics/HeatGeodesics.h"
#include "Search/NearestSurfacePoints.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace shape
{
std::vector<std::array<int, 3>> FindTriples(const std::vector<CandidatePair>& pairs)
{
  std::map<std::array<int, 2>, int> known;
  for (const CandidatePair& pair : pairs)
  {
    if (!pair.Maps.empty())
    {
      known[{ pair.A, pair.B }] = 1;
    }
  }
  std::vector<std::array<int, 3>> triples;
  for (auto one = known.begin(); one != known.end(); ++one)
  {
    for (auto next = std::next(one); next != known.end() && next->first[0] == one->first[0]; ++next)
    {
      if (known.count({ one->first[1], next->first[1] }) > 0)
      {
        triples.push_back({ one->first[0], one->first[1], next->first[1] });
      }
    }
  }
  constexpr std::size_t most = 300;
  std::vector<std::array<int, 3>> some;
  for (std::size_t t = 0; t < std::min(most, triples.size()); ++t)
  {
    some.push_back(triples[t * triples.size() / std::min(most, triples.size())]);
  }
  return some;
}

PositionMap MapsOverTemplate(
  const std::vector<Surface>& surfaces, std::size_t central, const std::vector<SurfaceMaps>& maps)
{
  const auto inverses = std::make_shared<std::map<int, MapInverse>>();
  return [&surfaces, &maps, central, inverses](int from, int to, const SurfacePoints& positions)
  {
    const Surface& base = surfaces[central];
    const MapInverse& inverse =
      inverses->try_emplace(to, surfaces[to], maps[to].AToB, base).first->second;
    return inverse.Find(MapPositions(positions, surfaces[from].Triangles(), maps[from].AToB, base));
  };
}

PositionMap MapsOfPairs(const std::vector<Surface>& surfaces,
  const std::vector<MatchedSurface>& matched, const std::vector<CandidatePair>& pairs)
{
  std::map<std::array<int, 2>, const CandidatePair*> known;
  for (const CandidatePair& pair : pairs)
  {
    known[{ pair.A, pair.B }] = &pair;
  }
  return [&surfaces, &matched, known](int from, int to, const SurfacePoints& positions)
  {
    const FunctionalMaps& maps = known.at({ std::min(from, to), std::max(from, to) })->Maps.front();
    const Eigen::MatrixXd& back = from < to ? maps.BToA : maps.AToB;
    return FindNearestSurfacePoints(PullBack(positions, surfaces[from].Triangles(),
                                      matched[from].Spectrum.Eigenfunctions.leftCols(back.rows())),
      surfaces[to].Triangles(),
      matched[to].Spectrum.Eigenfunctions.leftCols(back.cols()) * back.transpose());
  };
}

double MeasureCycles(const std::vector<Surface>& surfaces,
  const std::vector<std::vector<int>>& starts, const std::vector<std::array<int, 3>>& triples,
  const PositionMap& map, const Progress& progress)
{
  std::map<int, Eigen::MatrixXd> distances;
  double sum = 0.0;
  for (std::size_t t = 0; t < triples.size(); ++t)
  {
    progress(static_cast<double>(t) / static_cast<double>(triples.size()));
    const auto& [a, b, c] = triples[t];
    if (distances.count(a) == 0)
    {
      distances[a] = ComputeHeatDistances(surfaces[a], starts[a]) /
        std::sqrt(ComputePointAreas(surfaces[a]).sum());
    }
    const SurfacePoints begin =
      MakeSurfacePointsAtVertices(Eigen::Map<const Eigen::VectorXi>(
                                    starts[a].data(), static_cast<Eigen::Index>(starts[a].size())),
        surfaces[a]);
    const SurfacePoints end = map(c, a, map(b, c, map(a, b, begin)));
    sum += PullBack(end, surfaces[a].Triangles(), distances[a]).diagonal().mean();
  }
  return sum / static_cast<double>(triples.size());
}

} // namespace shape
