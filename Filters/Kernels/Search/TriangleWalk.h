#pragma once

#include "Base/Progress.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

/// The triangles around each point: those of point i from First[i] to First[i + 1].
struct TriangleFans
{
  TriangleFans(const Eigen::MatrixXi& triangles, Eigen::Index points);

  std::vector<int> First, Triangles;
};

/// Goes on a surface between points of any dimension towards a place near to it: from triangle to
/// triangle that share a corner while they lead nearer.
class TriangleWalk
{
public:
  /// triangles: m x 3; points: d x n, one a column; all are kept by reference.
  TriangleWalk(
    const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points, const TriangleFans& fans)
    : Triangles(triangles)
    , Points(points)
    , Fans(fans)
  {
  }

  /// From the triangles around a point that has some, to where none around leads nearer.
  void Go(int point, const Eigen::VectorXd& towards);

  int Triangle = -1; ///< where it ended
  Eigen::RowVector3d Barycentric;

private:
  bool Look(int point, const Eigen::VectorXd& towards);

  const Eigen::MatrixXi& Triangles;
  const Eigen::MatrixXd& Points;
  const TriangleFans& Fans;
  double Squared = 0.0;               ///< the distance that is left
  Eigen::VectorXd First, Second, Way; ///< kept to spare allocations
};

/// Where walks to places (q x d, one a row) end on the surface of points (n x d, one a row). begin:
/// of each place the point to walk from, asked for from any thread. Throws Aborted.
SurfacePoints WalkToPositions(const Eigen::MatrixXd& positions, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& points, const TriangleFans& fans, const std::function<int(int)>& begin,
  const Progress& progress = {});

} // namespace shape
