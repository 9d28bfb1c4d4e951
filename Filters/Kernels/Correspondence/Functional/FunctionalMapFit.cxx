#include "Correspondence/Functional/FunctionalMapFit.h"

#include "Base/Parallel.h"

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

/// Each triangle laid in its plane, with the first side along x: what makes gradients of functions
/// that are linear in it.
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
      // A triangle without area has no gradient and no share of any integral.
      this->Positions.row(t) << (isFlat ? 1.0 : length), (isFlat ? 0.0 : side.dot(other) / length),
        (isFlat ? 1.0 : twice / length);
      this->Areas(t) = isFlat ? 0.0 : 0.5 * twice;
    }
  }

  struct Components
  {
    Eigen::MatrixXd X, Y; ///< m x k
  };

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

Operators OperatorsOf(
  const SurfaceDescriptors& given, const FunctionalMapFitOptions& options, const Progress& progress)
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
  const Gradients gradients(given.Surface);
  const Gradients::Components ofFunctions = gradients.Of(functions);
  const Eigen::MatrixXd integrals = gradients.Integrals(functions);
  const int stride = options.OperatorStride;
  const int count = (static_cast<int>(descriptors.cols()) + stride - 1) / stride;
  Operators result{ weighted.transpose() * descriptors, Matrices(count), Matrices(count) };
  ParallelFor(
    count, 1,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const Eigen::VectorXd descriptor = descriptors.col(static_cast<Eigen::Index>(i) * stride);
        if (options.DescriptorWeight > 0.0)
        {
          result.Products[i] = weighted.transpose() * descriptor.asDiagonal() * functions;
        }
        if (options.OrientationWeight > 0.0)
        {
          // n x grad(f) is (-y, x) of grad(f).
          const Gradients::Components own = gradients.Of(descriptor);
          result.Turns[i] = integrals.transpose() *
            (own.X.col(0).asDiagonal() * ofFunctions.Y - own.Y.col(0).asDiagonal() * ofFunctions.X);
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

Eigen::MatrixXd FitFunctionalMap(const SurfaceDescriptors& a, const SurfaceDescriptors& b,
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
  constexpr int maximum = 200;
  constexpr double minimum = 1e-6; // of the right-hand side
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(size, size), residual = wanted, direction = residual;
  double squared = residual.squaredNorm();
  const double enough = minimum * minimum * squared;
  for (int k = 0; k < maximum && squared > enough; ++k)
  {
    progress(0.4 + 0.6 * k / maximum);
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
