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
/// corner k of triangle t, at the origin, to the next corner, on the x axis. Its triangle lies
/// above the x axis. Points that edges of length 0 join are one place, and the first of them stands
/// for all: a path turns around all of their triangles.
class HalfEdgeFrames
{
public:
  /// surface: a consistently oriented 2-manifold, open or closed.
  explicit HalfEdgeFrames(const Surface& surface);

  int Place(int point) const { return this->Places[point]; } ///< the first point of its place
  int Begin(int side) const { return this->Begins[side]; } ///< start point, the first of its place
  int End(int side) const { return this->Begins[NextHalfEdge(side)]; }
  /// the opposite half-edge, in the adjacent triangle; -1 on the boundary
  int Twin(int side) const { return this->Twins[side]; }
  double Length(int side) const { return this->Lengths[side]; }
  /// the opposite corner, in the frame of the half-edge
  const Eigen::Vector2d& Opposite(int side) const { return this->Opposites[side]; }

  double Angle(int point) const { return this->Angles[point]; } ///< total angle around a point
  bool IsOnBoundary(int point) const { return this->OnBoundary[point] != 0; }
  const std::vector<int>& HalfEdgesFrom(int point) const { return this->From[point]; }

private:
  std::vector<int> Places, Begins, Twins;
  std::vector<double> Lengths;
  std::vector<Eigen::Vector2d> Opposites;
  std::vector<double> Angles;
  std::vector<char> OnBoundary;
  std::vector<std::vector<int>> From;
};

/**
 * Propagates windows across a surface (ExactGeodesics.h). Windows are ordered by the minimum length
 * of a path through them. An object serves many computations; call Clear between them.
 */
class WindowPropagation
{
public:
  /// Keeps references to both, which must belong to the same surface.
  WindowPropagation(const Mesh& mesh, const HalfEdgeFrames& frames);

  /// Adds a seed, given by its barycentric coordinates in a triangle.
  void AddSeed(int triangle, const Eigen::RowVector3d& weights);

  /// Restricts the search to the shortest path to this position, the goal. Windows are then ordered
  /// by a lower bound of the length of a path through them to the goal. The bound includes the
  /// remaining straight distance (Hart, Nilsson and Raphael 1968). Call it before AddSeed.
  void SetGoal(int triangle, const Eigen::RowVector3d& weights);

  /// Processes at most `steps` windows and points. Returns whether the computation is complete.
  /// Throws SolveFailure if there are far more windows than on any surface whose triangles double
  /// precision resolves.
  bool Run(int steps);

  /// Returns the share of the surface's points that have been reached.
  double Done() const;

  /// Returns the n distances of the points, infinite at points that were not reached. With a goal,
  /// not all points are reached.
  Eigen::VectorXd Distances() const;

  /// Returns the distance of the goal, infinite if there is no path.
  double GoalDistance() const { return this->Goal.Nearest; }

  /// Removes the seeds and the goal, in less time than the last computation took.
  void Clear();

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  /// An interval of a half-edge, visible from a position (the eye). Coordinates are in the frame of
  /// the half-edge, where the eye lies below the x axis.
  struct Window
  {
    int Side = -1; ///< the half-edge, in the triangle that the window enters
    double Begin = 0.0, End = 0.0;
    Eigen::Vector2d Eye = Eigen::Vector2d::Zero();
    double Behind = 0.0; ///< distance from the seeds to the eye

    double DistanceAt(double x) const;
    double Minimum() const;
  };

  /// An item of the queue: a window to propagate, or a point from which windows are emitted.
  struct Event
  {
    /// lower bound of the length of a path through the item, up to the goal if there is one
    double Key;
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
  /// for each corner: its distance through the nearest window from which it is visible, and the
  /// position where the straight line to it enters the triangle
  std::vector<double> CornerDistances, CornerEntries;
  std::vector<int> ReachedPoints, ReachedCorners; ///< points and corners that have a distance
  std::priority_queue<Event> Queue;
  long long Steps = 0; ///< processed since the last Clear
  GoalPoint Goal;
};

} // namespace shape
