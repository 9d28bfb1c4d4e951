#include "Geodesics/Private/WindowPropagation.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

/// Relative to the edge length: smaller widths and distance gains are rounding error.
constexpr double Rounding = 1e-10;
/// Paths may turn at points whose angle is less than 2 pi by at most this.
constexpr double AngleRounding = 1e-6;

/// A surface of good triangles has about 10 windows for each half-edge, one of slivers up to 100.
constexpr long long MaximumStepsPerSide = 1000, MinimumOfMaximumSteps = 1000000;

/// Returns, for each point, the first of the points to which edges of length 0 join it.
std::vector<int> FindPlaces(const Mesh& mesh)
{
  const auto count = static_cast<int>(mesh.Points.rows());
  DisjointSets joined(count);
  for (const auto& corners : mesh.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const int begin = corners(k), end = corners((k + 1) % 3);
      if (mesh.Points.row(begin) == mesh.Points.row(end))
      {
        joined.Merge(begin, end);
      }
    }
  }
  std::vector<int> first(count, -1), places(count);
  for (int point = 0; point < count; ++point)
  {
    int& known = first[joined.Find(point)];
    known = known == -1 ? point : known;
    places[point] = known;
  }
  return places;
}

/// Returns the distance from `from` at which the ray from `eye` through (x, 0) crosses the segment
/// to `to`.
double Crossing(
  const Eigen::Vector2d& eye, double x, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  const Eigen::Vector2d ray(x - eye(0), -eye(1)), way = to - from, there = eye - from;
  const double across = way(0) * ray(1) - way(1) * ray(0);
  const double share = (there(0) * ray(1) - there(1) * ray(0)) / across;
  return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) * way.norm() : 0.0;
}

/// Returns a position in the frame of the half-edge from `from` to `to`.
Eigen::Vector2d InFrame(
  const Eigen::Vector2d& position, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
{
  const Eigen::Vector2d along = (to - from).normalized(), there = position - from;
  return { along.dot(there), along(0) * there(1) - along(1) * there(0) };
}

} // namespace

HalfEdgeFrames::HalfEdgeFrames(const Surface& surface)
  : Places(FindPlaces(surface))
  , Begins(surface.Triangles().size())
  , Twins(surface.Twins())
  , Lengths(surface.Triangles().size())
  , Opposites(surface.Triangles().size())
  , Angles(surface.Points().rows(), 0.0)
  , OnBoundary(surface.Points().rows(), 0)
  , From(surface.Points().rows())
{
  const Mesh& mesh = surface;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(mesh, t);
    for (int k = 0; k < 3; ++k)
    {
      const int side = static_cast<int>(3 * t + k);
      const Eigen::RowVector3d along = corners.row((k + 1) % 3) - corners.row(k),
                               there = corners.row((k + 2) % 3) - corners.row(k);
      const double length = along.norm();
      const int begin = this->Places[mesh.Triangles(t, k)];
      this->Begins[side] = begin;
      this->Lengths[side] = length;
      const double x = length > 0.0 ? along.dot(there) / length : 0.0;
      const double y = length > 0.0 ? along.cross(there).norm() / length : there.norm();
      this->Opposites[side] = { x, y };
      // The total angle decides whether paths may turn at the point: less than 2 pi, and a path
      // beside it is shorter. An edge of length 0 has no direction.
      this->Angles[begin] += length > 0.0 ? std::atan2(y, x) : 0.0;
      this->From[begin].push_back(side);
    }
  }
  for (int side = 0; side < static_cast<int>(this->Twins.size()); ++side)
  {
    if (this->Twins[side] < 0)
    {
      this->OnBoundary[this->Begin(side)] = this->OnBoundary[this->End(side)] = 1;
    }
  }
}

double WindowPropagation::Window::DistanceAt(double x) const
{
  return this->Behind + std::hypot(this->Eye(0) - x, this->Eye(1));
}

double WindowPropagation::Window::Minimum() const
{
  return this->DistanceAt(std::clamp(this->Eye(0), this->Begin, this->End));
}

