#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Parameterize/PlanarDistortion.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The singular value decomposition of a matrix with positive determinant: rotations U and V.
struct PlanarDecomposition
{
  Eigen::Matrix2d U, V;
  Eigen::Vector2d Singular; ///< descending, > 0; the matrix is U diag(Singular) V'
};

PlanarDecomposition DecomposePlanar(const Eigen::Matrix2d& matrix);

/**
 * The triangles of a surface, each laid flat by itself, and what is needed to measure maps of them
 * to the plane. Triangles without area count as the thin ones that ComputeTriangleAngles makes of
 * them, those whose corners coincide as 1e-6 of the mean size.
 */
class PlanarElements
{
public:
  /// scale: lengths of the surface are multiplied by it.
  PlanarElements(const Mesh& surface, double scale);

  const Eigen::MatrixXi& Triangles() const { return this->Corners; }
  const Eigen::VectorXd& Areas() const { return this->OwnAreas; } ///< m, > 0

  /// Gradients of the three corners' hat functions in a triangle's own plane, one a row.
  Eigen::Matrix<double, 3, 2> Gradients(Eigen::Index triangle) const;

  /// Jacobian of the map of a triangle to its image; points: n x 2.
  Eigen::Matrix2d Jacobian(Eigen::Index triangle, const Eigen::MatrixXd& points) const;

  /// The mean of a distortion over the surface's area; infinite if a triangle has no positive
  /// area. Throws Aborted.
  double Energy(const Eigen::MatrixXd& points, Distortion distortion, double exponent,
    const Progress& progress = {}) const;

  /// The greatest t up to which points + s steps, 0 <= s < t, flips no triangle (Smith and
  /// Schaefer, "Bijective parameterization with free boundaries", 2015, section 3.2); infinite
  /// if no t does.
  double LargestStep(const Eigen::MatrixXd& points, const Eigen::MatrixXd& steps) const;

private:
  Eigen::MatrixXi Corners;                   ///< m x 3
  Eigen::VectorXd OwnAreas;                  ///< m
  std::vector<Eigen::Matrix2d> InverseEdges; ///< of the edges from corner 0, one a column
};

} // namespace shape
