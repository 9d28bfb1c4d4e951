#include "Surface/ExactGeodesics.h"

#include "Surface/SideFrames.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
/// In lengths of the edge: what is narrower, or nearer by less, is rounding.
constexpr double Rounding = 1e-10;
/// By how much a point's angle may be less than 2 pi and paths still turn there.
constexpr double AngleRounding = 1e-6;

/// An interval of a side that is seen from a place: in the side's frame, below the x axis.
struct Window
{
  int Side = -1; ///< of the triangle that it is carried into
  double Begin = 0.0, End = 0.0;
  Eigen::Vector2d Eye = Eigen::Vector2d::Zero();
  double Behind = 0.0; ///< the distance of the eye

  double DistanceAt(double x) const
  {
    return this->Behind + std::hypot(this->Eye(0) - x, this->Eye(1));
  }
  double Least() const
  {
    return this->DistanceAt(std::clamp(this->Eye(0), this->Begin, this->End));
  }
};

/// What is done next: a window is carried on, or a point sends out windows.
struct Event
{
  double Distance;
  int Point; ///< or -1
  Window Seen;
};

struct IsLater
{
  bool operator()(const Event& a, const Event& b) const { return a.Distance > b.Distance; }
};

class Propagation
{
public:
  Propagation(const Mesh& mesh)
    : Frames(mesh)
    , Distances(Eigen::VectorXd::Constant(mesh.Points.rows(), Infinity))
    , CornerDistances(mesh.Triangles.size(), Infinity)
    , CornerEntries(mesh.Triangles.size(), 0.0)
  {
  }