WindowPropagation::WindowPropagation(const Mesh& mesh, const HalfEdgeFrames& frames)
  : Triangulation(mesh)
  , Frames(frames)
  , Lengths(Eigen::VectorXd::Constant(mesh.Points.rows(), Infinity))
  , CornerDistances(mesh.Triangles.size(), Infinity)
  , CornerEntries(mesh.Triangles.size(), 0.0)
{
}

void WindowPropagation::Clear()
{
  for (const int point : this->ReachedPoints)
  {
    this->Lengths(point) = Infinity;
  }
  for (const int corner : this->ReachedCorners)
  {
    this->CornerDistances[corner] = Infinity;
  }
  this->ReachedPoints.clear();
  this->ReachedCorners.clear();
  this->Queue = {};
  this->Goal = {};
  this->Steps = 0;
}

Eigen::VectorXd WindowPropagation::Distances() const
{
  Eigen::VectorXd distances(this->Lengths.size());
  for (int point = 0; point < distances.size(); ++point)
  {
    distances(point) = this->Lengths(this->Frames.Place(point));
  }
  return distances;
}

void WindowPropagation::SetGoal(int triangle, const Eigen::RowVector3d& weights)
{
  this->Goal.Triangle = triangle;
  this->Goal.Weights = weights;
  this->Goal.Position = weights * GetCorners(this->Triangulation, triangle);
}

/// A seed at a point acts like a point at which paths turn; one inside sees the edges of its
/// triangle.
void WindowPropagation::AddSeed(int triangle, const Eigen::RowVector3d& weights)
{
  for (int k = 0; k < 3; ++k)
  {
    const int place = this->Frames.Begin(3 * triangle + k);
    double weight = 0.0; // of all corners that are at this place
    for (int other = 0; other < 3; ++other)
    {
      weight += this->Frames.Begin(3 * triangle + other) == place ? weights(other) : 0.0;
    }
    if (weight >= 1.0 - Rounding)
    {
      this->Reach(place, 0.0, true);
      return;
    }
  }
  this->SeeFrom(triangle, weights);
  for (int k = 0; k < 3; ++k)
  {
    // A seed on the edge from corner k also sees the adjacent triangle.
    const int twin = this->Frames.Twin(3 * triangle + k);
    if (weights((k + 2) % 3) == 0.0 && twin >= 0)
    {
      Eigen::RowVector3d there = Eigen::RowVector3d::Zero();
      there(twin % 3) = weights((k + 1) % 3);
      there((twin + 1) % 3) = weights(k);
      this->SeeFrom(twin / 3, there);
    }
  }
}

/// Continuous Dijkstra: the window or point that may give the shortest path is processed first.
bool WindowPropagation::Run(int steps)
{
  this->Steps += steps;
  if (this->Steps >
    MinimumOfMaximumSteps + MaximumStepsPerSide * this->Triangulation.Triangles.size())
  {
    throw SolveFailure("exact distances need more than " + std::to_string(this->Steps) +
      " windows, because triangles are too thin for double precision; check for points that are "
      "far away, or remesh");
  }
  for (int step = 0; step < steps; ++step)
  {
    // Keys are lower bounds: no later event can give a shorter path.
    if (this->Queue.empty() || this->Queue.top().Key >= this->Goal.Nearest)
    {
      return true;
    }
    const Event event = this->Queue.top();
    this->Queue.pop();
    if (event.Point < 0)
    {
      this->Carry(event.Seen);
    }
    else if (event.Distance <= this->Lengths(event.Point))
    {
      this->SendOut(event.Point);
    }
  }
  return false;
}

double WindowPropagation::Done() const
{
  return static_cast<double>(this->ReachedPoints.size()) /
    static_cast<double>(this->Lengths.size());
}

/// Returns a lower bound of the length of a path from a point to the goal.
double WindowPropagation::Ahead(int point) const
{
  return this->Goal.Triangle < 0
    ? 0.0
    : (this->Triangulation.Points.row(point) - this->Goal.Position).norm();
}

