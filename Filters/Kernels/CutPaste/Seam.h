#pragma once

#include "Mesh/Mesh.h"
#include "Search/TriangleWalk.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/**
 * Rotates the points of a deformed feature about its loops until the feature has the wanted normals
 * there. This removes the angles that equation 12 (OptimizeBoundaryNormals) leaves. Such angles
 * remain because the frames of neighbouring samples are blended and the feature is rough at its
 * boundary.
 *
 * A point next to the loop is rotated about the loop's tangent at each of its neighbours q_j on the
 * loop. The angle of rotation is the angle between the point, seen from q_j, and the wanted tangent
 * plane there. The point's new position is the mean of the results (weights 1 / |p - q_j|^2). Other
 * points within `width` are rotated about the nearest points of the loop in the same way. Their
 * angle is the mean angle there times (1 - x^2)^3, where x is the distance divided by the width.
 */
class SeamNormals
{
public:
  /// feature: the undeformed feature, any triangles. fans: built from these triangles. loops:
  /// points of the feature in order, with the feature to the left. distances: for each point of the
  /// feature, its distance from the loops. width: a distance in the same unit.
  SeamNormals(const Mesh& feature, const TriangleFans& fans,
    const std::vector<std::vector<int>>& loops, const Eigen::VectorXd& distances, double width);

  /// Rotates the points of the deformed feature. normals: n x 3, the wanted unit normals at the
  /// points of all loops. share: the factor of all angles, 0 to 1. Points of the loop stay.
  void Apply(Eigen::MatrixXd& points, const Eigen::MatrixXd& normals, double share) const;

private:
  /// A point, and the samples about which it is rotated.
  struct Turned
  {
    int Point;
    double Fade;              ///< the factor by which the angles are reduced at this point
    std::vector<int> Samples; ///< indices of points of all loops
    std::vector<double> Weights;
  };

  std::vector<std::vector<int>> Loops;
  std::vector<Turned> Ring;   ///< points next to the loop; Weights are computed each time
  std::vector<Turned> Beyond; ///< other points within the width
};

/// The triangles that join a loop to the ring around it.
struct SeamBand
{
  /// t x 3, counter-clockwise. Indices count the loop's points first, then the ring's, then
  /// Midpoints. A point of the ring that coincides with a point of the loop has the latter's index.
  Eigen::MatrixXi Triangles;
  /// The index of each point of the ring in Triangles, which may be that of a point of the loop.
  Eigen::VectorXi RingPoints;
  /// The end points of the split edges, one pair for each midpoint. An edge of the band between two
  /// points of the ring is split, since the surface around the ring could contain the same edge.
  std::vector<std::array<int, 2>> Midpoints;
};

/**
 * Joins a loop to the ring around it by the constrained Delaunay triangulation of the band between
 * them in the plane. Loop and ring may have points and edges in common.
 *
 * Edges of the band may join two points of the loop, so the surface inside the loop must not
 * contain them (FindLoopChords).
 *
 * loop: n x 2, a simple polygon of either orientation. ring: m x 2, a counter-clockwise simple
 * polygon around the loop. Throws InvalidInput if they cross.
 */
SeamBand TriangulateSeamBand(const Eigen::MatrixXd& loop, const Eigen::MatrixXd& ring);

/**
 * Changes point data of a feature to agree with the target's data at the loop. The difference at
 * the loop is interpolated into the feature by inverse squared distances (equation 4 with k = 2).
 * It fades out as (1 - x^2)^3, where x is the distance from the loop divided by `width`.
 *
 * values: m x d, at the feature's points (m x 3). differences: n x d, the target's values minus the
 * feature's, at the loop (n x 3). distances: m values, the distances of the feature's points from
 * the loop. width: the distance beyond which nothing changes, in the same unit; if it is 0, nothing
 * changes. At points of the feature on the loop, the result is exactly the target's value.
 */
Eigen::MatrixXd BlendAtSeam(Eigen::MatrixXd values, const Eigen::MatrixXd& points,
  const Eigen::MatrixXd& differences, const Eigen::MatrixXd& loop, const Eigen::VectorXd& distances,
  double width);

} // namespace shape
