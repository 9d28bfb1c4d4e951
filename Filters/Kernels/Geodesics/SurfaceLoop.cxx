#include "Geodesics/SurfaceLoop.h"

#include "Base/Errors.h"
#include "Mesh/CoincidentPoints.h"

#include <algorithm>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace shape
{

namespace
{

/// Returns a polyline's positions without consecutive duplicates.
std::vector<int> GetLoopPositions(const std::vector<int>& polyline, const std::vector<int>& first)
{
  std::vector<int> positions;
  for (const int point : polyline)
  {
    if (positions.empty() || positions.back() != first[point])
    {
      positions.push_back(first[point]);
    }
  }
  return positions;
}

/// Open polylines, and those that end at each position.
class OpenLines
{
public:
  explicit OpenLines(std::vector<std::vector<int>> lines)
    : Lines(std::move(lines))
    , IsUsed(this->Lines.size(), 0)
  {
    for (std::size_t i = 0; i < this->Lines.size(); ++i)
    {
      this->EndsAt[this->Lines[i].front()].push_back(i);
      this->EndsAt[this->Lines[i].back()].push_back(i);
    }
  }

  /// Returns the closed path that starts with a polyline and continues over others, each used once.
  /// If it cannot be closed, its last position is where it cannot continue. Greedy: at a branch any
  /// unused line will do, since each is used once.
  std::vector<int> WayFrom(std::size_t line)
  {
    std::vector<int> way = this->Lines[line];
    this->IsUsed[line] = 1;
    while (way.back() != way.front())
    {
      const std::vector<std::size_t>& ends = this->EndsAt[way.back()];
      const auto next = std::find_if(
        ends.begin(), ends.end(), [&](std::size_t other) { return this->IsUsed[other] == 0; });
      if (next == ends.end())
      {
        break;
      }
      std::vector<int> own = this->Lines[*next];
      this->IsUsed[*next] = 1;
      if (own.front() != way.back())
      {
        std::reverse(own.begin(), own.end());
      }
      way.insert(way.end(), own.begin() + 1, own.end());
    }
    return way;
  }

  std::size_t Count() const { return this->Lines.size(); }
  bool WasUsed(std::size_t line) const { return this->IsUsed[line] != 0; }

private:
  std::vector<std::vector<int>> Lines;
  std::vector<char> IsUsed;
  std::map<int, std::vector<std::size_t>> EndsAt;
};

/// Consecutive different positions on a surface, around a loop.
struct LoopStops
{
  std::vector<SurfacePoint> Points;
  std::vector<Eigen::RowVector3d> Positions;

  void Add(const SurfacePoint& point, const Eigen::RowVector3d& position)
  {
    // A leg of length 0 has no direction.
    if (this->Positions.empty() || this->Positions.back() != position)
    {
      this->Points.push_back(point);
      this->Positions.push_back(position);
    }
  }

  void Close()
  {
    if (this->Points.size() > 1 && this->Positions.front() == this->Positions.back())
    {
      this->Points.pop_back();
      this->Positions.pop_back();
    }
    if (this->Points.size() < 3)
    {
      throw InvalidInput("the loop has " + std::to_string(this->Points.size()) +
        " different positions on the surface; draw a closed curve through at least 3");
    }
  }
};

LoopStops FindStops(const Eigen::MatrixXd& points, const SurfaceLocator& locator)
{
  LoopStops stops;
  int guess = -1;
  for (const auto& point : points.rowwise())
  {
    // Consecutive points are near each other: the last triangle is a good guess.
    const ClosestPoint position = locator.FindOne(point, guess);
    guess = position.Triangle;
    stops.Add({ position.Triangle, position.Barycentric }, position.Position);
  }
  stops.Close();
  return stops;
}

LoopStops MoveToCreases(
  const LoopStops& stops, const Mesh& surface, const CreasePaths& paths, double reach)
{
  LoopStops moved;
  const std::size_t count = stops.Points.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Eigen::RowVector3d& here = stops.Positions[i];
    const double nearest = std::min((stops.Positions[(i + 1) % count] - here).norm(),
      (stops.Positions[(i + count - 1) % count] - here).norm());
    const SurfacePoint point = paths.MoveToCrease(stops.Points[i], reach * nearest);
    moved.Add(point, GetPosition(surface, point));
  }
  moved.Close();
  return moved;
}

} // namespace

std::vector<Eigen::MatrixXd> ChainClosedCurves(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& polylines, const std::string& name)
{
  const std::vector<int> first = FindCoincidentPoints(points);
  std::vector<Eigen::MatrixXd> curves;
  const auto add = [&](const std::vector<int>& way)
  { curves.emplace_back(points(std::vector<int>(way.begin(), way.end() - 1), Eigen::all)); };
  std::vector<std::vector<int>> open;
  for (const std::vector<int>& polyline : polylines)
  {
    const std::vector<int> positions = GetLoopPositions(polyline, first);
    if (positions.size() > 1 && positions.front() == positions.back())
    {
      add(positions);
    }
    else if (positions.size() > 1)
    {
      open.push_back(positions);
    }
  }
  OpenLines lines(open);
  for (std::size_t i = 0; i < lines.Count(); ++i)
  {
    if (lines.WasUsed(i))
    {
      continue;
    }
    const std::vector<int> way = lines.WayFrom(i);
    if (way.back() != way.front())
    {
      std::ostringstream words;
      words << name << " has an open curve, which ends at (" << points(way.back(), 0) << ", "
            << points(way.back(), 1) << ", " << points(way.back(), 2)
            << "); close it, for example by setting Closed of Poly Line Source";
      throw InvalidInput(words.str());
    }
    add(way);
  }
  return curves;
}

SurfaceLoop TraceLoopThrough(const Eigen::MatrixXd& points, const SurfaceLocator& locator,
  SurfacePaths& paths, const CreaseOptions& creases, const Progress& progress)
{
  RequireOptions(creases);
  LoopStops stops = FindStops(points, locator);
  std::optional<CreasePaths> alongCreases;
  if (creases.CreaseWeight > 0.0)
  {
    alongCreases.emplace(locator.GetSurface(), paths, creases);
    stops = MoveToCreases(stops, locator.GetSurface(), *alongCreases, creases.CreaseReach);
  }
  SurfaceLoop loop;
  const std::size_t count = stops.Points.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const Progress onePart(
      [&, done = static_cast<double>(i) / static_cast<double>(count)](double)
      {
        progress(done);
        return true;
      });
    const SurfacePoint &from = stops.Points[i], &to = stops.Points[(i + 1) % count];
    const SurfacePath path =
      alongCreases ? alongCreases->Find(from, to, onePart) : paths.Find(from, to, onePart);
    loop.Positions.insert(loop.Positions.end(), path.Positions.begin(), path.Positions.end() - 1);
    loop.Triangles.insert(loop.Triangles.end(), path.Triangles.begin(), path.Triangles.end());
  }
  progress(1.0);
  return loop;
}

} // namespace shape
