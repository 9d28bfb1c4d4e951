#include "Correspondence/Functional/FunctionalMap.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geodesics/FarthestPoints.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/NearestSurfacePoints.h"
#include "Spectrum/SpectralSignatures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shape
{

namespace
{

using Matrices = std::vector<Eigen::MatrixXd>;

/// The operators of one surface in the basis of its first eigenfunctions.
struct Operators
{
  Eigen::MatrixXd Coefficients; ///< k x q
  Matrices Products, Turns;     ///< q each, k x k
};

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

/// Coefficients are inner products with the mass-orthonormal eigenfunctions: phi' M f. An operator
/// T becomes phi' M T phi.
Operators OperatorsOf(
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
  Operators result{ weighted.transpose() * descriptors, Matrices(count), Matrices(count) };
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
  return result;
}

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

} // namespace

// The energy of the header is quadratic in C. Its gradient is zero if apply(C) = B A' / q; this
// linear system is symmetric and positive semidefinite, and is solved by conjugate gradients on
// matrices.
Eigen::MatrixXd FitFunctionalMap(const SurfaceDescriptors& a, const SurfaceDescriptors& b,
  const FunctionalMapFitOptions& options, const Progress& progress)
{
  // The matrices are small (30 x 30 by default): starting threads would take longer than a product.
  const BlasThreads one(false);
  const Operators ofA = OperatorsOf(a, options, progress.Part(0.0, 0.2));
  const Operators ofB = OperatorsOf(b, options, progress.Part(0.2, 0.4));
  const int size = options.Size;
  const double count = std::max<double>(1.0, static_cast<double>(ofA.Coefficients.cols()));
  const Eigen::MatrixXd squares = ofA.Coefficients * ofA.Coefficients.transpose() / count;
  const Eigen::MatrixXd wanted = ofB.Coefficients * ofA.Coefficients.transpose() / count;
  const Eigen::VectorXd valuesA = a.Spectrum.Eigenvalues.head(size),
                        valuesB = b.Spectrum.Eigenvalues.head(size);
  const double largest = std::max(valuesA.maxCoeff(), valuesB.maxCoeff());
  // |C L1 - L2 C|^2 is diagonal in the entries of C: entry (i, j) has the weight (l1_j - l2_i)^2.
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

  // The limit and the tolerance suffice, since the refinement improves the map anyway.
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

namespace
{

/// One of the two surfaces, scaled to area 1.
struct Side
{
  shape::Surface Surface;
  LaplaceEigenpairs Spectrum;
  Eigen::MatrixXd Descriptors;
  Eigen::Index Given = 0; ///< the number of descriptors that are given, the last ones
  std::vector<int> Samples;

  SampledSpectrum Sampled() const
  {
    return { this->Surface.Triangles(), this->Spectrum, this->Samples };
  }
  SurfaceDescriptors Described() const
  {
    return { this->Surface, this->Spectrum, this->Descriptors, this->Given };
  }
};

/// `count` wave kernels, `count` heat kernels, and `count` wave kernels from each landmark.
Eigen::MatrixXd BuiltInDescriptors(
  const LaplaceEigenpairs& spectrum, const Landmarks& landmarks, int which, int count)
{
  // Landmarks along curves are many: a few of them, in order, contain as much information.
  constexpr std::size_t maximum = 12;
  const std::size_t each = std::min(landmarks.size(), maximum);
  Eigen::MatrixXd descriptors(spectrum.Masses.size(), count * (2 + each));
  descriptors.leftCols(count) = ComputeWaveKernelSignature(spectrum, count);
  descriptors.middleCols(count, count) = ComputeHeatKernelSignature(spectrum, count);
  for (std::size_t i = 0; i < each; ++i)
  {
    descriptors.middleCols(count * (2 + i), count) =
      ComputeWaveKernelFrom(spectrum, landmarks[i * landmarks.size() / each][which], count);
  }
  return descriptors;
}

/// The mean of the wave kernels from the points of a curve.
Eigen::MatrixXd CurveDescriptors(
  const LaplaceEigenpairs& spectrum, const Landmarks& curve, int which, int count)
{
  Eigen::MatrixXd descriptors = Eigen::MatrixXd::Zero(spectrum.Masses.size(), count);
  for (const auto& pair : curve)
  {
    descriptors += ComputeWaveKernelFrom(spectrum, pair[which], count);
  }
  return descriptors / std::max<double>(1.0, static_cast<double>(curve.size()));
}

/// The built-in descriptors, those of the curves, and the given ones, as far as they are used.
Eigen::MatrixXd Descriptors(const LaplaceEigenpairs& spectrum, const Landmarks& landmarks,
  int which, const FunctionalMapOptions& options)
{
  using Type = FunctionalMapOptions::DescriptorType;
  std::vector<Eigen::MatrixXd> parts;
  if (options.Use != Type::Given)
  {
    parts.push_back(BuiltInDescriptors(spectrum, landmarks, which, options.Descriptors));
  }
  if (options.Use != Type::BuiltIn)
  {
    for (const Landmarks& curve : options.Guide.Curves)
    {
      parts.push_back(CurveDescriptors(spectrum, curve, which, options.Descriptors));
    }
    parts.push_back(which == 0 ? options.Guide.DescriptorsOfA : options.Guide.DescriptorsOfB);
  }
  Eigen::Index columns = 0;
  for (const Eigen::MatrixXd& part : parts)
  {
    columns += part.cols();
  }
  Eigen::MatrixXd all(spectrum.Masses.size(), columns);
  Eigen::Index at = 0;
  for (const Eigen::MatrixXd& part : parts)
  {
    all.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  return all;
}

Side Prepare(const Surface& surface, int pairs, const Landmarks& landmarks, int which,
  const FunctionalMapOptions& options, const Progress& progress)
{
  Side side{ { surface.Points() / std::sqrt(ComputePointAreas(surface).sum()),
               surface.Triangles() },
    {}, {}, 0, {} };
  constexpr double tolerance = 1e-6; // smaller ones give no better maps, but take longer
  side.Spectrum = SolveLaplaceEigenproblem(
    side.Surface, pairs, progress.Part(0.0, 0.7, "computing the eigenfunctions"), tolerance);
  if (options.Guide.Matrix.size() == 0)
  {
    side.Descriptors = Descriptors(side.Spectrum, landmarks, which, options);
    side.Given = options.Use == FunctionalMapOptions::DescriptorType::BuiltIn
      ? 0
      : options.Guide.DescriptorsOfA.cols();
  }
  side.Samples = SampleFarthestPoints(side.Surface, options.Samples, progress.Part(0.8, 1.0));
  return side;
}

/// The matrix of a guide in the first eigenfunctions of the two sides: the changes of basis are
/// Phi' M (basis of the guide).
Eigen::MatrixXd GivenMap(const FunctionalGuide& guide, const Side& one, const Side& two)
{
  const auto change = [&](const Side& side, const Eigen::MatrixXd& basis)
  {
    const Eigen::Index size = std::min(guide.Matrix.rows(), side.Spectrum.Eigenvalues.size());
    return Eigen::MatrixXd(side.Spectrum.Eigenfunctions.leftCols(size).transpose() *
      (side.Spectrum.Masses.asDiagonal() * basis));
  };
  return change(two, guide.BasisOfB) * guide.Matrix * change(one, guide.BasisOfA).transpose();
}

int CountUsedPoints(const Surface& surface, const char* name)
{
  const Topology topology = RequireManifold(surface, name);
  return static_cast<int>((topology.ComponentId.array() >= 0).count());
}

} // namespace

// 1. Compute the spectrum, descriptors and samples of both surfaces, scaled to area 1 (Prepare).
// 2. Fit a small functional map to the descriptors (FitFunctionalMap), or take the given one.
// 3. Raise its size step by step (RefineByZoomOut).
// 4. Map each point to the position with the nearest row of eigenfunctions (Ezuz and Ben-Chen).
SurfaceMaps ComputeFunctionalMap(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const FunctionalMapOptions& options, const Progress& progress)
{
  if (options.Use == FunctionalMapOptions::DescriptorType::Given &&
    !options.Guide.HasDescriptors() && options.Guide.Matrix.size() == 0)
  {
    throw InvalidInput("Descriptors is Given, but none are given; name them in DescriptorArrays or "
                       "RegionArray, or set Descriptors to BuiltIn");
  }
  const int points = std::min(CountUsedPoints(a, "SurfaceA"), CountUsedPoints(b, "SurfaceB"));
  const auto given = static_cast<int>(options.Guide.Matrix.rows());
  const int pairs = std::min(std::max(options.Refinement.Last, given), points);
  FunctionalMapFitOptions fit = options.Fit;
  fit.Size = std::min(fit.Size, pairs);
  ZoomOutOptions refinement = options.Refinement;
  refinement.Last = pairs;

  const Side one = Prepare(a, pairs, landmarks, 0, options, progress.Part(0.0, 0.2));
  const Side two = Prepare(b, pairs, landmarks, 1, options, progress.Part(0.2, 0.4));
  const Eigen::MatrixXd map = given > 0 ? GivenMap(options.Guide, one, two)
                                        : FitFunctionalMap(one.Described(), two.Described(), fit,
                                            progress.Part(0.4, 0.5, "fitting the functional map"));
  const FunctionalMaps maps = RefineByZoomOut(one.Sampled(), two.Sampled(), map, landmarks,
    refinement, progress.Part(0.5, 0.9, "refining the functional map"));
  const Eigen::MatrixXd &functionsA = one.Spectrum.Eigenfunctions,
                        &functionsB = two.Spectrum.Eigenfunctions;
  // The row of a point's image: with C from B to A, phi_A(x) = C phi_B(image of x), for all
  // eigenfunctions of the map together.
  const Eigen::Index size = maps.AToB.rows();
  return { FindNearestSurfacePoints(functionsA.leftCols(size), b.Triangles(),
             functionsB.leftCols(size) * maps.BToA.transpose(),
             progress.Part(0.9, 0.95, "finding the nearest points")),
    FindNearestSurfacePoints(functionsB.leftCols(size), a.Triangles(),
      functionsA.leftCols(size) * maps.AToB.transpose(),
      progress.Part(0.95, 1.0, "finding the nearest points")) };
}

} // namespace shape
