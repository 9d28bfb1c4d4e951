#include "Hex/Polycube/Private/IntegerCharts.h"

#include "Hex/Polycube/Private/AxisAlignment.h"
#include "Hex/Polycube/Private/IntegerMapHexes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using Pair = std::pair<int, int>;

std::array<int, 3> Sorted(std::array<int, 3> corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// Finds pairs of charts with the same axis that are connected by a polycube edge.
void AddEnds(const Charts& charts, std::set<Pair>& pairs)
{
  for (const Charts::Border& boundary : charts.Borders)
  {
    for (const int a : charts.AtPoint[boundary.Points.front()])
    {
      for (const int b : charts.AtPoint[boundary.Points.back()])
      {
        // An edge of the polycube runs along the axis that neither of its two charts has. The
        // charts at its ends are perpendicular to it.
        const int axis = charts.Labels[a] / 2;
        if (a != b && axis == charts.Labels[b] / 2 && axis != charts.Labels[boundary.First] / 2 &&
          axis != charts.Labels[boundary.Second] / 2)
        {
          pairs.insert({ a, b });
        }
      }
    }
  }
}

/// Finds the charts that a ray from a triangle, straight through the solid, meets first.
void AddFacing(const WorkingSolid& solid, const Charts& charts, const Eigen::MatrixXd& positions,
  std::set<Pair>& pairs)
{
  const TetrahedralWalk walk(positions, solid.Tetrahedra);
  const Eigen::RowVector3d size = positions.colwise().maxCoeff() - positions.colwise().minCoeff();
  std::map<std::array<int, 3>, int> triangles;
  for (int f = 0; f < solid.Triangles.rows(); ++f)
  {
    triangles[Sorted({ solid.Triangles(f, 0), solid.Triangles(f, 1), solid.Triangles(f, 2) })] = f;
  }
  for (int t = 0; t < solid.Tetrahedra.rows(); ++t)
  {
    const auto c = solid.Tetrahedra.row(t);
    for (int k = 0; k < 4; ++k)
    {
      const auto found = triangles.find(Sorted({ c((k + 1) % 4), c((k + 2) % 4), c((k + 3) % 4) }));
      if (found == triangles.end())
      {
        continue;
      }
      const int chart = charts.Of(found->second);
      // The ray starts just inside the triangle's centroid and goes inwards, farther than the
      // solid is wide.
      const Eigen::RowVector3d from =
        (0.01 * positions.row(c(k)) + 0.33 * positions.row(c((k + 1) % 4)) +
          0.33 * positions.row(c((k + 2) % 4)) + 0.33 * positions.row(c((k + 3) % 4)));
      const Eigen::RowVector3d to =
        from - 2.0 * size.maxCoeff() * GetLabelAxis(charts.Labels[chart]);
      const auto end = walk.Go(t, from.transpose(), to.transpose());
      if (end.Arrived || end.Face < 0)
      {
        continue;
      }
      const auto e = solid.Tetrahedra.row(end.Tetrahedron);
      const auto other = triangles.find(
        Sorted({ e((end.Face + 1) % 4), e((end.Face + 2) % 4), e((end.Face + 3) % 4) }));
      if (other != triangles.end() &&
        charts.Labels[charts.Of(other->second)] / 2 == charts.Labels[chart] / 2)
      {
        pairs.insert({ chart, charts.Of(other->second) });
      }
    }
  }
}

} // namespace

Eigen::VectorXi RoundCharts(const WorkingSolid& solid, const Charts& charts,
  const ConstrainedCoordinates& tied, const Eigen::MatrixXd& positions)
{
  std::set<Pair> pairs;
  AddEnds(charts, pairs);
  AddFacing(solid, charts, positions, pairs);
  // Charts that are tied together share one integer.
  std::vector<int> unknown(charts.Count(), -1);
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(charts.Count());
  for (std::size_t v = 0; v < charts.AtPoint.size(); ++v)
  {
    for (const int chart : charts.AtPoint[v])
    {
      const int axis = charts.Labels[chart] / 2;
      unknown[chart] = tied.Unknowns(3 * v + axis);
      wanted(chart) = positions(v, axis);
    }
  }
  // In ascending order, each unknown takes the closest integer, but at least one more than every
  // unknown below it.
  std::map<int, std::vector<int>> below; // for each unknown, the unknowns that must be smaller
  for (const auto& [a, b] : pairs)
  {
    if (unknown[a] != unknown[b])
    {
      const bool first = wanted(a) < wanted(b);
      below[unknown[first ? b : a]].push_back(unknown[first ? a : b]);
    }
  }
  std::vector<int> order(charts.Count());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [&](int a, int b) { return std::pair(wanted(a), a) < std::pair(wanted(b), b); });
  std::map<int, int> numbers;
  for (const int chart : order)
  {
    if (numbers.count(unknown[chart]) == 0)
    {
      int number = static_cast<int>(std::lround(wanted(chart)));
      for (const int other : below[unknown[chart]])
      {
        const auto found = numbers.find(other);
        number = found == numbers.end() ? number : std::max(number, found->second + 1);
      }
      numbers[unknown[chart]] = number;
    }
  }
  Eigen::VectorXi result(charts.Count());
  for (int chart = 0; chart < charts.Count(); ++chart)
  {
    result(chart) = numbers[unknown[chart]];
  }
  return result;
}

} // namespace shape
