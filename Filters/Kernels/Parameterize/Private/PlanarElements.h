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
 * The triangles of a surface, each flattened separately, and what is needed to measure maps of them
 * to the plane. A triangle without area is replaced by the thin one that ComputeTriangleAngles
 * defines. If all corners coincide, its size is 1e-6 of the mean.
 */
class PlanarElements
{
public:
  /// scale: factor for the lengths of the surface.
  PlanarElements(const Mesh& surface, double scale);

  const Eigen::MatrixXi& Triangles() const { return this->Corners; }
  const Eigen::VectorXd& Areas() const { return this->OwnAreas; } ///< m, > 0

  /// Returns the gradients of the three corners' hat functions in the triangle's plane, one per
  /// row.
  Eigen::Matrix<double, 3, 2> Gradients(Eigen::Index triangle) const;

  /// Returns the Jacobian of the map from a triangle to its image; points: n x 2.
  Eigen::Matrix2d Jacobian(Eigen::Index triangle, const Eigen::MatrixXd& points) const;

  /// Returns the mean of a distortion over the surface's area; infinite if the image of a triangle
  /// has no positive area. Throws Aborted.
  double Energy(const Eigen::MatrixXd& points, Distortion distortion, double exponent,
    const Progress& progress = {}) const;

  /// Returns the largest t such that points + s steps flips no triangle for 0 <= s < t; infinite if
  /// there is no limit (Smith and Schaefer, "Bijective parameterization with free boundaries",
  /// 2015, section 3.2).
  double LargestStep(const Eigen::MatrixXd& points, const Eigen::MatrixXd& steps) const;

private:
  Eigen::MatrixXi Corners;  ///< m x 3
  Eigen::VectorXd OwnAreas; ///< m
  /// inverses of the matrices with the edges from corner 0 as columns
  std::vector<Eigen::Matrix2d> InverseEdges;
};

} // namespace shape
