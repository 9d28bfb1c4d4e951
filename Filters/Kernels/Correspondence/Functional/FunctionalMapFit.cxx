#include "Correspondence/Functional/FunctionalMapFit.h"

#include "Base/Parallel.h"
#include "Correspondence/Functional/Private/FunctionalOperators.h"

#include <algorithm>
#include <vector>

namespace shape
{

namespace
{

using Matrices = std::vector<Eigen::MatrixXd>;

/// w (|C X - Y C|^2 summed over pairs of operators), and half its gradient.
/// The sum is |C X_i - Y_i C|^2; half its gradient is C (sum X X') + (sum Y' Y) C minus the two
/// mixed terms. The first two sums do not depend on C and are computed once.
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

/// Half the squared commutators of each entry: |C L1 - L2 C|^2 is diagonal in the entries of C, and
/// entry (i, j) has the weight (l1_j - l2_i)^2.
Eigen::MatrixXd Gaps(const Eigen::VectorXd& valuesA, const Eigen::VectorXd& valuesB,
  const FunctionalMapFitOptions& options)
{
  const double largest = std::max(valuesA.maxCoeff(), valuesB.maxCoeff());
  const Eigen::Index size = valuesA.size();
  if (options.Mask == FunctionalMapFitOptions::MaskType::Laplacian)
  {
    return options.LaplacianWeight / (largest * largest) *
      (valuesA.transpose().replicate(size, 1) - valuesB.replicate(1, size)).cwiseAbs2();
  }
  const auto parts = [&](const Eigen::VectorXd& values)
  {
    const Eigen::ArrayXd scaled = values.array() / largest;
    Eigen::MatrixXd both(values.size(), 2);
    both << scaled.sqrt() / (scaled + 1.0), (scaled + 1.0).inverse();
    return both;
  };
  const Eigen::MatrixXd ofA = parts(valuesA), ofB = parts(valuesB);
  Eigen::MatrixXd gaps = Eigen::MatrixXd::Zero(size, size);
  for (const int part : { 0, 1 })
  {
    gaps +=
      (ofA.col(part).transpose().replicate(size, 1) - ofB.col(part).replicate(1, size)).cwiseAbs2();
  }
  return options.LaplacianWeight * gaps;
}

/// The energy E of the header, of one direction: quadratic in C.
class QuadraticEnergy
{
public:
  QuadraticEnergy(const FunctionalOperators& ofA, const FunctionalOperators& ofB,
    const Eigen::VectorXd& valuesA, const Eigen::VectorXd& valuesB,
    const FunctionalMapFitOptions& options)
    : Gap(Gaps(valuesA, valuesB, options))
    , Products(ofA.Products, ofB.Products, options.DescriptorWeight, options.Size)
    , Turns(ofA.Turns, ofB.Turns, options.OrientationWeight, options.Size)
    , Displacements(ofA.Displacements, ofB.Displacements, options.DisplacementWeight, options.Size)
    , Curves(ofA.Curves, ofB.Curves, options.CurveWeight, options.Size)
  {
    const double count = std::max<double>(1.0, static_cast<double>(ofA.Coefficients.cols()));
    this->Squares = ofA.Coefficients * ofA.Coefficients.transpose() / count;
    this->Wanted = ofB.Coefficients * ofA.Coefficients.transpose() / count;
    this->Constant = ofB.Coefficients.squaredNorm() / count;
  }

  /// Half the gradient is Apply(C) minus Wanted.
  Eigen::MatrixXd Apply(const Eigen::MatrixXd& c) const
  {
    Eigen::MatrixXd result = c * this->Squares + this->Gap.cwiseProduct(c);
    this->Products.AddGradient(c, result);
    this->Turns.AddGradient(c, result);
    this->Displacements.AddGradient(c, result);
    this->Curves.AddGradient(c, result);
    return result;
  }

