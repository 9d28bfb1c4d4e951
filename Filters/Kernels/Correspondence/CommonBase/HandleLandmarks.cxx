#include "Correspondence/CommonBase/HandleLandmarks.h"

#include "Base/Errors.h"
#include "Correspondence/CommonBase/Private/HandleLoops.h"
#include "Correspondence/CommonBase/Private/LoopedSurface.h"
#include "Correspondence/CommonBase/Private/PositionOrder.h"
#include "Correspondence/CommonBase/SurfaceCurves.h"
#include "Correspondence/Pair/CoarsePair.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Appends pairs, except where a point is less than `near` away from one that has a partner, over
/// the root of the area.
void Append(const LoopedSurface& a, const std::vector<int>& ofA, const LoopedSurface& b,
  const std::vector<int>& ofB, double near, Landmarks& pairs)
{
  for (std::size_t i = 0; i < ofA.size(); ++i)
  {
    const bool isNear = std::any_of(pairs.begin(), pairs.end(),
      [&](const auto& pair)
      {
        return pair[0] == ofA[i] || pair[1] == ofB[i] || a.Distances(pair[0], ofA[i]) < near ||
          b.Distances(pair[1], ofB[i]) < near;
      });
    if (!isNear)
    {
      pairs.push_back({ ofA[i], ofB[i] });
    }
  }
}

/// A combination of partners of the first handles.
struct Combination
{
  std::vector<LoopCrossing> Chosen;                       ///< on B
  double Value = std::numeric_limits<double>::infinity(); ///< DistortionOf
};

/// Searches partners of the handles of A, added to given landmarks.
struct CombinationSearch
{
  const LoopedSurface &A, &B;
  const std::vector<LoopCrossing>& OnA; ///< the handles
  const Landmarks& Start;

  /// Whether loops cross alike on both surfaces.
  bool DoCrossAlike(const std::vector<LoopCrossing>& onB) const
  {
    for (std::size_t i = 0; i < onB.size(); ++i)
    {
      for (std::size_t j = 0; j < onB.size(); ++j)
      {
        if (this->A.Loops.Crossings(this->OnA[i].Handle, this->OnA[j].Tunnel) !=
          this->B.Loops.Crossings(onB[i].Handle, onB[j].Tunnel))
        {
          return false;
        }
      }
    }
    return true;
  }

  /// Returns the landmarks of partners of the first handles. near: see Append.
  Landmarks PairsOf(const std::vector<LoopCrossing>& chosen, double near) const
  {
    Landmarks pairs = this->Start;
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
      // Thirds, and on B the shares where the points of A are: one rounding to points less.
      std::vector<double> shares{ 1.0 / 3.0, 2.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0 };
      const std::vector<int> own = MarksOf(this->A, this->OnA[i], shares);
      Append(this->A, own, this->B, MarksOf(this->B, chosen[i], shares), near, pairs);
    }
    return pairs;
  }

  Combination Evaluate(std::vector<LoopCrossing> chosen) const
  {
    const double value = DistortionOf(this->A, this->B, this->PairsOf(chosen, 0.0));
    return { std::move(chosen), value };
  }

  /// Returns the best combinations of some of the crossings of B.
  std::vector<Combination> Run(
    const std::vector<LoopCrossing>& crossings, const Progress& progress) const
  {
    constexpr std::size_t width = 8;
    std::vector<Combination> beam(1);
    for (std::size_t handle = 0; handle < this->OnA.size(); ++handle)
    {
      std::vector<Combination> next;
      for (std::size_t i = 0; i < crossings.size(); ++i)
      {
        progress((static_cast<double>(handle) +
                   static_cast<double>(i) / static_cast<double>(crossings.size())) /
          static_cast<double>(this->OnA.size()));
        for (const LoopCrossing& turned : Turned(crossings[i]))
        {
          for (const Combination& before : beam)
          {
            std::vector<LoopCrossing> chosen = before.Chosen;
            chosen.push_back(turned);
            if (this->DoCrossAlike(chosen))
            {
              next.push_back(this->Evaluate(std::move(chosen)));
            }
          }
        }
      }
      std::stable_sort(next.begin(), next.end(),
        [](const Combination& x, const Combination& y) { return x.Value < y.Value; });
      next.resize(std::min(width, next.size()));
      beam = std::move(next);
    }
    return beam;
  }

  /// Moves the crossings of a combination to nearby ones while that lowers the distortion.
  Combination Refine(Combination best, const std::vector<LoopCrossing>& all) const
  {
    constexpr double near = 0.2; // over the root of the area
    for (std::size_t handle = 0; handle < best.Chosen.size(); ++handle)
    {
      const int point = best.Chosen[handle].Point();
      for (const LoopCrossing& crossing : all)
      {
        if (this->B.Distances(crossing.Point(), point) > near)
        {
          continue;
        }
        for (const LoopCrossing& turned : Turned(crossing))
        {
          std::vector<LoopCrossing> chosen = best.Chosen;
          chosen[handle] = turned;
          if (this->DoCrossAlike(chosen))
          {
            Combination moved = this->Evaluate(std::move(chosen));
            best = moved.Value < best.Value ? std::move(moved) : best;
          }
        }
      }
    }
    return best;
  }
};

