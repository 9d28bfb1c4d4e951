#include "Correspondence/Transport/GeneralizedMDS.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Correspondence/Transport/Private/StressPairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr int FewSamples = 8; // of each surface at first

/// Pairs with the cost by which starts are compared.
struct Candidate
{
  StressPairs Pairs;
  bool IsReversed = false;
  double Cost = 0.0;
};

/// A start that exchanges left and right must be clearly better (as in FindLandmarks).
void SetCost(Candidate& candidate)
{
  constexpr double better = 0.85;
  candidate.IsReversed = candidate.Pairs.AreReversed();
  candidate.Cost = candidate.Pairs.Stress() / (candidate.IsReversed ? better : 1.0);
}

/// Images of three samples of A, and how much they change distances.
struct Triple
{
  double Change = 0.0;
  std::array<int, 3> Images = {};
};

/// The images of the first three samples of A among the first samples of B, in ascending order of
/// how much they change the distances between them and from the landmarks.
std::vector<Triple> FindTriples(
  const MetricSurface& a, const MetricSurface& b, const Landmarks& landmarks)
{
  constexpr std::size_t maximum = 40; // samples of B
  const std::size_t count = std::min(maximum, b.Samples.size());
  const std::array<int, 3> on = { a.Samples[0], a.Samples[1], a.Samples[2] };
  // Of the distances from the landmarks.
  Eigen::MatrixXd own = Eigen::MatrixXd::Zero(3, static_cast<Eigen::Index>(count));
  const auto square = [](double change) { return change * change; };
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < count; ++j)
    {
      for (const auto& [pointA, pointB] : landmarks)
      {
        own(i, j) += square(a.Distances(on[i], pointA) - b.Distances(b.Samples[j], pointB));
      }
    }
  }
  std::vector<Triple> triples;
  const auto change = [&](std::size_t i, std::size_t j, int p, int q)
  { return square(a.Distances(on[i], on[j]) - b.Distances(p, q)); };
  for (std::size_t i = 0; i < count; ++i)
  {
    for (std::size_t j = 0; j < count; ++j)
    {
      for (std::size_t k = 0; k < count; ++k)
      {
        const std::array<int, 3> images = { b.Samples[i], b.Samples[j], b.Samples[k] };
        triples.push_back({ own(0, i) + own(1, j) + own(2, k) + change(0, 1, images[0], images[1]) +
            change(1, 2, images[1], images[2]) + change(2, 0, images[2], images[0]),
          images });
      }
    }
  }
  std::sort(triples.begin(), triples.end(),
    [](const Triple& one, const Triple& other)
    { return std::tie(one.Change, one.Images) < std::tie(other.Change, other.Images); });
  return triples;
}

/// The samples of both surfaces in the order in which they are added: (side, point).
std::vector<std::pair<int, int>> ListSamples(
  const MetricSurface& a, const MetricSurface& b, int firstA, int firstB, int end)
{
  std::vector<std::pair<int, int>> samples;
  const auto add = [&](int side, const MetricSurface& surface, int first, int k)
  {
    if (k >= first && k < static_cast<int>(surface.Samples.size()))
    {
      samples.emplace_back(side, surface.Samples[k]);
    }
  };
  for (int k = std::min(firstA, firstB); k < end; ++k)
  {
    add(0, a, firstA, k);
    add(1, b, firstB, k);
  }
  return samples;
}

void AddSamples(StressPairs& pairs, const std::vector<std::pair<int, int>>& samples)
{
  for (const auto& [side, point] : samples)
  {
    pairs.AddSample(side, point);
  }
}

