#include "Hex/Polycube/Private/Charts.h"

#include "Base/DisjointSets.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <sstream>
#include <unordered_map>

namespace shape
{
namespace
{

void MakeUnique(std::vector<int>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

std::string LabelName(int label)
{
  static const char* names[] = { "+x", "-x", "+y", "-y", "+z", "-z" };
  return names[label];
}

/// Chains the edges between charts into borders, each with its left chart on the left.
std::vector<Charts::Border> TraceBoundaries(
  const Charts& charts, const std::vector<HalfEdge>& edges, const std::vector<int>& right)
{
  std::unordered_map<int, std::vector<int>> from;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    from[edges[i].Begin].push_back(static_cast<int>(i));
  }
  std::vector<char> used(edges.size(), 0);
  std::vector<Charts::Border> boundaries;
  const auto trace = [&](int first)
  {
    Charts::Border boundary{ charts.Of(edges[first].Triangle), right[first],
      { edges[first].Begin } };
    for (int edge = first; edge >= 0;)
    {
      used[edge] = 1;
      const int end = edges[edge].End;
      boundary.Points.push_back(end);
      edge = -1;
      if (charts.AtPoint[end].size() == 2)
      {
        for (const int next : from[end])
        {
          if (!used[next] && charts.Of(edges[next].Triangle) == boundary.First &&
            right[next] == boundary.Second)
          {
            edge = next;
            break;
          }
        }
      }
    }
    boundaries.push_back(std::move(boundary));
  };
  // Borders that start at a corner first. The edges that remain form closed loops without a corner.
  for (const bool corners : { true, false })
  {
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      if (!used[i] && (!corners || charts.AtPoint[edges[i].Begin].size() > 2))
      {
        trace(static_cast<int>(i));
      }
    }
  }
  return boundaries;
}

} // namespace

Charts FindCharts(const Mesh& surface, const Eigen::VectorXi& labels)
{
  const int count = static_cast<int>(surface.Triangles.rows());
  const std::vector<HalfEdge> sides = SortHalfEdges(surface.Triangles, surface.Points.rows());
  DisjointSets charted(count);
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
  {
    const int t = sides[i].Triangle, s = sides[i + 1].Triangle;
    if (labels(t) == labels(s))
    {
      charted.Merge(std::max(t, s), std::min(t, s));
    }
  }
  Charts charts;
  charts.Of.resize(count);
  std::vector<int> number(count, -1);
  for (int t = 0; t < count; ++t)
  {
    int& chart = number[charted.Find(t)];
    if (chart < 0)
    {
      chart = charts.Count();
      charts.Labels.push_back(labels(t));
    }
    charts.Of(t) = chart;
  }
  charts.Areas = Eigen::VectorXd::Zero(charts.Count());
  charts.AtPoint.resize(surface.Points.rows());
  const Eigen::VectorXd areas = 0.5 * ComputeAreaVectors(surface).rowwise().norm();
  for (int t = 0; t < count; ++t)
  {
    charts.Areas(charts.Of(t)) += areas(t);
    for (const int v : surface.Triangles.row(t))
    {
      charts.AtPoint[v].push_back(charts.Of(t));
    }
  }
  std::for_each(charts.AtPoint.begin(), charts.AtPoint.end(), MakeUnique);
  charts.Neighbours.resize(charts.Count());
  std::vector<HalfEdge> edges;
  std::vector<int> right;
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
  {
    const int a = charts.Of(sides[i].Triangle), b = charts.Of(sides[i + 1].Triangle);
    if (a != b)
    {
      charts.Neighbours[a].push_back(b);
      charts.Neighbours[b].push_back(a);
      // The half-edge of the chart with the lower index: this chart is on the left.
      edges.push_back(a < b ? sides[i] : sides[i + 1]);
      right.push_back(std::max(a, b));
    }
  }
  std::for_each(charts.Neighbours.begin(), charts.Neighbours.end(), MakeUnique);
  charts.Borders = TraceBoundaries(charts, edges, right);
  return charts;
}

