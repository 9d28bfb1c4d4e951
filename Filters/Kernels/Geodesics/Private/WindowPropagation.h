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

/// The half-edges of a surface as frames in the plane: half-edge 3 t + k runs from corner k of
/// triangle t, at the origin, to the next one along the x axis, and its triangle is above.
class HalfEdgeFrames
{
public:
  /// surface: a consistently oriented 2-manifold, open or closed.
  explicit HalfEdgeFrames(const Surface& surface);

  int Begin(int side) const { return this->Begins[side]; } ///< the point
  int End(int side) const { return this->Begins[NextHalfEdge(side)]; }
  int Twin(int side) const { return this->Twins[side]; } ///< in the adjacent triangle; -1: none
  double Length(int side) const { return this->Lengths[side]; }
  /// The corner opposite, in the frame.
  const Eigen::Vector2d& Opposite(int side) const { return this->Opposites[side]; }

  double Angle(int point) const { return this->Angles[point]; } ///< of all its corners
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
 * Carries windows across a surface in the order of the shortest path that may lead through them:
 * see ExactGeodesics.h. Used for one computation after the other; Clear comes between.
 */
class WindowPropagation
{
public:
  /// Keeps references to both, which are of one surface.
  WindowPropagation(const Mesh& mesh, const HalfEdgeFrames& frames);

  /// A position, by its barycentric coordinates in a triangle.
  void AddSeed(int triangle, const Eigen::RowVector3d& weights);

  /// Looks for the path to this position alone, first where it can be shortest by the straight
  /// distances that are left (Hart, Nilsson and Raphael 1968). Before AddSeed.
  void SetGoal(int triangle, const Eigen::RowVector3d& weights);

  /// Goes on for as many windows and points. Returns whether all is done.
  bool Run(int steps);

  /// Of the points, the share that is reached.
  double Done() const;

  /// n: with a goal, of the points on the way only.
  const Eigen::VectorXd& Distances() const { return this->Lengths; }

  /// To the goal; infinite if no path leads there.
  double GoalDistance() const { return this->Goal.Nearest; }

  /// Forgets the seeds and the goal, in less time than the last computation took.
  void Clear();

private:
  static constexpr double Infinity = std::numeric_limits<double>::infinity();

  /// An interval of a half-edge that is seen from a position: in its frame, below the x axis.
  struct Window
  {
    int Side = -1; ///< of the triangle that it is carried into
    double Begin = 0.0, End = 0.0;
    Eigen::Vector2d Eye = Eigen::Vector2d::Zero();
    double Behind = 0.0; ///< the distance of the eye

    double DistanceAt(double x) const;
    double Minimum() const;
  };

  /// What is done next: a window is carried on, or a point sends out windows.
  struct Event
  {
    double Key; ///< no path by way of it to the goal, or to anywhere, is shorter
    double Distance;
    int Point; ///< or -1
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
  std::vector<double> CornerDistances, CornerEntries; ///< of the window nearest to each corner
  std::vector<int> ReachedPoints, ReachedCorners;     ///< that have a distance
  std::priority_queue<Event> Queue;
  GoalPoint Goal;
};

} // namespace shape