/// Adds samples as a symmetry would exchange them: the one whose two best images have the most
/// similar stress gets the second one, and the samples after it follow.
void AddSamplesExchanged(StressPairs& pairs, const std::vector<std::pair<int, int>>& samples)
{
  StressPairs usual = pairs;
  double lowest = std::numeric_limits<double>::infinity();
  std::pair<int, int> exchanged(-1, -1);
  for (const auto& [side, point] : samples)
  {
    const double stress = usual.RivalStress(side, point);
    if (stress < lowest)
    {
      lowest = stress;
      exchanged = { side, point };
    }
    usual.AddSample(side, point);
  }
  for (const auto& sample : samples)
  {
    pairs.AddSample(sample.first, sample.second,
      sample == exchanged ? StressPairs::ImageType::Rival : StressPairs::ImageType::Lowest);
  }
}

/// Drops the worse half, but keeps the best start that does not exchange left and right.
/// candidates: in ascending order of their costs.
void DropHalf(std::vector<Candidate>& candidates)
{
  const auto proper = std::find_if(candidates.begin(), candidates.end(),
    [](const Candidate& candidate) { return !candidate.IsReversed; });
  auto kept = candidates.begin() + static_cast<std::ptrdiff_t>((candidates.size() + 1) / 2);
  if (proper != candidates.end() && proper >= kept)
  {
    std::iter_swap(kept++, proper);
  }
  candidates.erase(kept, candidates.end());
}

void SortByCost(std::vector<Candidate>& candidates)
{
  std::stable_sort(candidates.begin(), candidates.end(),
    [](const Candidate& one, const Candidate& other) { return one.Cost < other.Cost; });
}

/// The starts with few samples, before they are optimised.
std::vector<Candidate> FindStarts(const MetricSurface& a, const MetricSurface& b,
  const Landmarks& landmarks, const GeneralizedMDSOptions& options, const Progress& progress)
{
  StressPairs known(a, b);
  for (const auto& [pointA, pointB] : landmarks)
  {
    known.Add(pointA, pointB, -1);
  }
  constexpr std::size_t enough = 3; // landmarks that determine the other images
  std::vector<Candidate> starts;
  if (landmarks.size() >= enough)
  {
    AddSamples(known, ListSamples(a, b, 0, 0, FewSamples));
    starts.push_back({ std::move(known) });
    return starts;
  }
  constexpr std::size_t tried = 100; // triples; the best of them with few samples are starts
  constexpr double apart = 0.25;     // of the root of the area; nearer triples are one start
  std::vector<Triple> chosen;
  for (const Triple& triple : FindTriples(a, b, landmarks))
  {
    if (chosen.size() == tried)
    {
      break;
    }
    if (std::all_of(chosen.begin(), chosen.end(),
          [&](const Triple& other)
          {
            double farthest = 0.0;
            for (std::size_t i = 0; i < 3; ++i)
            {
              farthest = std::max(farthest, b.Distances(triple.Images[i], other.Images[i]));
            }
            return farthest > apart;
          }))
    {
      chosen.push_back(triple);
    }
  }
  const std::vector<std::pair<int, int>> samples = ListSamples(a, b, 3, 0, FewSamples);
  for (std::size_t i = 0; i < chosen.size(); ++i)
  {
    StressPairs pairs = known;
    for (std::size_t k = 0; k < 3; ++k)
    {
      pairs.Add(a.Samples[k], chosen[i].Images[k], 1);
    }
    StressPairs exchanged = pairs;
    AddSamples(pairs, samples);
    starts.push_back({ std::move(pairs) });
    SetCost(starts.back());
    if (starts.back().IsReversed)
    {
      AddSamplesExchanged(exchanged, samples);
      starts.push_back({ std::move(exchanged) });
      SetCost(starts.back());
    }
    progress(static_cast<double>(i + 1) / static_cast<double>(chosen.size()));
  }
  SortByCost(starts);
  starts.erase(starts.begin() +
      std::min<std::ptrdiff_t>(options.Starts, static_cast<std::ptrdiff_t>(starts.size())),
    starts.end());
  return starts;
}

