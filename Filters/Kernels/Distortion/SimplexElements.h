#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Parameterize/PlanarDistortion.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The singular value decomposition of a 2 x 2 matrix with positive determinant; U and V are
/// rotations.
struct PlanarDecomposition
{
  Eigen::Matrix2d U, V;
  Eigen::Vector2d Singular; ///< descending, > 0; the matrix is U diag(Singular) V'
};

PlanarDecomposition DecomposePlanar(const Eigen::Matrix2d& matrix);

/**
 * The triangles of a surface, each laid out in a plane of its own, with the data needed to measure
 * maps from them to the plane. A degenerate triangle gets the angles that ComputeTriangleAngles
 * assigns to it, and an area of at least 1e-12 of the mean area.
 */
class PlanarElements
{
public:
  /// scale: factor by which the surface's lengths are multiplied.
  PlanarElements(const Mesh& surface, double scale);

  const Eigen::MatrixXi& Triangles() const { return this->Corners; }
  const Eigen::VectorXd& Areas() const { return this->OwnAreas; } ///< m values > 0

  /// Returns the gradients of the three corners' hat functions in the triangle's plane, one per
  /// row.
  Eigen::Matrix<double, 3, 2> Gradients(Eigen::Index triangle) const;

  /// Returns the Jacobian of the map from a triangle to its image; points: n x 2.
  Eigen::Matrix2d Jacobian(Eigen::Index triangle, const Eigen::MatrixXd& points) const;

  /// Returns the area-weighted mean of a distortion. The mean is infinite if the image of a
  /// triangle is clockwise or has no area. Throws Aborted.
  double Energy(const Eigen::MatrixXd& points, Distortion distortion, double exponent,
    const Progress& progress = {}) const;

  /// Returns the largest t such that the positions points + s * steps have no flipped triangle for
  /// 0 <= s < t, or infinity if there is no limit (Smith and Schaefer, "Bijective parameterization
  /// with free boundaries", 2015, section 3.2).
  double LargestStep(const Eigen::MatrixXd& points, const Eigen::MatrixXd& steps) const;

private:
  Eigen::MatrixXi Corners;  ///< m x 3
  Eigen::VectorXd OwnAreas; ///< m
  /// for each triangle, the inverse of the matrix whose columns are the edges from corner 0
  std::vector<Eigen::Matrix2d> InverseEdges;
};

} // namespace shape