  void AddSeed(int triangle, const Eigen::RowVector3d& weights)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (weights(k) >= 1.0 - Rounding)
      {
        this->Reach(this->Frames.Begin(3 * triangle + k), 0.0, true);
        return;
      }
    }
    this->SeeFrom(triangle, weights);
    for (int k = 0; k < 3; ++k)
    {
      // On the side from corner k: it sees the other triangle, too.
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

  void Run(const Progress& progress)
  {
    constexpr int between = 4096;
    for (int step = 0; !this->Queue.empty(); ++step)
    {
      if (step % between == 0)
      {
        progress(this->Done());
      }
      const Event event = this->Queue.top();
      this->Queue.pop();
      if (event.Point < 0)
      {
        this->Carry(event.Seen);
      }
      else if (event.Distance <= this->Distances(event.Point))
      {
        this->SendOut(event.Point);
      }
    }
  }

  const Eigen::VectorXd& Result() const { return this->Distances; }

private:
  /// Of the points, the share that is reached.
  double Done() const
  {
    return static_cast<double>(this->Reached) / static_cast<double>(this->Distances.size());
  }

  /// Sees the three sides from a place in their triangle.
  void SeeFrom(int triangle, const Eigen::RowVector3d& weights)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int side = 3 * triangle + k, opposite = (k + 2) % 3;
      const Eigen::Vector2d place =
        weights((k + 1) % 3) * Eigen::Vector2d(this->Frames.Length(side), 0.0) +
        weights(opposite) * this->Frames.Opposite(side);
      this->Reach(this->Frames.Begin(side), place.norm(), false);
      if (weights(opposite) > 0.0)
      {
        this->See(side, 0.0, this->Frames.Length(side), place, 0.0);
      }
    }
  }

  /// Makes a window on the other side of an edge, where it is not useless. begin, end, eye: in the
  /// frame of `side`, from which it is seen.
  void See(int side, double begin, double end, const Eigen::Vector2d& eye, double behind)
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
    window.Eye = { length - eye(0), -eye(1) };
    window.Behind = behind;
    if (this->IsUseful(window))
    {
      this->Queue.push({ window.Least(), -1, window });
    }
  }

  bool IsUseful(const Window& window) const
  {
    const double length = this->Frames.Length(window.Side), slack = Rounding * length;
    const double begin = this->Distances(this->Frames.Begin(window.Side)),
                 end = this->Distances(this->Frames.End(window.Side));
    return window.End - window.Begin > slack &&
      window.DistanceAt(window.End) < begin + window.End + slack &&
      window.DistanceAt(window.Begin) < end + (length - window.Begin) + slack;
  }

  /// Shortens the distance of a point; one where paths may turn, or a seed, sends out windows.
  void Reach(int point, double distance, bool isSeed)
  {
    if (distance < this->Distances(point))
    {
      this->Reached += std::isinf(this->Distances(point)) ? 1 : 0;
      this->Distances(point) = distance;
      if (isSeed || this->Frames.IsOnBorder(point) ||
        this->Frames.Angle(point) > 2.0 * M_PI - AngleRounding)
      {
        this->Queue.push({ distance, point, {} });
      }
    }
  }

  void SendOut(int point)
  {
    const double distance = this->Distances(point);
    for (const int side : this->Frames.SidesFrom(point))
    {
      const int opposite = NextSide(side);
      this->Reach(this->Frames.End(side), distance + this->Frames.Length(side), false);
      const int back = PreviousSide(side);
      this->Reach(this->Frames.Begin(back), distance + this->Frames.Length(back), false);
      this->See(
        opposite, 0.0, this->Frames.Length(opposite), this->Frames.Opposite(opposite), distance);
    }
  }

  /// Carries a window across its triangle onto the two other sides.
  void Carry(const Window& window)
  {
    if (!this->IsUseful(window))
    {
      return;
    }
    const int side = window.Side, next = NextSide(side), previous = PreviousSide(side);
    const Eigen::Vector2d &corner = this->Frames.Opposite(side), &eye = window.Eye;
    // Where the line from the eye to the corner enters the triangle.
    const double entry = eye(0) - (corner(0) - eye(0)) * eye(1) / (corner(1) - eye(1));
    const double slack = Rounding * this->Frames.Length(side);
    bool left = entry > window.Begin, right = entry < window.End;
    if (entry >= window.Begin - slack && entry <= window.End + slack)
    {
      const double distance = window.Behind + (corner - eye).norm();
      double &nearest = this->CornerDistances[previous], &at = this->CornerEntries[previous];
      if (distance < nearest)
      {
        nearest = distance;
        at = entry;
      }
      else if (std::abs(entry - at) > slack)
      {
        // What sees the corner from nearer sees all that is beyond it better.
        left = left && entry < at;
        right = right && entry > at;
      }
      this->Reach(this->Frames.Begin(previous), distance, false);
    }
    const Eigen::Vector2d first(0.0, 0.0), second(this->Frames.Length(side), 0.0);
    if (left)
    {
      // From the corner to the begin of the side.
      this->See(previous, this->Crossing(window, std::min(entry, window.End), corner, first),
        this->Crossing(window, window.Begin, corner, first), this->InFrame(eye, corner, first),
        window.Behind);
    }
    if (right)
    {
      this->See(next, this->Crossing(window, window.End, second, corner),
        this->Crossing(window, std::max(entry, window.Begin), second, corner),
        this->InFrame(eye, second, corner), window.Behind);
    }
  }

  /// How far from `from` on the way to `to` the line from the eye through (x, 0) crosses.
  static double Crossing(
    const Window& window, double x, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    const Eigen::Vector2d ray(x - window.Eye(0), -window.Eye(1)), way = to - from,
                                                                  there = window.Eye - from;
    const double across = way(0) * ray(1) - way(1) * ray(0);
    const double length = way.norm();
    const double share = (there(0) * ray(1) - there(1) * ray(0)) / across;
    return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) * length : 0.0;
  }

  /// A place in the frame of the side from `from` to `to`.
  static Eigen::Vector2d InFrame(
    const Eigen::Vector2d& place, const Eigen::Vector2d& from, const Eigen::Vector2d& to)
  {
    const Eigen::Vector2d along = (to - from).normalized(), there = place - from;
    return { along.dot(there), along(0) * there(1) - along(1) * there(0) };
  }

  SideFrames Frames;
  Eigen::VectorXd Distances;
  std::vector<double> CornerDistances, CornerEntries; ///< of the window nearest to each corner
  std::priority_queue<Event, std::vector<Event>, IsLater> Queue;
  Eigen::Index Reached = 0;
};

} // namespace

Eigen::VectorXd ExactGeodesics(
  const Mesh& mesh, const ClosestPoints& seeds, const Progress& progress)
{
  Propagation propagation(mesh);
  for (Eigen::Index i = 0; i < seeds.Triangles.size(); ++i)
  {
    propagation.AddSeed(seeds.Triangles(i), seeds.Barycentrics.row(i));
  }
  propagation.Run(progress);
  progress(1.0);
  return propagation.Result();
}

} // namespace shape
