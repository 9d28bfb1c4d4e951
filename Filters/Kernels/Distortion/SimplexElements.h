#pragma once

#include "Base/Progress.h"
#include "Distortion/Distortion.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The singular value decomposition of a matrix with positive determinant; U and V are rotations.
template <int Dimension>
struct PositiveDecomposition
{
  Eigen::Matrix<double, Dimension, Dimension> U, V;
  /// Descending, > 0; the matrix is U diag(Singular) V'.
  Eigen::Matrix<double, Dimension, 1> Singular;
};

PositiveDecomposition<2> DecomposePositive(const Eigen::Matrix2d& matrix);
PositiveDecomposition<3> DecomposePositive(const Eigen::Matrix3d& matrix);

/// Triangles in the plane or tetrahedra in space (Dimension 2 or 3), each with a reference shape,
/// and the data needed to measure the affine maps from the reference shapes.
template <int Dimension>
class SimplexElements
{
public:
  static constexpr int Corners = Dimension + 1;
  using Square = Eigen::Matrix<double, Dimension, Dimension>;
  using Gradient = Eigen::Matrix<double, Corners, Dimension>;

  /// corners: m x (Dimension + 1). edges: for each simplex, the edges (columns) of its reference
  /// shape from the first corner, with a positive determinant. sizes: m weights > 0.
  SimplexElements(Eigen::MatrixXi corners, const std::vector<Square>& edges, Eigen::VectorXd sizes);

  Eigen::Index Count() const { return this->OwnSizes.size(); }
  const Eigen::MatrixXi& Simplices() const { return this->OwnCorners; }
  const Eigen::VectorXd& Sizes() const { return this->OwnSizes; }

  /// Returns the gradients of the corners' hat functions on the reference shape, one per row.
  Gradient HatGradients(Eigen::Index simplex) const;

  /// Returns the Jacobian of the map from the reference shape to the image; points: n x Dimension.
  Square Jacobian(Eigen::Index simplex, const Eigen::MatrixXd& points) const;

  /// Returns the mean of a distortion, weighted by the sizes. It is infinite if the image of a
  /// simplex is inverted or has no size (exact predicates). Throws Aborted.
  double Energy(const Eigen::MatrixXd& points, Distortion distortion, double exponent,
    const Progress& progress = {}) const;

  /// Returns the largest t such that the positions points + s * steps have no inverted simplex for
  /// 0 <= s < t, up to rounding, or infinity if there is no limit (Smith and Schaefer, "Bijective
  /// parameterization with free boundaries", 2015, section 3.2).
  double LargestStep(const Eigen::MatrixXd& points, const Eigen::MatrixXd& steps) const;

private:
  Eigen::MatrixXi OwnCorners;
  Eigen::VectorXd OwnSizes;
  std::vector<Square> InverseEdges; ///< of the reference shapes
};

/// Returns the triangles of a surface, each laid out in a plane of its own and weighted by its
/// area. A degenerate triangle gets the angles that ComputeTriangleAngles assigns to it, and an
/// area of at least 1e-12 of the mean area. scale: factor by which the surface's lengths are
/// multiplied.
SimplexElements<2> BuildTriangleElements(const Mesh& surface, double scale);

/// Returns the smallest t > 0 with a + b t + c t^2 + d t^3 = 0 for a > 0, or infinity if there is
/// none.
double FindFirstRoot(double a, double b, double c, double d);

} // namespace shape