std::vector<ChartFault> FindChartFaults(
  const Charts& charts, const Eigen::MatrixXd& positions, double slack)
{
  using Kind = ChartFault::Kind;
  std::vector<ChartFault> faults;
  for (int chart = 0; chart < charts.Count(); ++chart)
  {
    // The conditions of PolyCut (Livesu et al. 2013): a face of an orthogonal polyhedron has at
    // least four neighbours.
    if (charts.Neighbours[chart].size() < 4)
    {
      faults.push_back({ Kind::FewNeighbours, chart });
    }
    for (const int other : charts.Neighbours[chart])
    {
      // Adjacent faces are perpendicular to each other.
      if (other > chart && charts.Labels[chart] / 2 == charts.Labels[other] / 2)
      {
        faults.push_back({ Kind::Opposite, chart, other });
      }
    }
  }
  for (std::size_t v = 0; v < charts.AtPoint.size(); ++v)
  {
    const std::vector<int>& around = charts.AtPoint[v];
    int axes = 0;
    for (const int chart : around)
    {
      axes |= 1 << charts.Labels[chart] / 2;
    }
    // In a simple orthogonal polyhedron (Eppstein and Mumford 2010), one face of each axis meets at
    // a corner.
    if (around.size() > 3 || (around.size() == 3 && axes != 7))
    {
      faults.push_back({ Kind::Corner, around[0], around[1], static_cast<int>(v) });
    }
  }
  for (const Charts::Border& boundary : charts.Borders)
  {
    const int first = charts.Labels[boundary.First] / 2,
              second = charts.Labels[boundary.Second] / 2;
    if (first == second)
    {
      continue;
    }
    // A border is an edge of the polycube, so it is monotone along the third axis: a reversal is a
    // turning point of PolyCut.
    const int axis = 3 - first - second;
    const auto at = [&](int v) { return positions(v, axis); };
    const double way = at(boundary.Points.back()) - at(boundary.Points.front());
    const double sign = way < 0.0 ? -1.0 : 1.0;
    double farthest = sign * at(boundary.Points.front());
    for (const int v : boundary.Points)
    {
      if (sign * at(v) < farthest - slack)
      {
        faults.push_back({ Kind::Turn, boundary.First, boundary.Second, v });
        break;
      }
      farthest = std::max(farthest, sign * at(v));
    }
  }
  return faults;
}

std::string DescribeChart(const Charts& charts, int chart)
{
  std::ostringstream text;
  text.precision(2);
  text << "chart " << chart << " (" << LabelName(charts.Labels[chart]) << ", "
       << 100.0 * charts.Areas(chart) / charts.Areas.sum() << " % of the area)";
  return text.str();
}

std::string DescribeFaults(const std::vector<ChartFault>& faults, const Charts& charts)
{
  constexpr std::size_t maximum = 3;
  std::ostringstream text;
  for (std::size_t i = 0; i < std::min(maximum, faults.size()); ++i)
  {
    const ChartFault& fault = faults[i];
    text << (i > 0 ? "; " : "");
    text << DescribeChart(charts, fault.Chart);
    switch (fault.What)
    {
      case ChartFault::Kind::FewNeighbours:
        text << " has " << charts.Neighbours[fault.Chart].size() << " neighbours; 4 are needed";
        break;
      case ChartFault::Kind::Opposite:
        text << " shares an edge with " << DescribeChart(charts, fault.Other);
        break;
      case ChartFault::Kind::Corner:
        text << " has a corner of " << charts.AtPoint[fault.Point].size() << " charts at point "
             << fault.Point;
        break;
      case ChartFault::Kind::Turn:
        text << " has a border that reverses at point " << fault.Point << " with "
             << DescribeChart(charts, fault.Other);
        break;
    }
  }
  if (faults.size() > maximum)
  {
    text << "; and " << faults.size() - maximum << " more";
  }
  return text.str();
}

ConstrainedCoordinates ConstrainCharts(const Charts& charts, Eigen::Index points)
{
  DisjointSets joined(charts.Count());
  for (const std::vector<int>& around : charts.AtPoint)
  {
    for (const int a : around)
    {
      for (const int b : around)
      {
        // The common point has one coordinate along their axis, so both charts have.
        if (a < b && charts.Labels[a] / 2 == charts.Labels[b] / 2)
        {
          joined.Merge(b, a);
        }
      }
    }
  }
  ConstrainedCoordinates tied;
  tied.Unknowns = Eigen::VectorXi::Constant(3 * points, -1);
  for (std::size_t v = 0; v < charts.AtPoint.size(); ++v)
  {
    for (const int chart : charts.AtPoint[v])
    {
      // First by the representative of the joined charts. Below, these are numbered, and every
      // other coordinate gets an unknown of its own.
      tied.Unknowns(3 * v + charts.Labels[chart] / 2) = joined.Find(chart);
    }
  }
  std::vector<int> number(charts.Count(), -1);
  tied.Count = 0;
  for (int chart = 0; chart < charts.Count(); ++chart)
  {
    if (joined.Find(chart) == chart)
    {
      number[chart] = tied.Count++;
    }
  }
  for (int& unknown : tied.Unknowns)
  {
    unknown = unknown >= 0 ? number[unknown] : tied.Count++;
  }
  return tied;
}

std::vector<std::pair<int, int>> FindConstrainedEdges(
  const Eigen::MatrixXi& triangles, const Charts& charts, const ConstrainedCoordinates& tied)
{
  std::vector<std::pair<int, int>> edges;
  const std::vector<HalfEdge> sides =
    SortHalfEdges(triangles, static_cast<Eigen::Index>(charts.AtPoint.size()));
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
  {
    const int chart = charts.Of(sides[i].Triangle);
    if (chart != charts.Of(sides[i + 1].Triangle))
    {
      continue;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      // Both ends lie in one plane of another axis, although the edge lies inside the chart.
      if (axis != charts.Labels[chart] / 2 &&
        tied.Unknowns(3 * sides[i].Begin + axis) == tied.Unknowns(3 * sides[i].End + axis))
      {
        edges.emplace_back(sides[i].Low(), sides[i].High());
        break;
      }
    }
  }
  return edges;
}

} // namespace shape
