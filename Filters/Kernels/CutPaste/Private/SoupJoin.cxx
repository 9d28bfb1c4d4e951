#include "CutPaste/Private/SoupJoin.h"

#include "Mesh/Topology.h"
#include "Mesh/UsedPoints.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// The seam: each point of the feature's loop, then the soup's points on the line to the next one.
class Seam
{
public:
  Seam(const FeatureFootprint& base, const LoopOnSoup& landing, const std::vector<int>& isUsed)
    : Position(landing)
    , OnLine(base.Loop.size())
  {
    for (const SeamPoint& point : landing.Seam)
    {
      if (isUsed[point.Point] >= 0)
      {
        this->Place(point);
      }
    }
    for (std::vector<SeamPoint>& line : this->OnLine)
    {
      std::sort(line.begin(), line.end(),
        [](const SeamPoint& a, const SeamPoint& b)
        { return a.Along != b.Along ? a.Along < b.Along : a.Point < b.Point; });
      this->Weld(line);
    }
    this->FindEdges();
    for (int number = 0; number < static_cast<int>(this->OnLine.size()); ++number)
    {
      this->Follow(number);
    }
  }

  /// Returns the soup's points between a point of the loop and the next one, in order.
  std::vector<int> Between(int number) const
  {
    std::vector<int> points;
    for (const SeamPoint& point : this->OnLine[number])
    {
      points.push_back(point.Point);
    }
    return points;
  }

  /// For points of the soup at the seam, the point of the loop (>= 0, its number), or the point of
  /// the soup (-1 - point) that takes its place.
  std::map<int, int> Replaced;

private:
  RowVector3d At(int number) const
  {
    return this->Position.Positions.row(number % this->Position.Positions.rows());
  }

  void Place(const SeamPoint& point)
  {
    const RowVector3d position = this->Position.Rest.Points.row(point.Point);
    const RowVector3d begin = this->At(point.Segment), end = this->At(point.Segment + 1);
    // A sheet farther away is another one.
    const double most = 0.25 * (end - begin).norm();
    const double away = (position - begin - point.Along * (end - begin)).norm();
    if (point.Along == 0.0 && away <= this->Same())
    {
      this->Replaced[point.Point] = point.Segment;
    }
    else if (point.Along > 0.0 && away <= most)
    {
      this->OnLine[point.Segment].push_back(point);
    }
  }

  /// Points at the same position are one point: triangles of a soup repeat their corners.
  void Weld(std::vector<SeamPoint>& line)
  {
    std::vector<SeamPoint> kept;
    for (const SeamPoint& point : line)
    {
      const bool isSame = !kept.empty() &&
        (this->Position.Rest.Points.row(point.Point) -
          this->Position.Rest.Points.row(kept.back().Point))
            .norm() <= this->Same();
      const bool isAtOnce = !kept.empty() && point.Along == kept.back().Along;
      if (isSame)
      {
        this->Replaced[point.Point] = -1 - kept.back().Point;
      }
      else if (!isAtOnce)
      {
        kept.push_back(point);
      }
    }
    line.swap(kept);
  }

  /// Returns a point of the soup as it will be joined: the number n of a point of the loop as -1 -
  /// n.
  int JoinedAs(int point) const
  {
    const auto by = this->Replaced.find(point);
    return by == this->Replaced.end() ? point : -1 - by->second;
  }

  /// Finds the edges of the soup between points of the seam.
  void FindEdges()
  {
    std::vector<char> isOnSeam(this->Position.Rest.Points.rows(), 0);
    for (const SeamPoint& point : this->Position.Seam)
    {
      isOnSeam[point.Point] = 1;
    }
    for (const auto& corners : this->Position.Rest.Triangles.rowwise())
    {
      for (int k = 0; k < 3; ++k)
      {
        const int a = corners(k), b = corners((k + 1) % 3);
        if (isOnSeam[a] && isOnSeam[b])
        {
          this->Edges.insert(std::minmax({ this->JoinedAs(a), this->JoinedAs(b) }));
        }
      }
    }
  }

