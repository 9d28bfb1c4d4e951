#pragma once

#include "Mesh/Mesh.h"
#include "Search/TriangleWalk.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/**
 * Rotates a deformed feature about its loop, point by point, until it has given normals there. It
 * removes the angles that equation 12 (OptimizeBoundaryNormals) leaves, since the frames of
 * neighbouring samples are blended and a feature is rough at its boundary.
 *
 * A point next to the loop is rotated about the loop's tangents at its neighbours q_j on the loop,
 * each time by its angle above or below the tangent plane at q_j, and goes to the mean of the
 * results (weights 1 / |p - q_j|^2). Other points within a width are rotated likewise about the
 * nearest points of the loop, by the mean angle there times (1 - x^2)^3 at x times the width.
 */
class SeamNormals
{
public:
  /// feature: any triangles, undeformed; fans: of its triangles; loop: points of it in order, the
  /// feature to the left. distances: of its points from the loop; width: in the same unit.
  SeamNormals(const Mesh& feature, const TriangleFans& fans, const std::vector<int>& loop,
    const Eigen::VectorXd& distances, double width);

  /// points: of the feature, deformed. normals: n x 3, unit, at the loop. share: of the angles,
  /// 0 to 1. Points of the loop stay.
  void Apply(Eigen::MatrixXd& points, const Eigen::MatrixXd& normals, double share) const;

private:
  /// A point and the samples that it rotates about.
  struct Turned
  {
    int Point;
    double Fade;              ///< the factor of the angles here
    std::vector<int> Samples; ///< indices in the loop
    std::vector<double> Weights;
  };

  std::vector<int> Loop;
  std::vector<Turned> Ring;   ///< next to the loop; Weights are computed each time
  std::vector<Turned> Beyond; ///< the others within the width
};

/// The triangles that join a loop to the ring around it.
struct SeamBand
{
  /// t x 3, counter-clockwise: indices of the loop's points, then of the ring's, then of Midpoints.
  /// A point of the ring that lies on one of the loop's has the index of that one.
  Eigen::MatrixXi Triangles;
  Eigen::VectorXi RingPoints; ///< of each point of the ring: its index, or that of the loop's
  /// The midpoints of edges of the band between two points of the ring: such an edge could also be
  /// one of the surface around it, and is split.
  std::vector<std::array<int, 2>> Midpoints;
};

/**
 * Joins a loop to the ring around it by the constrained Delaunay triangulation of the band between
 * them in the plane. They may have points and edges in common.
 *
 * Edges may join two points of the loop: the surface inside must not have them (FindLoopChords).
 *
 * loop: n x 2, a simple polygon of either orientation. ring: m x 2, another, counter-clockwise,
 * around the loop. Throws InvalidInput if they cross.
 */
SeamBand TriangulateSeamBand(const Eigen::MatrixXd& loop, const Eigen::MatrixXd& ring);

/**
 * Point data of a feature that agree with the target's at their loop: the difference there is
 * interpolated into the feature by inverse squared distances (equation 4 with k = 2) and fades out
 * with the distance from the loop by (1 - x^2)^3.
 *
 * values: m x d, at the feature's points (m x 3). differences: n x d, the target's values minus the
 * feature's at its loop (n x 3). distances: m, of the feature's points from the loop; width: the
 * distance beyond which nothing changes, in the same unit; 0 changes nothing. At points of the
 * feature on the loop the result is exactly the target's value.
 */
Eigen::MatrixXd BlendAtSeam(Eigen::MatrixXd values, const Eigen::MatrixXd& points,
  const Eigen::MatrixXd& differences, const Eigen::MatrixXd& loop, const Eigen::VectorXd& distances,
  double width);

} // namespace shape
