#pragma once

#include "Mesh/Mesh.h"
#include "Search/TriangleWalk.h"

#include <Eigen/Core>

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

} // namespace shape