/// The map of all points of a side. The samples keep their images.
SurfacePoints MapPoints(const StressPairs& pairs, const MetricSurface& from, int side,
  const std::vector<int>& moved, const Progress& progress)
{
  const Eigen::Index points = from.Distances.rows();
  SurfacePoints map{ Eigen::VectorXi(points), Eigen::MatrixXd(points, 3) };
  const auto set = [&](Eigen::Index point, const SurfacePoint& image)
  {
    map.Triangles(point) = image.Triangle;
    map.Barycentrics.row(point) = image.Barycentric;
  };
  constexpr int grain = 16; // points
  ParallelFor(
    static_cast<int>(points), grain,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        set(i, pairs.FindImage(side, i));
      }
    },
    progress);
  for (const int pair : moved)
  {
    // A sample is exactly at a point.
    const SurfacePoint& own = pairs.Position(side, pair);
    Eigen::Index corner = 0;
    own.Barycentric.maxCoeff(&corner);
    set(from.Shape.Triangles()(own.Triangle, corner), pairs.Position(1 - side, pair));
  }
  return map;
}

} // namespace

// 1. Distances between all points of each surface.
// 2. Starts: images of three remote samples, extended to few samples.
// 3. Minimise the stress of each; keep the better half; double the samples. Repeat.
// 4. Map all points relative to the samples.
GeneralizedMDSResult ComputeGeneralizedMDS(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const GeneralizedMDSOptions& options, const Progress& progress)
{
  RequireOption(options.Samples >= FewSamples, "ScalingSamples", options.Samples, "at least 8");
  RequireOption(options.Starts >= 1, "ScalingStarts", options.Starts, "at least 1");
  RequireOption(options.Sweeps >= 1, "Sweeps", options.Sweeps, "at least 1");
  RequireConnected(a, "surface A");
  RequireConnected(b, "surface B");
  RequireLandmarks(landmarks, a, b);
  const BlasThreads one(false);
  const MetricSurface onA(a, progress.Part(0.0, 0.3, "computing geodesic distances")),
    onB(b, progress.Part(0.3, 0.6, "computing geodesic distances"));
  std::vector<Candidate> candidates =
    FindStarts(onA, onB, landmarks, options, progress.Part(0.6, 0.7, "looking for starts"));
  const Progress scaling = progress.Part(0.7, 0.95, "changing distances less");
  for (int samples = FewSamples;; samples = std::min(2 * samples, options.Samples))
  {
    const double begin = static_cast<double>(samples) / options.Samples;
    for (std::size_t k = 0; k < candidates.size(); ++k)
    {
      const auto share = [&](std::size_t done)
      { return begin * (0.5 + 0.5 * static_cast<double>(done) / candidates.size()); };
      candidates[k].Pairs.Minimize(options.Sweeps, scaling.Part(share(k), share(k + 1)));
      SetCost(candidates[k]);
    }
    SortByCost(candidates);
    if (samples == options.Samples)
    {
      break;
    }
    DropHalf(candidates);
    for (Candidate& candidate : candidates)
    {
      AddSamples(candidate.Pairs,
        ListSamples(onA, onB, samples, samples, std::min(2 * samples, options.Samples)));
    }
  }
  const StressPairs& best = candidates.front().Pairs;
  std::vector<int> samplesOfA, samplesOfB;
  for (int pair = 0; pair < best.Count(); ++pair)
  {
    if (best.MovingSide(pair) != 0)
    {
      samplesOfA.push_back(pair);
    }
    if (best.MovingSide(pair) != 1)
    {
      samplesOfB.push_back(pair);
    }
  }
  GeneralizedMDSResult result;
  result.Maps = { MapPoints(
                    best, onA, 0, samplesOfA, progress.Part(0.95, 0.975, "mapping the points")),
    MapPoints(best, onB, 1, samplesOfB, progress.Part(0.975, 1.0, "mapping the points")) };
  result.Stress = best.Stress();
  result.Reversed = best.AreReversed();
  return result;
}

} // namespace shape
