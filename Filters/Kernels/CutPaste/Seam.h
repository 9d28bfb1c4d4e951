#pragma once

#include "Mesh/Mesh.h"
#include "Search/TriangleWalk.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/**
 * Turns a deformed feature about its loop, point by point, until it leaves the loop by given
 * normals: what is left where equation 12 (OptimizeBoundaryNormals) has done its best, since the
 * frames of neighbouring samples blend and a feature is rough at its rim.
 *
 * A point next to the loop turns about the loop's tangents at its neighbours q_j there, each time
 * by the angle by which it stands above or below the tangent plane at q_j, and goes to the mean
 * (weights 1 / |p - q_j|^2). Others, no farther than a width, turn likewise about the nearest
 * points of the loop, by the mean angle there times (1 - x^2)^3 at distance x of the width.
 */
class SeamNormals
{
public:
  /// feature: any triangles, undeformed; fans: its; loop: points of it in their order, the feature
  /// to the left. distances: of its points from the loop; width: in their unit.
  SeamNormals(const Mesh& feature, const TriangleFans& fans, const std::vector<int>& loop,
    const Eigen::VectorXd& distances, double width);

  /// points: of the feature, deformed. normals: n x 3, unit, at the loop. share: of the angles,
  /// 0 to 1. Points of the loop stay.
  void Apply(Eigen::MatrixXd& points, const Eigen::MatrixXd& normals, double share) const;

private:
  /// A point and what it turns about.
  struct Turned
  {
    int Point;
    double Fade;              ///< share of the angles that is left here
    std::vector<int> Samples; ///< places in the loop
    std::vector<double> Weights;
  };

  std::vector<int> Loop;
  std::vector<Turned> Ring;   ///< next to the loop; Weights are made anew each time
  std::vector<Turned> Beyond; ///< the others within the width
};

/// The triangles that join a loop to the ring around it.
struct SeamBand
{
  /// t x 3, counter-clockwise: the loop's points count from 0, the ring's after them, then
  /// Midpoints. Where a point of the ring lies on one of the loop's it counts as that one.
  Eigen::MatrixXi Triangles;
  Eigen::VectorXi RingPoints; ///< of each point of the ring: its number there, or the loop's
  /// Points in the middle between two others: an edge of the band that joins two points of the ring
  /// could be one of the surface around it, too, and is cut in two.
  std::vector<std::array<int, 2>> Midpoints;
};

/**
 * Joins a loop to the ring around it by the constrained Delaunay triangulation of what is between
 * them in the plane. They may have points and sides in common.
 *
 * Edges may join two points of the loop: what is within must not have them (FindLoopChords).
 *
 * loop: n x 2, a polygon that does not cross itself, in either sense. ring: m x 2, another,
 * counter-clockwise, the loop within. Throws InvalidInput where they cross.
 */
SeamBand TriangulateSeamBand(const Eigen::MatrixXd& loop, const Eigen::MatrixXd& ring);

/**
 * Point data of a feature that meet what the target has at their loop: the difference there, spread
 * into the feature by inverse squared distances (equation 4 with k = 2) and fading out with the
 * distance from the loop by (1 - x^2)^3.
 *
 * values: m x d, at the feature's points (m x 3). differences: n x d, what the target has less what
 * the feature has, at its loop (n x 3). distances: m, of the feature's points from the loop; width:
 * where nothing is left of it, in their unit; 0 changes nothing. At the loop the result is the
 * target's value exactly, where its points are among the feature's.
 */
Eigen::MatrixXd BlendAtSeam(Eigen::MatrixXd values, const Eigen::MatrixXd& points,
  const Eigen::MatrixXd& differences, const Eigen::MatrixXd& loop, const Eigen::VectorXd& distances,
  double width);

} // namespace shape