/// A loop of the coarse surface, along edges of the fine one.
HandleLoop OnFine(const SurfaceCycle& cycle, bool isTunnel, const CoarsePair& pair)
{
  std::vector<int> points;
  for (const int point : cycle.Points)
  {
    points.push_back(pair.FinePointOfA(point));
  }
  points.push_back(points.front());
  const Eigen::MatrixXd& positions = pair.FineA().Points();
  HandleLoop loop{ TraceEdgeCurve(pair.FineA(), positions(points, Eigen::all), "SurfaceA"),
    isTunnel, 0.0 };
  for (std::size_t i = 1; i < loop.Points.size(); ++i)
  {
    loop.Length += (positions.row(loop.Points[i]) - positions.row(loop.Points[i - 1])).norm();
  }
  return loop;
}

/// Returns the map through landmarks; nothing if there is none: paths of other candidates can be
/// traced where those of this one cannot.
std::optional<CommonBaseMap> TryMap(const Surface& a, const Surface& b, const Landmarks& pairs,
  const CommonBaseOptions& options, const Progress& progress)
{
  try
  {
    return MapThroughBase(a, b, pairs, options, progress);
  }
  catch (const SolveFailure&)
  {
    return {};
  }
  catch (const InvalidInput&)
  {
    return {};
  }
}

/// The mean energy of both directions.
double EnergyOf(const CommonBaseMap& map)
{
  return 0.5 * (map.Energy + map.EnergyBack);
}

