#include "Skeleton/Private/MedialBalls.h"

#include "Base/Parallel.h"
#include "Distance/SignedDistance.h"
#include "Geometry/VertexNormals.h"
#include "Mesh/Extent.h"
#include "Search/PointTree.h"

#include <cmath>
#include <vector>

namespace shape
{
namespace
{

/// The cosine of the separation angle below which a second point of contact is noise.
const double NoiseCosine = std::cos(40.0 * M_PI / 180.0);
constexpr int MostSteps = 40;

using Eigen::RowVector3d;

struct Shrinking
{
  const Eigen::MatrixXd& Points;
  const PointTree& Tree;
  double Largest;

  /// Returns the radius of the ball at a point. It is Largest if nothing stops the ball.
  double Radius(int p, const RowVector3d& normal) const
  {
    const RowVector3d point = this->Points.row(p);
    double radius = this->Largest;
    for (int step = 0; step < MostSteps; ++step)
    {
      const RowVector3d centre = point - radius * normal;
      const std::vector<int> nearest = this->Tree.Nearest(centre, 2);
      const int q = nearest[0] == p && nearest.size() > 1 ? nearest[1] : nearest[0];
      const RowVector3d chord = point - this->Points.row(q);
      const double depth = chord.dot(normal);
      // The ball through p and q with its centre on the normal at p.
      const double next = depth > 0.0 ? chord.squaredNorm() / (2.0 * depth) : radius;
      if (!(next < radius * (1.0 - 1e-6)))
      {
        return radius;
      }
      const RowVector3d moved = point - next * normal;
      const double cosine = normal.dot(this->Points.row(q) - moved) / next;
      if (step > 0 && cosine > NoiseCosine)
      {
        return radius;
      }
      radius = next;
    }
    return radius;
  }
};

/// Gives points whose ball has its centre outside the surface the ball of the nearest other point.
/// A ball at a sharp tip stops at once, because it touches points that its centre sees at a small
/// angle.
void ReplaceOutsideBalls(const Mesh& surface, MedialBalls& balls, const Progress& progress)
{
  const Eigen::VectorXd distances =
    SignedDistance(surface).Evaluate(balls.Centres, progress).Distances;
  std::vector<int> inside;
  for (int p = 0; p < static_cast<int>(distances.size()); ++p)
  {
    if (distances(p) <= 0.0)
    {
      inside.push_back(p);
    }
  }
  if (inside.empty())
  {
    return;
  }
  const PointTree tree(surface.Points(inside, Eigen::all));
  for (int p = 0; p < static_cast<int>(distances.size()); ++p)
  {
    if (distances(p) > 0.0)
    {
      const int other = inside[tree.Nearest(surface.Points.row(p), 1)[0]];
      balls.Radii(p) = balls.Radii(other);
      balls.Centres.row(p) = balls.Centres.row(other);
    }
  }
}

} // namespace

MedialBalls ShrinkMedialBalls(const Mesh& surface, const Progress& progress)
{
  const int count = static_cast<int>(surface.Points.rows());
  const Eigen::MatrixXd normals = ComputeVertexNormals(surface, NormalWeight::Angle);
  const PointTree tree(surface.Points);
  const Shrinking shrinking{ surface.Points, tree, 0.5 * ComputeBoxDiagonal(surface) };
  MedialBalls balls{ surface.Points, Eigen::VectorXd::Zero(count) };
  ParallelFor(
    count, 256,
    [&](int begin, int end)
    {
      for (int p = begin; p < end; ++p)
      {
        balls.Radii(p) = shrinking.Radius(p, normals.row(p));
        balls.Centres.row(p) -= balls.Radii(p) * normals.row(p);
      }
    },
    progress.Part(0.0, 0.5));
  ReplaceOutsideBalls(surface, balls, progress.Part(0.5, 1.0));
  return balls;
}

} // namespace shape
