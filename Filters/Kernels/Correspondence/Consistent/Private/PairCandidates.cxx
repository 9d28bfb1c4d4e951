#include "Correspondence/Consistent/Private/PairCandidates.h"

#include "Correspondence/Functional/FunctionalMap.h"

#include <algorithm>
#include <utility>

namespace shape
{
namespace
{

/// The functional map from landmarks, of `size` functions, fitted to its point maps.
FunctionalMaps MapByLandmarks(const MatchedSurface& a, const MatchedSurface& b,
  const Landmarks& landmarks, int size, const Progress& progress)
{
  FunctionalMapOptions options;
  options.Refinement.Last = size;
  const SurfaceMaps maps = ComputeFunctionalMap(a.Surface, b.Surface, landmarks, options, progress);
  const Eigen::MatrixXd ofA = a.Spectrum.Eigenfunctions.leftCols(size),
                        ofB = b.Spectrum.Eigenfunctions.leftCols(size);
  Eigen::MatrixXd fromA(ofA.rows() + ofB.rows(), size), fromB(fromA.rows(), size);
  fromA << ofA, PullBack(maps.BToA, a.Surface.Triangles(), ofA);
  fromB << PullBack(maps.AToB, b.Surface.Triangles(), ofB), ofB;
  return { FitCoefficients(fromA, fromB), FitCoefficients(fromB, fromA) };
}

std::vector<LandmarkCandidate> FindCandidates(const MatchedSurface& a, const MatchedSurface& b,
  const Landmarks& landmarks, int size, const ConsistentMapsOptions& options,
  const Progress& progress)
{
  constexpr std::size_t enough = 3; // landmarks: fewer do not tell the sides
  if (landmarks.size() < enough)
  {
    return FindLandmarkCandidates(a, b, options.Landmarks, progress);
  }
  LandmarkCandidate given;
  given.Pairs = landmarks;
  given.Maps = MapByLandmarks(a, b, landmarks, size, progress);
  return { given };
}

} // namespace

Landmarks FindCommonLandmarks(const NumberedPoints& a, const NumberedPoints& b)
{
  Landmarks common;
  for (const auto& [number, point] : a)
  {
    const auto partner = b.find(number);
    if (partner == b.end())
    {
      continue;
    }
    const std::array<int, 2> pair{ point, partner->second };
    if (std::none_of(common.begin(), common.end(),
          [&](const auto& other) { return other[0] == pair[0] || other[1] == pair[1]; }))
    {
      common.push_back(pair);
    }
  }
  return common;
}

// Numbers that every process knows the position of are added up: of each candidate the error and
// the maps.
std::vector<CandidatePair> MatchPairs(const std::vector<MatchedSurface>& shapes,
  const std::vector<std::array<int, 2>>& graph, const std::vector<NumberedPoints>& numbered,
  const ConsistentMapsOptions& options, const PairSharing& sharing, const Progress& progress)
{
  const auto sizeOf = [&](std::size_t p)
  {
    constexpr Eigen::Index most = 60; // FindLandmarkCandidates
    return std::min({ most, shapes[graph[p][0]].Spectrum.Eigenvalues.size(),
      shapes[graph[p][1]].Spectrum.Eigenvalues.size() });
  };
  std::vector<std::vector<double>> values(graph.size());
  const auto match = [&](std::size_t p)
  {
    const auto partOf = [&](std::size_t index)
    { return static_cast<double>(index) / static_cast<double>(graph.size()); };
    const Progress part = progress.Part(partOf(p), partOf(p + 1));
    part(0.0);
    const Eigen::Index size = sizeOf(p), each = 1 + 2 * size * size;
    values[p].assign(options.Candidates * each, 0.0);
    const auto [a, b] = graph[p];
    if (static_cast<int>(p) % sharing.Processes == sharing.Process)
    {
      const std::vector<LandmarkCandidate> found = FindCandidates(shapes[a], shapes[b],
        FindCommonLandmarks(numbered[a], numbered[b]), static_cast<int>(size), options, part);
      for (std::size_t c = 0; c < std::min<std::size_t>(found.size(), options.Candidates); ++c)
      {
        double* at = values[p].data() + c * each;
        constexpr double smallest = 1e-6; // rounding of the eigenpairs, for equal surfaces
        *at = std::max(found[c].Error, smallest);
        Eigen::Map<Eigen::MatrixXd>(at + 1, size, size) = found[c].Maps.AToB;
        Eigen::Map<Eigen::MatrixXd>(at + 1 + size * size, size, size) = found[c].Maps.BToA;
      }
    }
  };
  const auto matchAll = [&]
  {
    for (std::size_t p = 0; p < graph.size(); ++p)
    {
      match(p);
    }
  };
  sharing.Processes > 1 ? sharing.Run(matchAll) : matchAll();
  std::vector<CandidatePair> pairs;
  for (std::size_t p = 0; p < graph.size(); ++p)
  {
    pairs.push_back({ graph[p][0], graph[p][1], {}, {} });
    if (sharing.Processes > 1)
    {
      sharing.Sum(values[p].data(), static_cast<int>(values[p].size()));
    }
    const Eigen::Index size = sizeOf(p), each = 1 + 2 * size * size;
    for (int c = 0; c < options.Candidates && values[p][c * each] > 0.0; ++c)
    {
      const double* at = values[p].data() + c * each;
      pairs[p].Errors.push_back(*at);
      pairs[p].Maps.push_back({ Eigen::Map<const Eigen::MatrixXd>(at + 1, size, size),
        Eigen::Map<const Eigen::MatrixXd>(at + 1 + size * size, size, size) });
    }
  }
  return pairs;
}

} // namespace shape
