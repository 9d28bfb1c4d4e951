#include "Untangle/Private/CellSplits.h"

#include <algorithm>
#include <set>
#include <utility>

namespace shape
{

CellSplits::CellSplits(SolidCells& solid, std::function<bool(int point)> movable)
  : Solid(solid)
  , Movable(std::move(movable))
{
}

void CellSplits::Impossible(const std::vector<int>& bad, const Progress& progress)
{
  for (std::size_t i = 0; i < bad.size(); ++i)
  {
    if (i % ReportInterval == 0)
    {
      progress(static_cast<double>(i) / static_cast<double>(bad.size()));
    }
    const int cell = bad[i];
    const std::vector<int> points = this->Solid.PointsOf(cell);
    if (points.size() == 4 &&
      std::none_of(points.begin(), points.end(), [&](int point) { return this->Movable(point); }))
    {
      // No motion can make it positive: all its points are fixed.
      this->SplitLongest(points) || this->SplitFace(points);
    }
  }
}

void CellSplits::Stubborn(const std::vector<int>& bad, int allowed, const Progress& progress)
{
  this->Collared.resize(this->Solid.PointCount(), 0);
  std::set<int> collar;
  for (const int cell : bad)
  {
    for (const int point : this->Solid.PointsOf(cell))
    {
      if (!this->Movable(point) && this->Collared[point] < allowed)
      {
        collar.insert(point);
      }
    }
  }
  std::set<int> touched;
  for (const int point : collar)
  {
    ++this->Collared[point];
    // The collar: every inner edge from the fixed point gets a movable point.
    this->SplitAround(point, progress.Part(0.0, 0.5));
    touched.insert(point);
  }
  for (std::size_t i = 0; i < bad.size(); ++i)
  {
    if (i % ReportInterval == 0)
    {
      progress(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(bad.size()));
    }
    const std::vector<int> points = this->Solid.PointsOf(bad[i]);
    if (points.size() != 4 ||
      std::any_of(points.begin(), points.end(), [&](int point) { return touched.count(point); }))
    {
      continue;
    }
    if (this->SplitLongest(points) || this->SplitFace(points))
    {
      touched.insert(this->Solid.PointCount() - 1);
    }
  }
}

void CellSplits::SplitAround(int point, const Progress& progress)
{
  constexpr int interval = 64; // a point may have thousands of edges, each slow to split
  int splits = 0;
  for (const int end : this->Solid.NeighboursOf(point))
  {
    if (splits++ % interval == 0)
    {
      progress(0.0);
    }
    if (this->Solid.CanSplit({ point, end }))
    {
      this->Solid.Split({ point, end });
    }
  }
}

bool CellSplits::SplitLongest(const std::vector<int>& points)
{
  const Eigen::MatrixXd& positions =
    this->Solid.Rest.rows() > 0 ? this->Solid.Rest : this->Solid.Points;
  std::pair<int, double> best = { -1, 0.0 };
  std::vector<int> edge;
  for (int a = 0; a < 4; ++a)
  {
    for (int b = 0; b < a; ++b)
    {
      const std::pair<int, double> rank = { !this->Movable(points[a]) + !this->Movable(points[b]),
        (positions.row(points[a]) - positions.row(points[b])).norm() };
      // Ranked by the number of fixed ends, then by length.
      if (rank > best && this->Solid.CanSplit({ points[a], points[b] }))
      {
        best = rank;
        edge = { points[a], points[b] };
      }
    }
  }
  if (!edge.empty())
  {
    this->Solid.Split(edge);
  }
  return !edge.empty();
}

bool CellSplits::SplitFace(const std::vector<int>& points)
{
  for (int left = 0; left < 4; ++left)
  {
    std::vector<int> face = points;
    face.erase(face.begin() + left);
    if (this->Solid.CanSplit(face))
    {
      this->Solid.Split(face);
      return true;
    }
  }
  return false;
}

} // namespace shape
