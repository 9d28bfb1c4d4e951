#include "Correspondence/CommonBase/SurfaceCurves.h"

#include "Base/Errors.h"
#include "Correspondence/Landmarks/LandmarkPairs.h"
#include "Mesh/Graph.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>

namespace shape
{

std::vector<int> TraceEdgeCurve(
  const Surface& surface, const Eigen::MatrixXd& positions, const std::string& name)
{
  RequireFinite(positions, "a curve of " + name);
  const Eigen::VectorXi nearest = FindNearestPoints(surface, positions, name);
  const std::shared_ptr<const Graph> edges = GetEdgeGraph(surface);
  const Eigen::Index last = nearest.size() - 1;
  const bool isClosed = last > 0 && nearest(0) == nearest(last);
  // Nearest points jump to and fro within an edge or two: these points are left out.
  constexpr std::ptrdiff_t jump = 4;
  std::vector<int> curve{ nearest(0) };
  std::vector<bool> isPassed(surface.Points().rows(), false);
  for (Eigen::Index i = 1; i <= last; ++i)
  {
    const bool closes = isClosed && i == last;
    const auto found = std::find(curve.begin(), curve.end(), nearest(i));
    if (!closes && found - curve.begin() < jump && curve.end() - found > jump)
    {
      continue; // a closed curve, near its beginning
    }
    std::fill(isPassed.begin(), isPassed.end(), false);
    for (std::size_t k = closes ? 1 : curve.size(); k < curve.size(); ++k)
    {
      isPassed[curve[k]] = true; // it closes only at its beginning
    }
    const std::vector<int> path = nearest(i) == curve.back()
      ? std::vector<int>()
      : FindShortestPath(*edges, curve.back(), nearest(i),
          [&](double distance, int edge)
          {
            return isPassed[edges->Neighbours[edge]] ? std::numeric_limits<double>::infinity()
                                                     : distance + edges->Lengths[edge];
          });
    for (std::size_t k = 1; k < path.size(); ++k)
    {
      const auto passed = std::find(
        curve.end() - std::min<std::ptrdiff_t>(jump, static_cast<std::ptrdiff_t>(curve.size())),
        curve.end(), path[k]);
      if (passed == curve.end() || (closes && k + 1 == path.size()))
      {
        curve.push_back(path[k]);
      }
      else
      {
        curve.erase(passed + 1, curve.end());
      }
    }
  }
  constexpr std::size_t closed = 4; // a closed curve has three points or more
  if (curve.size() < (isClosed ? closed : 2) || (isClosed && curve.front() != curve.back()))
  {
    throw InvalidInput("a curve of " + name +
      " is not longer than the edges there; leave it out, or remesh the surface more finely");
  }
  return curve;
}

CurvePair Renumber(
  const CurvePair& curve, const Eigen::VectorXi& numbersOfA, const Eigen::VectorXi& numbersOfB)
{
  CurvePair renumbered = curve;
  for (int& point : renumbered.OnA)
  {
    point = numbersOfA(point);
  }
  for (int& point : renumbered.OnB)
  {
    point = numbersOfB(point);
  }
  return renumbered;
}

} // namespace shape
