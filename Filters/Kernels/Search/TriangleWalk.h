#pragma once

#include "Base/Progress.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

/// The triangles around each point; point i has Triangles[First[i]] ... Triangles[First[i + 1] -
/// 1].
struct TriangleFans
{
  TriangleFans(const Eigen::MatrixXi& triangles, Eigen::Index points);

  std::vector<int> First, Triangles;
};

/// Walks on a surface in any dimension towards a position. Each step goes to a triangle that shares
/// a corner with the previous one, as long as the distance decreases.
class TriangleWalk
{
public:
  /// triangles: m x 3. points: d x n, one per column. Keeps references to all arguments.
  TriangleWalk(
    const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points, const TriangleFans& fans)
    : Triangles(triangles)
    , Points(points)
    , Fans(fans)
  {
  }

  /// Walks from the triangles around `point` to a local minimum of the distance to `towards`. The
  /// point must have at least one triangle.
  void Go(int point, const Eigen::VectorXd& towards);

  int Triangle = -1; ///< the triangle where the walk ended
  Eigen::RowVector3d Barycentric;

private:
  bool Look(int point, const Eigen::VectorXd& towards);

  const Eigen::MatrixXi& Triangles;
  const Eigen::MatrixXd& Points;
  const TriangleFans& Fans;
  double Squared = 0.0; ///< the squared distance that remains
};

/// Returns the end of a walk towards each of `positions` (q x d, one per row). points: n x d, one
/// per row. begin: returns the index of the start point for each position; called from any thread.
/// Throws Aborted.
SurfacePoints WalkToPositions(const Eigen::MatrixXd& positions, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& points, const TriangleFans& fans, const std::function<int(int)>& begin,
  const Progress& progress = {});

} // namespace shape