/// FindHandleLandmarks for surfaces in an order that their numbers do not change.
HandleLandmarks FindOrdered(
  const Surface& a, const Surface& b, const Landmarks& others, const Progress& progress)
{
  constexpr int enough = 800;
  const CoarsePair pair(a, b, others, enough, progress.Part(0.0, 0.05));
  const LoopedSurface onA(pair.A(), "SurfaceA", progress.Part(0.05, 0.1)),
    onB(pair.B(), "SurfaceB", progress.Part(0.1, 0.15));
  const std::vector<LoopCrossing> all = FindCrossings(onB, progress.Part(0.15, 0.2));
  const std::vector<LoopCrossing> handles =
    ChooseHandles(onA, FindCrossings(onA, progress.Part(0.2, 0.25)));
  HandleLandmarks result;
  result.ShortestOfA = ShortestLoop(onA, handles);
  result.ShortestOfB = ShortestLoop(onB, ChooseHandles(onB, all));
  for (const LoopCrossing& handle : handles)
  {
    result.LoopsOfA.push_back(OnFine(handle.Handle, false, pair));
    result.LoopsOfA.push_back(OnFine(handle.Tunnel, true, pair));
  }
  const Landmarks none, start = pair.OnCoarse(others);
  std::vector<Landmarks> candidates{ start };
  const std::vector<LoopCrossing> spread = SpreadCrossings(onB, all);
  const CombinationSearch alone{ onA, onB, handles, none }, added{ onA, onB, handles, start };
  // Landmarks near each other fix how the small triangles between them are turned, but without
  // them a surface with few points has too few landmarks.
  constexpr double near = 0.1;
  const auto tryBest =
    [&](const CombinationSearch& search, const std::vector<double>& distances, const Progress& part)
  {
    const std::vector<Combination> found = search.Run(spread, part);
    if (!found.empty())
    {
      const Combination best = search.Refine(found.front(), all);
      for (const double distance : distances)
      {
        const Landmarks pairs = search.PairsOf(best.Chosen, distance);
        for (const Landmarks& tried : { pairs, WithFarPoints(onA, onB, pairs) })
        {
          if (std::find(candidates.begin(), candidates.end(), tried) == candidates.end())
          {
            candidates.push_back(tried);
          }
        }
      }
    }
  };
  tryBest(alone, { 0.0, near }, progress.Part(0.25, 0.35));
  tryBest(added, { near }, progress.Part(0.35, 0.4));
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    const auto share = [&](std::size_t count)
    { return 0.4 + 0.6 * static_cast<double>(count) / static_cast<double>(candidates.size()); };
    if (const std::optional<CommonBaseMap> map =
          TryMap(pair.A(), pair.B(), candidates[i], {}, progress.Part(share(i), share(i + 1))))
    {
      result.Candidates.push_back({ pair.OnFine(candidates[i]), EnergyOf(*map) });
    }
  }
  if (result.Candidates.empty())
  {
    throw SolveFailure("the landmarks that were found on handles give no common base; give "
                       "Landmarks on each handle");
  }
  std::stable_sort(result.Candidates.begin(), result.Candidates.end(),
    [](const HandleCandidate& x, const HandleCandidate& y) { return x.Energy < y.Energy; });
  progress(1.0);
  return result;
}

} // namespace

HandleLandmarks FindHandleLandmarks(
  const Surface& a, const Surface& b, const Landmarks& others, const Progress& progress)
{
  const PositionOrder onA(a), onB(b);
  Landmarks ordered = others;
  for (auto& [pointA, pointB] : ordered)
  {
    pointA = onA.PointOf.at(pointA);
    pointB = onB.PointOf.at(pointB);
  }
  HandleLandmarks found = FindOrdered(onA.Shape, onB.Shape, ordered, progress);
  for (HandleCandidate& candidate : found.Candidates)
  {
    for (auto& [pointA, pointB] : candidate.Pairs)
    {
      pointA = onA.Points[pointA];
      pointB = onB.Points[pointB];
    }
  }
  for (HandleLoop& loop : found.LoopsOfA)
  {
    for (int& point : loop.Points)
    {
      point = onA.Points[point];
    }
  }
  return found;
}

CommonBaseMap MapByHandles(const Surface& a, const Surface& b, const HandleLandmarks& handles,
  Landmarks& landmarks, const CommonBaseOptions& options, const Progress& progress)
{
  constexpr std::size_t most = 3;
  constexpr double enough = 1.25 * 4.0; // the energy of an isometry is 4
  const std::size_t count = std::min(most, handles.Candidates.size());
  std::optional<CommonBaseMap> best;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto share = [&](std::size_t k)
    { return static_cast<double>(k) / static_cast<double>(count); };
    const HandleCandidate& candidate = handles.Candidates[i];
    std::optional<CommonBaseMap> map =
      TryMap(a, b, candidate.Pairs, options, progress.Part(share(i), share(i + 1)));
    if (!map)
    {
      continue;
    }
    const double energy = EnergyOf(*map);
    if (!best || energy < EnergyOf(*best))
    {
      best = std::move(map);
      landmarks = candidate.Pairs;
    }
    if (energy <= enough)
    {
      break;
    }
  }
  if (!best)
  {
    // Throws the reason for the first.
    return MapThroughBase(a, b, handles.Candidates.front().Pairs, options, progress);
  }
  return std::move(*best);
}

} // namespace shape
