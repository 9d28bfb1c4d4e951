#include "Correspondence/FunctionalMapFit.h"

#include "Core/Parallel.h"

#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <vector>

namespace shape
{
namespace
{

using Matrices = std::vector<Eigen::MatrixXd>;

/// Of one surface, in its first eigenfunctions.
struct Operators
{
  Eigen::MatrixXd Coefficients; ///< k x q
  Matrices Products, Turns;     ///< q each, k x k
};

/// The vector field n x grad(f) of a function linear in each triangle (m x 3), times twice its
/// area.
Eigen::MatrixXd TurnedGradients(const Mesh& mesh, const Eigen::VectorXd& function)
{
  Eigen::MatrixXd turned(mesh.Triangles.rows(), 3);
  for (Eigen::Index t = 0; t < turned.rows(); ++t)
  {
    const Eigen::Matrix3d corners = Corners(mesh, t);
    const auto points = mesh.Triangles.row(t);
    turned.row(t) = function(points(0)) * (corners.row(1) - corners.row(2)) +
      function(points(1)) * (corners.row(2) - corners.row(0)) +
      function(points(2)) * (corners.row(0) - corners.row(1));
  }
  return turned;
}

/// The integrals of eigenfunction i times the derivative of eigenfunction j along n x grad(f).
Eigen::MatrixXd Turn(const Mesh& mesh, const Eigen::MatrixXd& functions, const Eigen::VectorXd& f)
{
  // <n x grad f, grad g> is a third of what each corner gets; with w the edge opposite corner c,
  // turned, grad g = sum g_c (n x w_c) / 2A, and <n x grad f, n x w_c> = <grad f, w_c>, whose
  // integral needs differences of f alone.
  const Eigen::MatrixXd along = TurnedGradients(mesh, f);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(mesh.Points.rows(), functions.cols());
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = Corners(mesh, t);
    const Eigen::RowVector3d normal =
      (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0));
    const double area = normal.norm(); // twice
    if (area <= std::numeric_limits<double>::min())
    {
      continue;
    }
    const auto points = mesh.Triangles.row(t);
    Eigen::RowVectorXd derivative = Eigen::RowVectorXd::Zero(functions.cols());
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::RowVector3d edge = corners.row((k + 2) % 3) - corners.row((k + 1) % 3);
      derivative += normal.cross(edge).dot(along.row(t)) / (area * area) * functions.row(points(k));
    }
    for (int k = 0; k < 3; ++k)
    {
      result.row(points(k)) += derivative / 6.0;
    }
  }
  return functions.transpose() * result;
}

Operators OperatorsOf(
  const DescribedSurface& given, const FunctionalMapFitOptions& options, const Progress& progress)
{
  const LaplaceSpectrum& spectrum = given.Spectrum;
  const Eigen::MatrixXd functions = spectrum.Eigenfunctions.leftCols(options.Size);
  const Eigen::MatrixXd weighted = spectrum.Masses.asDiagonal() * functions;
  Eigen::MatrixXd descriptors = given.Descriptors;
  for (Eigen::Index i = 0; i < descriptors.cols(); ++i)
  {
    const double norm = std::sqrt(spectrum.Masses.dot(descriptors.col(i).cwiseAbs2()));
    descriptors.col(i) /= norm > 0.0 ? norm : 1.0;
  }
  const int count = static_cast<int>(descriptors.cols());
  Operators result{ weighted.transpose() * descriptors, Matrices(count), Matrices(count) };
  ParallelFor(
    count, 1,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        if (options.DescriptorWeight > 0.0)
        {
          result.Products[i] = weighted.transpose() * descriptors.col(i).asDiagonal() * functions;
        }
        if (options.OrientationWeight > 0.0)
        {
          result.Turns[i] = Turn(given.Surface, functions, descriptors.col(i));
        }
      }
    },
    progress);
  return result;
}

/// w (|C X - Y C|^2 summed over pairs of operators), and half its gradient.
class Commutators
{
public:
  /// Divided by the number of operators and the mean of their squared norms.
  Commutators(const Matrices& x, const Matrices& y, double weight, Eigen::Index size)
    : X(x)
    , Y(y)
    , Right(Eigen::MatrixXd::Zero(size, size))
    , Left(Eigen::MatrixXd::Zero(size, size))
  {
    if (weight <= 0.0)
    {
      return;
    }
    double norms = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
      this->Right += x[i] * x[i].transpose();
      this->Left += y[i].transpose() * y[i];
      norms += 0.5 * (x[i].squaredNorm() + y[i].squaredNorm()) / static_cast<double>(size);
    }
    this->Weight = norms > 0.0 ? weight / norms : 0.0;
  }

  void AddGradient(const Eigen::MatrixXd& c, Eigen::MatrixXd& gradient) const
  {
    if (this->Weight <= 0.0)
    {
      return;
    }
    Eigen::MatrixXd own = c * this->Right + this->Left * c;
    for (std::size_t i = 0; i < this->X.size(); ++i)
    {
      own.noalias() -= this->Y[i] * (c * this->X[i].transpose());
      own.noalias() -= this->Y[i].transpose() * (c * this->X[i]);
    }
    gradient += this->Weight * own;
  }

private:
  const Matrices& X;
  const Matrices& Y;
  Eigen::MatrixXd Right, Left;
  double Weight = 0.0;
};

} // namespace

Eigen::MatrixXd FitFunctionalMap(const DescribedSurface& a, const DescribedSurface& b,
  const FunctionalMapFitOptions& options, const Progress& progress)
{
  const Operators ofA = OperatorsOf(a, options, progress.Part(0.0, 0.2));
  const Operators ofB = OperatorsOf(b, options, progress.Part(0.2, 0.4));
  const int size = options.Size;
  const double count = std::max<double>(1.0, static_cast<double>(ofA.Coefficients.cols()));
  const Eigen::MatrixXd squares = ofA.Coefficients * ofA.Coefficients.transpose() / count;
  const Eigen::MatrixXd wanted = ofB.Coefficients * ofA.Coefficients.transpose() / count;
  const Eigen::VectorXd valuesA = a.Spectrum.Eigenvalues.head(size),
                        valuesB = b.Spectrum.Eigenvalues.head(size);
  const double largest = std::max(valuesA.maxCoeff(), valuesB.maxCoeff());
  const Eigen::MatrixXd gaps = options.LaplacianWeight / (largest * largest) *
    (valuesA.transpose().replicate(size, 1) - valuesB.replicate(1, size)).cwiseAbs2();
  const Commutators products(ofA.Products, ofB.Products, options.DescriptorWeight, size),
    turns(ofA.Turns, ofB.Turns, options.OrientationWeight, size);
  const auto apply = [&](const Eigen::MatrixXd& c)
  {
    Eigen::MatrixXd result = c * squares + gaps.cwiseProduct(c);
    products.AddGradient(c, result);
    turns.AddGradient(c, result);
    return result;
  };

  const BlasThreads one(false);
  constexpr int most = 200;
  constexpr double least = 1e-6; // of the right-hand side
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(size, size), residual = wanted, direction = residual;
  double squared = residual.squaredNorm();
  const double enough = least * least * squared;
  for (int k = 0; k < most && squared > enough; ++k)
  {
    progress(0.4 + 0.6 * k / most);
    const Eigen::MatrixXd image = apply(direction);
    const double step = squared / direction.cwiseProduct(image).sum();
    map += step * direction;
    residual -= step * image;
    const double next = residual.squaredNorm();
    direction = residual + next / squared * direction;
    squared = next;
  }
  progress(1.0);
  return map;
}

} // namespace shape