  /// The minimum: Apply(C) = Wanted is a symmetric, positive semidefinite linear system, which is
  /// solved by conjugate gradients on matrices.
  Eigen::MatrixXd Minimize(const Progress& progress) const
  {
    // The limit and the tolerance suffice, since the refinement improves the map anyway.
    constexpr int maximum = 200;
    constexpr double minimum = 1e-6; // of the right-hand side
    Eigen::MatrixXd map = Eigen::MatrixXd::Zero(this->Wanted.rows(), this->Wanted.cols()),
                    residual = this->Wanted, direction = residual;
    double squared = residual.squaredNorm();
    const double enough = minimum * minimum * squared;
    for (int k = 0; k < maximum && squared > enough; ++k)
    {
      progress(static_cast<double>(k) / maximum);
      const Eigen::MatrixXd image = this->Apply(direction);
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

  Eigen::MatrixXd Wanted;
  double Constant = 0.0;

private:
  Eigen::MatrixXd Squares, Gap;
  Commutators Products, Turns, Displacements, Curves;
};

double Dot(const Eigen::MatrixXd& x, const Eigen::MatrixXd& y)
{
  return x.cwiseProduct(y).sum();
}

double Dot(const FunctionalMaps& x, const FunctionalMaps& y)
{
  return Dot(x.AToB, y.AToB) + Dot(x.BToA, y.BToA);
}

FunctionalMaps Sum(const FunctionalMaps& x, double factor, const FunctionalMaps& y)
{
  return { x.AToB + factor * y.AToB, x.BToA + factor * y.BToA };
}

/// The first t > 0 at which a polynomial that falls at 0 and grows far away is smallest locally.
double FirstMinimum(const std::array<double, 5>& p)
{
  const auto slope = [&](double t)
  { return p[1] + t * (2.0 * p[2] + t * (3.0 * p[3] + t * 4.0 * p[4])); };
  double low = 0.0, high = 1.0;
  constexpr int most = 200; // doublings, and halvings, which exhaust double precision
  for (int k = 0; k < most && slope(high) < 0.0; ++k)
  {
    high *= 2.0;
  }
  for (int k = 0; k < most && low < high; ++k)
  {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high)
    {
      break;
    }
    (slope(middle) < 0.0 ? low : high) = middle;
  }
  return low;
}

} // namespace

Eigen::MatrixXd FitFunctionalMap(const SurfaceDescriptors& a, const SurfaceDescriptors& b,
  const FunctionalMapFitOptions& options, const Progress& progress)
{
  // The matrices are small (30 x 30 by default): starting threads would take longer than a product.
  const BlasThreads one(false);
  const FunctionalOperators ofA = ComputeFunctionalOperators(a, options, progress.Part(0.0, 0.2));
  const FunctionalOperators ofB = ComputeFunctionalOperators(b, options, progress.Part(0.2, 0.4));
  return QuadraticEnergy(ofA, ofB, a.Spectrum.Eigenvalues.head(options.Size),
    b.Spectrum.Eigenvalues.head(options.Size), options)
    .Minimize(progress.Part(0.4, 1.0));
}

struct FunctionalMapEnergy::Terms
{
  FunctionalOperators OfA, OfB; // before the energies, which refer to them
  QuadraticEnergy Forth, Back;
  double Orthonormality, Inverse; ///< weights, divided by the size