/// Returns a lower bound of the length of a path from any position on a half-edge to the goal.
double WindowPropagation::AheadOfHalfEdge(int side) const
{
  if (this->Goal.Triangle < 0)
  {
    return 0.0;
  }
  const Eigen::RowVector3d begin = this->Triangulation.Points.row(this->Frames.Begin(side)),
                           way = this->Triangulation.Points.row(this->Frames.End(side)) - begin,
                           there = this->Goal.Position - begin;
  const double square = way.squaredNorm();
  const double share = square > 0.0 ? std::clamp(way.dot(there) / square, 0.0, 1.0) : 0.0;
  return (there - share * way).norm();
}

/// Returns a position in the triangle of a half-edge, in the half-edge's frame.
Eigen::Vector2d WindowPropagation::PositionInFrame(
  int side, const Eigen::RowVector3d& weights) const
{
  return weights(NextHalfEdge(side) % 3) * Eigen::Vector2d(this->Frames.Length(side), 0.0) +
    weights(PreviousHalfEdge(side) % 3) * this->Frames.Opposite(side);
}

/// Creates the windows of a triangle's three edges as seen from a position in it.
void WindowPropagation::SeeFrom(int triangle, const Eigen::RowVector3d& weights)
{
  if (triangle == this->Goal.Triangle)
  {
    this->Goal.Nearest = std::min(this->Goal.Nearest,
      (weights * GetCorners(this->Triangulation, triangle) - this->Goal.Position).norm());
  }
  for (int k = 0; k < 3; ++k)
  {
    const int side = 3 * triangle + k;
    const Eigen::Vector2d position = this->PositionInFrame(side, weights);
    this->Reach(this->Frames.Begin(side), position.norm(), false);
    if (weights((k + 2) % 3) > 0.0)
    {
      this->See(side, 0.0, this->Frames.Length(side), position, 0.0);
    }
  }
}

/// Creates a window on the other side of an edge unless it is useless. begin, end, eye: in the
/// frame of `side`, the half-edge on the near side.
void WindowPropagation::See(
  int side, double begin, double end, const Eigen::Vector2d& eye, double behind)
{
  const int twin = this->Frames.Twin(side);
  if (twin < 0)
  {
    return;
  }
  const double length = this->Frames.Length(side);
  Window window;
  window.Side = twin;
  window.Begin = std::max(length - end, 0.0);
  window.End = std::min(length - begin, length);
  // The frame of the twin is rotated by half a turn about the middle of the edge.
  window.Eye = { length - eye(0), -eye(1) };
  window.Behind = behind;
  const double minimum = window.Minimum(), key = minimum + this->AheadOfHalfEdge(twin);
  if (this->IsUseful(window) && key < this->Goal.Nearest)
  {
    this->Queue.push({ key, minimum, -1, window });
  }
}

/// Xin and Wang: a window is dropped if at its far end, seen from either end of the edge, the way
/// along the edge is shorter than the straight one.
bool WindowPropagation::IsUseful(const Window& window) const
{
  const double length = this->Frames.Length(window.Side), slack = Rounding * length;
  const double begin = this->Lengths(this->Frames.Begin(window.Side)),
               end = this->Lengths(this->Frames.End(window.Side));
  return window.End - window.Begin > slack &&
    window.DistanceAt(window.End) < begin + window.End + slack &&
    window.DistanceAt(window.Begin) < end + (length - window.Begin) + slack;
}

/// Lowers the distance of a point. If it is a seed, or paths may turn there, it will emit windows.
void WindowPropagation::Reach(int point, double distance, bool isSeed)
{
  if (distance >= this->Lengths(point))
  {
    return;
  }
  if (std::isinf(this->Lengths(point)))
  {
    this->ReachedPoints.push_back(point);
  }
  this->Lengths(point) = distance;
  const double ahead = this->Ahead(point);
  for (int k = 0; k < 3 && this->Goal.Triangle >= 0; ++k)
  {
    if (this->Frames.Begin(3 * this->Goal.Triangle + k) == point)
    {
      this->Goal.Nearest = std::min(this->Goal.Nearest, distance + ahead);
    }
  }
  const bool turns = isSeed || this->Frames.IsOnBoundary(point) ||
    this->Frames.Angle(point) > 2.0 * M_PI - AngleRounding;
  if (turns && distance + ahead < this->Goal.Nearest)
  {
    this->Queue.push({ distance + ahead, distance, point, {} });
  }
}

