#include "Correspondence/Functional/Private/FunctionalOperators.h"

#include "Base/Parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shape
{
namespace
{

using Matrices = std::vector<Eigen::MatrixXd>;

/// Gradients of piecewise linear functions, in coordinates of each triangle's plane with the first
/// edge along x.
/// In its own plane, a triangle's corners are (0, 0), (x1, 0), (x2, y2), so that a gradient takes
/// two divisions.
class Gradients
{
public:
  explicit Gradients(const Mesh& mesh)
    : Triangles(mesh.Triangles)
    , Positions(mesh.Triangles.rows(), 3)
    , Areas(mesh.Triangles.rows())
  {
    for (Eigen::Index t = 0; t < this->Positions.rows(); ++t)
    {
      const Eigen::Matrix3d corners = GetCorners(mesh, t);
      const Eigen::RowVector3d side = corners.row(1) - corners.row(0),
                               other = corners.row(2) - corners.row(0);
      const double length = side.norm(), twice = side.cross(other).norm();
      const bool isFlat = twice <= std::numeric_limits<double>::min();
      // A triangle without area has no gradient and contributes to no integral.
      this->Positions.row(t) << (isFlat ? 1.0 : length), (isFlat ? 0.0 : side.dot(other) / length),
        (isFlat ? 1.0 : twice / length);
      this->Areas(t) = isFlat ? 0.0 : 0.5 * twice;
    }
  }

  struct Components
  {
    Eigen::MatrixXd X, Y; ///< m x k
  };
  const Eigen::VectorXd& TriangleAreas() const { return this->Areas; }

  /// The derivatives of positions (n x 3) in the plane of a triangle (3 x 2).
  Eigen::Matrix<double, 3, 2> DerivativeOf(const Eigen::MatrixXd& positions, Eigen::Index t) const
  {
    const Eigen::Vector3d first = positions.row(this->Triangles(t, 0)),
                          one = positions.row(this->Triangles(t, 1)).transpose() - first,
                          two = positions.row(this->Triangles(t, 2)).transpose() - first;
    Eigen::Matrix<double, 3, 2> result;
    result.col(0) = one / this->Positions(t, 0);
    result.col(1) = (two - result.col(0) * this->Positions(t, 1)) / this->Positions(t, 2);
    return result;
  }

  /// functions: n x k, of the points.
  Components Of(const Eigen::MatrixXd& functions) const
  {
    Components gradients{ Eigen::MatrixXd(this->Positions.rows(), functions.cols()), {} };
    gradients.Y.resizeLike(gradients.X);
    for (Eigen::Index k = 0; k < functions.cols(); ++k)
    {
      for (Eigen::Index t = 0; t < this->Positions.rows(); ++t)
      {
        const double first = functions(this->Triangles(t, 0), k);
        const double x = (functions(this->Triangles(t, 1), k) - first) / this->Positions(t, 0);
        gradients.X(t, k) = x;
        gradients.Y(t, k) =
          (functions(this->Triangles(t, 2), k) - first - x * this->Positions(t, 1)) /
          this->Positions(t, 2);
      }
    }
    return gradients;
  }

  /// The functions' integrals over the triangles (m x k).
  Eigen::MatrixXd Integrals(const Eigen::MatrixXd& functions) const
  {
    return this->Areas.asDiagonal() * AverageAtCorners(this->Triangles, functions);
  }

private:
  const Eigen::MatrixXi& Triangles;
  Eigen::MatrixXd Positions; ///< m x 3: x of the second corner, x and y of the third
  Eigen::VectorXd Areas;
};

/// The descriptors that give operators: every stride-th computed one, and every given one.
std::vector<Eigen::Index> OperatorColumns(Eigen::Index computed, Eigen::Index all, int stride)
{
  std::vector<Eigen::Index> chosen;
  for (Eigen::Index i = 0; i < all;
       i += i < computed ? std::min<Eigen::Index>(stride, computed - i) : 1)
  {
    chosen.push_back(i);
  }
  return chosen;
}

/// K of the header: integrals over the curve of products of eigenfunctions, as means over its
/// points.
Eigen::MatrixXd CurveOperator(const Eigen::MatrixXd& functions, const std::vector<int>& points)
{
  const Eigen::MatrixXd values = functions(points, Eigen::all);
  return values.transpose() * values / std::max<double>(1.0, static_cast<double>(points.size()));
}

/// The unit normals at the points (n x 3), weighted by area.
Eigen::MatrixXd PointNormals(const Mesh& mesh)
{
  const Eigen::MatrixXd vectors = ComputeAreaVectors(mesh);
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(mesh.Points.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (const int corner : mesh.Triangles.row(t))
    {
      normals.row(corner) += vectors.row(t);
    }
  }
  normals.rowwise().normalize();
  return normals;
}

/// How the stiffness of a triangle changes if its metric, the identity, becomes F' F: grad f' S
/// grad g, with S the change of sqrt(det(F' F)) (F' F)^-1. A triangle that F collapses has none.
Eigen::Matrix2d StiffnessChange(const Eigen::Matrix<double, 3, 2>& f)
{
  const Eigen::Matrix2d metric = f.transpose() * f;
  const double area = std::sqrt(std::max(0.0, metric.determinant()));
  constexpr double collapsed = 1e-6; // of the triangle's area
  if (area <= collapsed)
  {
    return Eigen::Matrix2d::Zero();
  }
  return area * metric.inverse() - Eigen::Matrix2d::Identity();
}

/// N of the header, in the scalar product of gradients: L^-1/2 (the change of the stiffness)
/// L^-1/2, so that all eigenfunctions count alike. Constant functions are left out.
Eigen::MatrixXd DisplacementOperator(const Mesh& mesh, const Eigen::MatrixXd& vectors,
  const Gradients& gradients, const Gradients::Components& ofFunctions,
  const Eigen::VectorXd& eigenvalues, double distance)
{
  const Eigen::VectorXd& areas = gradients.TriangleAreas();
  Eigen::VectorXd xx(areas.size()), xy(areas.size()), yy(areas.size());
  for (Eigen::Index t = 0; t < areas.size(); ++t)
  {
    const Eigen::Matrix<double, 3, 2> at = gradients.DerivativeOf(mesh.Points, t),
                                      by = gradients.DerivativeOf(vectors, t);
    Eigen::Matrix2d change;
    if (distance > 0.0)
    {
      change = StiffnessChange(at + distance * by) / distance;
    }
    else
    {
      // The metric changes at the rate G, and sqrt(det) inverse at the rate tr(G) / 2 I - G.
      const Eigen::Matrix2d half = at.transpose() * by, rate = half + half.transpose();
      change = 0.5 * rate.trace() * Eigen::Matrix2d::Identity() - rate;
    }
    // A rotation changes no metric, but for rounding.
    constexpr double rounding = 1e-24;
    if (change.squaredNorm() <= rounding * by.squaredNorm())
    {
      change.setZero();
    }
    xx(t) = areas(t) * change(0, 0);
    xy(t) = areas(t) * change(0, 1);
    yy(t) = areas(t) * change(1, 1);
  }
  const Eigen::MatrixXd &x = ofFunctions.X, &y = ofFunctions.Y;
  const Eigen::MatrixXd mixed = x.transpose() * xy.asDiagonal() * y;
  const Eigen::VectorXd roots =
    (eigenvalues.array() > 0.0).select(eigenvalues.array().sqrt().inverse(), 0.0);
  return roots.asDiagonal() *
    (x.transpose() * xx.asDiagonal() * x + mixed + mixed.transpose() +
      y.transpose() * yy.asDiagonal() * y) *
    roots.asDiagonal();
}

} // namespace

// Coefficients are inner products with the mass-orthonormal eigenfunctions: phi' M f.
FunctionalOperators ComputeFunctionalOperators(
  const SurfaceDescriptors& given, const FunctionalMapFitOptions& options, const Progress& progress)
{
  const LaplaceEigenpairs& spectrum = given.Spectrum;
  const Eigen::MatrixXd functions = spectrum.Eigenfunctions.leftCols(options.Size);
  const Eigen::MatrixXd weighted = spectrum.Masses.asDiagonal() * functions;
  Eigen::MatrixXd descriptors = given.Descriptors;
  for (Eigen::Index i = 0; i < descriptors.cols(); ++i)
  {
    const double norm = std::sqrt(spectrum.Masses.dot(descriptors.col(i).cwiseAbs2()));
    descriptors.col(i) /= norm > 0.0 ? norm : 1.0;
  }
  const Eigen::Index computed = descriptors.cols() - given.Given;
  const std::vector<Eigen::Index> chosen =
    OperatorColumns(computed, descriptors.cols(), options.OperatorStride);
  const Gradients gradients(given.Surface);
  const Gradients::Components ofFunctions = gradients.Of(functions);
  const Eigen::MatrixXd integrals = gradients.Integrals(functions);
  const int count = static_cast<int>(chosen.size());
  FunctionalOperators result{ weighted.transpose() * descriptors, Matrices(count), Matrices(count),
    {}, {} };
  if (given.Given > 0 && computed > 0)
  {
    result.Coefficients.rightCols(given.Given) *=
      std::sqrt(static_cast<double>(computed) / static_cast<double>(given.Given));
  }
  ParallelFor(
    count, 1,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const Eigen::VectorXd descriptor = descriptors.col(chosen[i]);
        if (options.DescriptorWeight > 0.0)
        {
          // P of the header: multiplication by the descriptor (Nogneng and Ovsjanikov).
          result.Products[i] = weighted.transpose() * descriptor.asDiagonal() * functions;
        }
        if (options.OrientationWeight > 0.0)
        {
          // n x grad(f) is (-y, x) of grad(f).
          const Gradients::Components own = gradients.Of(descriptor);
          // O of the header: the orientation operator of Ren et al., section 4. The integrand is
          // constant in each triangle except for the test function, which is integrated exactly.
          result.Turns[i] = integrals.transpose() *
            (own.X.col(0).asDiagonal() * ofFunctions.Y - own.Y.col(0).asDiagonal() * ofFunctions.X);
        }
      }
    },
    progress);
  if (options.DisplacementWeight > 0.0)
  {
    result.Displacements.push_back(DisplacementOperator(given.Surface,
      given.Displacements.rows() > 0 ? given.Displacements : PointNormals(given.Surface), gradients,
      ofFunctions, spectrum.Eigenvalues.head(options.Size), options.Displacement));
  }
  if (options.CurveWeight > 0.0)
  {
    for (const std::vector<int>& curve : given.Curves)
    {
      result.Curves.push_back(CurveOperator(functions, curve));
    }
  }
  return result;
}

} // namespace shape