  /// Where the map of the soup to the plane folds, its edges meet a line of the loop in another
  /// order than along the line. Orders the points by these edges, if they lead through all of them.
  void Follow(int number)
  {
    std::vector<SeamPoint> left = this->OnLine[number], ordered;
    int last = -1 - number;
    const auto isNext = [&](int point) {
      return this->Edges.count(std::minmax({ last, point })) > 0;
    };
    while (!left.empty())
    {
      const auto next = std::find_if(
        left.begin(), left.end(), [&](const SeamPoint& point) { return isNext(point.Point); });
      if (next == left.end())
      {
        return;
      }
      last = next->Point;
      ordered.push_back(*next);
      left.erase(next);
    }
    const int end = (number + 1) % static_cast<int>(this->OnLine.size());
    if (isNext(-1 - end))
    {
      this->OnLine[number].swap(ordered);
    }
  }

  double Same() const
  {
    return 1e-9 * (this->At(0) - this->At(static_cast<int>(this->OnLine.size()) / 2)).norm();
  }

  const LoopOnSoup& Position;
  std::vector<std::vector<SeamPoint>> OnLine;
  std::set<std::pair<int, int>> Edges; ///< between points as they will be joined (JoinedAs)
};

/// The feature's triangles, each split at the seam's points on its edges. pointsOf: for each
/// directed edge of the loop, the points on it.
class SplitFeature
{
public:
  SplitFeature(const Eigen::MatrixXi& triangles, std::map<std::pair<int, int>, std::vector<int>> on)
    : On(std::move(on))
  {
    for (int t = 0; t < static_cast<int>(triangles.rows()); ++t)
    {
      this->Split({ triangles(t, 0), triangles(t, 1), triangles(t, 2) }, t);
    }
  }

  std::vector<std::array<int, 3>> Triangles;
  std::vector<int> Original;

private:
  /// Cuts the fan of the first edge with points off, and continues with the rest of the triangle.
  void Split(const std::array<int, 3>& corners, int original)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = corners[k], b = corners[(k + 1) % 3], apex = corners[(k + 2) % 3];
      const auto forward = this->On.find({ a, b }), backward = this->On.find({ b, a });
      if (forward == this->On.end() && backward == this->On.end())
      {
        continue;
      }
      std::vector<int> points = forward != this->On.end() ? forward->second : backward->second;
      if (forward == this->On.end())
      {
        std::reverse(points.begin(), points.end());
      }
      points.insert(points.begin(), a);
      points.push_back(b);
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
      {
        this->Split({ points[i], points[i + 1], apex }, original);
      }
      return;
    }
    this->Triangles.push_back(corners);
    this->Original.push_back(original);
  }

  std::map<std::pair<int, int>, std::vector<int>> On;
};

/// How well the seam closes. rest: the soup as joined. seam: points of the result in order.
void MeasureSeam(const Mesh& rest, const std::vector<int>& seam, const std::vector<int>& soupPoints,
  PastedFeature& result)
{
  const Eigen::MatrixXd& points = result.Surface.Points;
  std::set<std::pair<int, int>> edges;
  for (const auto& corners : rest.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.insert(std::minmax({ corners(k), corners((k + 1) % 3) }));
    }
  }
  double joined = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < seam.size(); ++i)
  {
    const int a = seam[i], b = seam[(i + 1) % seam.size()];
    const double length = (points.row(a) - points.row(b)).norm();
    whole += length;
    joined += edges.count(std::minmax({ a, b })) > 0 ? length : 0.0;
  }
  result.JoinedShare = whole > 0.0 ? joined / whole : 0.0;
  if (rest.Triangles.rows() > 0)
  {
    result.LargestGap = SurfaceLocator(Surface(rest)).FindLargestDistance(points(seam, Eigen::all));
  }
  if (!seam.empty() && !soupPoints.empty())
  {
    std::vector<int> around = seam;
    around.push_back(seam.front());
    const SurfaceLocator toSeam{ Surface(BuildFlatTriangles({ points(around, Eigen::all) })) };
    result.LargestGap =
      std::max(result.LargestGap, toSeam.FindLargestDistance(points(soupPoints, Eigen::all)));
  }
}

} // namespace