  Terms(const SurfaceDescriptors& a, const SurfaceDescriptors& b,
    const FunctionalMapFitOptions& options, const Progress& progress)
    : OfA(ComputeFunctionalOperators(a, options, progress.Part(0.0, 0.5)))
    , OfB(ComputeFunctionalOperators(b, options, progress.Part(0.5, 1.0)))
    , Forth(this->OfA, this->OfB, a.Spectrum.Eigenvalues.head(options.Size),
        b.Spectrum.Eigenvalues.head(options.Size), options)
    , Back(this->OfB, this->OfA, b.Spectrum.Eigenvalues.head(options.Size),
        a.Spectrum.Eigenvalues.head(options.Size), options)
    , Orthonormality(options.OrthonormalityWeight / options.Size)
    , Inverse(options.InverseWeight / options.Size)
  {
  }
};

FunctionalMapEnergy::FunctionalMapEnergy(const SurfaceDescriptors& a, const SurfaceDescriptors& b,
  const FunctionalMapFitOptions& options, const Progress& progress)
  : Both(std::make_unique<Terms>(a, b, options, progress))
{
}

FunctionalMapEnergy::~FunctionalMapEnergy() = default;

double FunctionalMapEnergy::Value(const FunctionalMaps& maps) const
{
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(maps.AToB.rows(), maps.AToB.cols());
  return this->Along(maps, { zero, zero })[0];
}

// |C' C - I|^2 has the gradient 4 C (C' C - I); |C D - I|^2 has 2 (C D - I) D' for C and
// 2 C' (C D - I) for D.
FunctionalMaps FunctionalMapEnergy::Gradient(const FunctionalMaps& maps) const
{
  const Terms& terms = *this->Both;
  const Eigen::MatrixXd &c = maps.AToB, &d = maps.BToA;
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(c.rows(), c.cols());
  FunctionalMaps gradient{ 2.0 * (terms.Forth.Apply(c) - terms.Forth.Wanted),
    2.0 * (terms.Back.Apply(d) - terms.Back.Wanted) };
  gradient.AToB += 4.0 * terms.Orthonormality * c * (c.transpose() * c - identity);
  gradient.BToA += 4.0 * terms.Orthonormality * d * (d.transpose() * d - identity);
  const Eigen::MatrixXd onB = c * d - identity, onA = d * c - identity;
  gradient.AToB += 2.0 * terms.Inverse * (onB * d.transpose() + d.transpose() * onA);
  gradient.BToA += 2.0 * terms.Inverse * (c.transpose() * onB + onA * c.transpose());
  return gradient;
}

std::array<double, 5> FunctionalMapEnergy::Along(
  const FunctionalMaps& maps, const FunctionalMaps& direction) const
{
  const Terms& terms = *this->Both;
  std::array<double, 5> sum{};
  const auto addQuadratic =
    [&](const QuadraticEnergy& energy, const Eigen::MatrixXd& x, const Eigen::MatrixXd& along)
  {
    const Eigen::MatrixXd image = energy.Apply(x);
    sum[0] += Dot(x, image) - 2.0 * Dot(x, energy.Wanted) + energy.Constant;
    sum[1] += 2.0 * (Dot(along, image) - Dot(along, energy.Wanted));
    sum[2] += Dot(along, energy.Apply(along));
  };
  // |(X + t U) (Y + t V) - I|^2.
  const auto addProduct = [&](double weight, const Eigen::MatrixXd& x, const Eigen::MatrixXd& u,
                            const Eigen::MatrixXd& y, const Eigen::MatrixXd& v)
  {
    const Eigen::MatrixXd zeroth = x * y - Eigen::MatrixXd::Identity(x.rows(), x.rows()),
                          first = x * v + u * y, second = u * v;
    sum[0] += weight * zeroth.squaredNorm();
    sum[1] += weight * 2.0 * Dot(zeroth, first);
    sum[2] += weight * (first.squaredNorm() + 2.0 * Dot(zeroth, second));
    sum[3] += weight * 2.0 * Dot(first, second);
    sum[4] += weight * second.squaredNorm();
  };
  const Eigen::MatrixXd &c = maps.AToB, &d = maps.BToA, &u = direction.AToB, &v = direction.BToA;
  addQuadratic(terms.Forth, c, u);
  addQuadratic(terms.Back, d, v);
  addProduct(terms.Orthonormality, c.transpose(), u.transpose(), c, u);
  addProduct(terms.Orthonormality, d.transpose(), v.transpose(), d, v);
  addProduct(terms.Inverse, c, u, d, v);
  addProduct(terms.Inverse, d, v, c, u);
  return sum;
}

FunctionalMaps FunctionalMapEnergy::Start(const Progress& progress) const
{
  return { this->Both->Forth.Minimize(progress.Part(0.0, 0.5)),
    this->Both->Back.Minimize(progress.Part(0.5, 1.0)) };
}

FunctionalMaps FitFunctionalMaps(const SurfaceDescriptors& a, const SurfaceDescriptors& b,
  const FunctionalMapFitOptions& options, const Progress& progress)
{
  if (options.OrthonormalityWeight <= 0.0 && options.InverseWeight <= 0.0)
  {
    return WithTranspose(FitFunctionalMap(a, b, options, progress));
  }
  const BlasThreads one(false);
  const FunctionalMapEnergy energy(a, b, options, progress.Part(0.0, 0.3));
  FunctionalMaps maps = energy.Start(progress.Part(0.3, 0.6));
  // As for the quadratic part, refinement improves the maps anyway.
  constexpr int maximum = 200;
  constexpr double minimum = 1e-5; // of the gradient at the start
  FunctionalMaps gradient = energy.Gradient(maps), direction = Sum(gradient, -2.0, gradient);
  double squared = Dot(gradient, gradient);
  const double enough = minimum * minimum * squared;
  for (int k = 0; k < maximum && squared > enough; ++k)
  {
    progress(0.6 + 0.4 * k / maximum);
    maps = Sum(maps, FirstMinimum(energy.Along(maps, direction)), direction);
    const FunctionalMaps next = energy.Gradient(maps);
    const double nextSquared = Dot(next, next);
    const double beta = std::max(0.0, (nextSquared - Dot(next, gradient)) / squared);
    direction = Sum(Sum(next, -2.0, next), beta, direction);
    if (Dot(direction, next) >= 0.0) // not downwards any more
    {
      direction = Sum(next, -2.0, next);
    }
    gradient = next;
    squared = nextSquared;
  }
  progress(1.0);
  return maps;
}

} // namespace shape
