#pragma once

#include "Mesh/HalfEdges.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <limits>
#include <queue>
#include <vector>

namespace shape
{

/// The half-edges of a surface as coordinate frames in the plane. Half-edge 3 t + k runs from
/// corner k of triangle t, at the origin, to the next corner on the x axis. Its triangle lies
/// above.
class HalfEdgeFrames
{
public:
  /// surface: a consistently oriented 2-manifold, open or closed.
  explicit HalfEdgeFrames(const Surface& surface);

  int Begin(int side) const { return this->Begins[side]; } ///< start point
  int End(int side) const { return this->Begins[NextHalfEdge(side)]; }
  /// in the adjacent triangle; -1 on the boundary
  int Twin(int side) const { return this->Twins[side]; }
  double Length(int side) const { return this->Lengths[side]; }
  /// The opposite corner, in the frame.
  const Eigen::Vector2d& Opposite(int side) const { return this->Opposites[side]; }

  double Angle(int point) const { return this->Angles[point]; } ///< total angle around a point
  bool IsOnBoundary(int point) const { return this->OnBoundary[point] != 0; }
  const std::vector<int>& HalfEdgesFrom(int point) const { return this->From[point]; }

private:
  std::vector<int> Begins, Twins;
  std::vector<double> Lengths;
  std::vector<Eigen::Vector2d> Opposites;
  std::vector<double> Angles;
  std::vector<char> OnBoundary;
  std::vector<std::vector<int>> From;
};

/**
 * Propagates windows across a surface, ordered by the length of the shortest path that may pass
 * through them: see ExactGeodesics.h. An object serves many computations; call Clear between them.
 */
class WindowPropagation
{
public:
  /// Keeps references to both, which must belong to the same surface.
  WindowPropagation(const Mesh& mesh, const HalfEdgeFrames& frames);

  /// Adds a seed, given by its barycentric coordinates in a triangle.
  void AddSeed(int triangle, const Eigen::RowVector3d& weights);

  /// Restricts the search to the path to this position. Windows are ordered by a lower bound of the
  /// length to the goal, which includes the remaining straight distance (Hart, Nilsson and Raphael
  /// 1968). Call it before AddSeed.
  void SetGoal(int triangle, const Eigen::RowVector3d& weights);

  /// Processes at most `steps` windows and points. Returns whether the computation is complete.
  bool Run(int steps);

  /// Returns the share of the points that has been reached.
  double Done() const;

  /// n distances; with a goal, only the points that were visited have one
  const Eigen::VectorXd& Distances() const { return this->Lengths; }

  /// The distance of the goal; infinite if there is no path.
  double GoalDistance() const { return this->Goal.Nearest; }

  /// Removes the seeds and the goal, in less time than the last computation took.
  void Clear();

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  /// An interval of a half-edge that is visible from a position (the eye). Coordinates are in the
  /// half-edge's frame, where the eye lies below the x axis.
  struct Window
  {
    int Side = -1; ///< half-edge of the triangle that it is propagated into
    double Begin = 0.0, End = 0.0;
    Eigen::Vector2d Eye = Eigen::Vector2d::Zero();
    double Behind = 0.0; ///< distance from the seeds to the eye

    double DistanceAt(double x) const;
    double Minimum() const;
  };

  /// The next item to process: propagate a window, or emit windows from a point.
  struct Event
  {
    double Key; ///< lower bound of the length of a path through it, to the goal if there is one
    double Distance;
    int Point; ///< the point, or -1 for a window
    Window Seen;
    bool operator<(const Event& other) const { return this->Key > other.Key; }
  };

  struct GoalPoint
  {
    int Triangle = -1;
    Eigen::RowVector3d Weights = Eigen::RowVector3d::Zero(), Position = Eigen::RowVector3d::Zero();
    double Nearest = Infinity;
  };

  double Ahead(int point) const;
  double AheadOfHalfEdge(int side) const;
  Eigen::Vector2d PositionInFrame(int side, const Eigen::RowVector3d& weights) const;
  void SeeFrom(int triangle, const Eigen::RowVector3d& weights);
  void See(int side, double begin, double end, const Eigen::Vector2d& eye, double behind);
  bool IsUseful(const Window& window) const;
  void Reach(int point, double distance, bool isSeed);
  void SeeGoal(const Window& window);
  void SendOut(int point);
  void Carry(const Window& window);

  const Mesh& Triangulation;
  const HalfEdgeFrames& Frames;
  Eigen::VectorXd Lengths;
  /// of the nearest window that sees each corner
  std::vector<double> CornerDistances, CornerEntries;
  std::vector<int> ReachedPoints, ReachedCorners; ///< points and corners that have a distance
  std::priority_queue<Event> Queue;
  GoalPoint Goal;
};

} // namespace shape