PastedFeature JoinFeatureAndSoup(const Eigen::MatrixXi& feature, const FeatureFootprint& base,
  const LoopOnSoup& landing, const Eigen::MatrixXd& deformed)
{
  const Eigen::Index all = landing.Rest.Points.rows();
  const std::vector<int> isUsed = InvertIndices(FindUsedPoints(landing.Rest.Triangles, all), all);
  const Seam seam(base, landing, isUsed);
  // Points that another one replaces are dropped.
  std::vector<int> kept;
  for (int point = 0; point < static_cast<int>(all); ++point)
  {
    if (isUsed[point] >= 0 && seam.Replaced.count(point) == 0)
    {
      kept.push_back(point);
    }
  }
  const auto first = static_cast<int>(kept.size());
  std::vector<int> numberOf = InvertIndices(kept, all);
  for (const auto& [point, by] : seam.Replaced)
  {
    numberOf[point] = by >= 0 ? first + base.Loop[by] : numberOf[-1 - by];
  }

  PastedFeature result;
  result.IsOnSoup = true;
  result.Surface.Points.resize(first + deformed.rows(), 3);
  result.Surface.Points << landing.Rest.Points(kept, Eigen::all), deformed;
  std::map<std::pair<int, int>, std::vector<int>> on;
  std::vector<int> along;
  const auto size = static_cast<int>(base.Loop.size());
  for (int i = 0; i < size; ++i)
  {
    const int a = first + base.Loop[i], b = first + base.Loop[(i + 1) % size];
    std::vector<int> between = seam.Between(i);
    for (int& point : between)
    {
      point = numberOf[point];
    }
    along.push_back(a);
    along.insert(along.end(), between.begin(), between.end());
    if (!between.empty())
    {
      on[{ a, b }] = std::move(between);
    }
  }
  const SplitFeature split(feature.array() + first, std::move(on));
  const Mesh rest{ result.Surface.Points,
    landing.Rest.Triangles.unaryExpr([&](int point) { return numberOf[point]; }) };
  const Eigen::Index ofSoup = rest.Triangles.rows();
  result.Surface.Triangles.resize(ofSoup + static_cast<Eigen::Index>(split.Triangles.size()), 3);
  result.Surface.Triangles.topRows(ofSoup) = rest.Triangles;
  Eigen::VectorXi soupCells = Eigen::VectorXi::Constant(result.Surface.Triangles.rows(), -1);
  Eigen::VectorXi featureCells = soupCells;
  soupCells.head(ofSoup) = landing.Origin.Cells;
  for (std::size_t t = 0; t < split.Triangles.size(); ++t)
  {
    const auto row = ofSoup + static_cast<Eigen::Index>(t);
    result.Surface.Triangles.row(row) << split.Triangles[t][0], split.Triangles[t][1],
      split.Triangles[t][2];
    featureCells(row) = split.Original[t];
  }
  ProvenanceWriter ofTarget(all), ofFeature(deformed.rows());
  for (const int point : kept)
  {
    ofTarget.AddCopy(point);
  }
  ofTarget.AddNone(deformed.rows());
  ofFeature.AddNone(first);
  ofFeature.AddCopies(deformed.rows());
  result.Target = Compose(landing.Origin, ofTarget.Finish(Eigen::VectorXi(0)));
  result.Target.Cells = soupCells;
  result.Feature = ofFeature.Finish(featureCells);

  std::vector<int> soupPoints;
  for (const SeamPoint& point : landing.Seam)
  {
    if (isUsed[point.Point] >= 0)
    {
      soupPoints.push_back(numberOf[point.Point]);
    }
  }
  MeasureSeam(rest, along, soupPoints, result);
  result.EulerNumber = ComputeTopology(result.Surface).EulerNumber;
  result.Landings.resize(1);
  result.Landings.front().Cover.Triangles.resize(landing.Covered);
  return result;
}

} // namespace shape