/// Lowers the goal's distance to the shortest path through a window of its triangle.
void WindowPropagation::SeeGoal(const Window& window)
{
  const Eigen::Vector2d position = this->PositionInFrame(window.Side, this->Goal.Weights),
                        &eye = window.Eye;
  const double height = position(1) - eye(1);
  const double entry =
    height > 0.0 ? eye(0) - (position(0) - eye(0)) * eye(1) / height : position(0);
  const double nearest = std::clamp(entry, window.Begin, window.End);
  this->Goal.Nearest = std::min(this->Goal.Nearest,
    window.DistanceAt(nearest) + std::hypot(position(0) - nearest, position(1)));
}

/// A path that turns here continues along the edges, or across the triangles around the point.
void WindowPropagation::SendOut(int point)
{
  const double distance = this->Lengths(point);
  for (const int side : this->Frames.HalfEdgesFrom(point))
  {
    const int opposite = NextHalfEdge(side);
    this->Reach(this->Frames.End(side), distance + this->Frames.Length(side), false);
    const int back = PreviousHalfEdge(side);
    this->Reach(this->Frames.Begin(back), distance + this->Frames.Length(back), false);
    this->See(
      opposite, 0.0, this->Frames.Length(opposite), this->Frames.Opposite(opposite), distance);
  }
}

/// Propagates a window across its triangle to the two other edges.
void WindowPropagation::Carry(const Window& window)
{
  if (!this->IsUseful(window))
  {
    return;
  }
  const int side = window.Side, next = NextHalfEdge(side), previous = PreviousHalfEdge(side);
  if (side / 3 == this->Goal.Triangle)
  {
    this->SeeGoal(window); // the shortest path ends in this triangle
    return;
  }
  const Eigen::Vector2d &corner = this->Frames.Opposite(side), &eye = window.Eye;
  // Position where the line from the eye to the corner enters the triangle.
  const double entry = eye(0) - (corner(0) - eye(0)) * eye(1) / (corner(1) - eye(1));
  const double slack = Rounding * this->Frames.Length(side);
  bool left = entry > window.Begin, right = entry < window.End;
  if (entry >= window.Begin - slack && entry <= window.End + slack)
  {
    const double distance = window.Behind + (corner - eye).norm();
    // Chen and Han, "one angle one split": of all windows that see the corner, only the one with
    // the shortest path to it continues on both sides.
    double &nearest = this->CornerDistances[previous], &at = this->CornerEntries[previous];
    if (distance < nearest)
    {
      if (std::isinf(nearest))
      {
        this->ReachedCorners.push_back(previous);
      }
      nearest = distance;
      at = entry;
    }
    else if (std::abs(entry - at) > slack)
    {
      // An eye nearer to the corner gives shorter paths to everything on its side beyond the
      // corner.
      left = left && entry < at;
      right = right && entry > at;
    }
    this->Reach(this->Frames.Begin(previous), distance, false);
  }
  const Eigen::Vector2d first(0.0, 0.0), second(this->Frames.Length(side), 0.0);
  if (left)
  {
    // The edge from the corner to the begin of the half-edge.
    this->See(previous, Crossing(eye, std::min(entry, window.End), corner, first),
      Crossing(eye, window.Begin, corner, first), InFrame(eye, corner, first), window.Behind);
  }
  if (right)
  {
    this->See(next, Crossing(eye, window.End, second, corner),
      Crossing(eye, std::max(entry, window.Begin), second, corner), InFrame(eye, second, corner),
      window.Behind);
  }
}

} // namespace shape
