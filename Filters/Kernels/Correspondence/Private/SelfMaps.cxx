#include "Correspondence/Private/SelfMaps.h"

#include "Correspondence/Pair/ZoomOut.h"
#include "Search/NearestSurfacePoints.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

/// The numbers of eigenfunctions, and of iterations, to fit and to refine a map. More functions are
/// less exact on coarse surfaces: with 150, images on ellipsoids and stars were 0.15 to 0.25 % of
/// the size off instead of 0.07 to 0.19 %. With 20 alone, those on a figure were 0.06 % off instead
/// of 0.02 %.
constexpr int FitFunctions = 20, FitIterations = 10, RefineFunctions = 40, RefineIterations = 5;

/// Eigenvalues of coarse surfaces are off by a few percent. Those that are nearer may be equal.
constexpr double EqualEigenvalues = 0.05;

/// Returns the number of functions, nearly `wanted`, that separates eigenvalues best: functions of
/// one eigenvalue are mapped to each other.
Eigen::Index CutAtGap(const Eigen::VectorXd& eigenvalues, int wanted)
{
  const Eigen::Index last = eigenvalues.size() - 1;
  if (wanted > last)
  {
    return eigenvalues.size();
  }
  Eigen::Index best = wanted;
  for (Eigen::Index k = wanted; k >= wanted - wanted / 5; --k)
  {
    if (eigenvalues(k) / eigenvalues(k - 1) > eigenvalues(best) / eigenvalues(best - 1))
    {
      best = k;
    }
  }
  return best;
}

} // namespace

SelfMaps::SelfMaps(const Surface& surface, const Progress& progress)
  : Scaled(surface.Points() / std::sqrt(ComputePointAreas(surface).sum()), surface.Triangles())
  , Masses(ComputePointAreas(this->Scaled))
{
  const auto points = static_cast<int>(surface.Points().rows());
  constexpr double tolerance = 1e-6; // smaller ones give no better maps, but take longer
  this->Spectrum = SolveLaplaceEigenproblem(
    this->Scaled, std::min(RefineFunctions + 1, points), progress, tolerance);
}

// Entries between different eigenvalues vanish, since the matrix commutes with the Laplacian. The
// nearest orthogonal matrix has the singular values 1.
Eigen::MatrixXd SelfMaps::FindIsometry(const Eigen::MatrixXd& fitted) const
{
  const Eigen::VectorXd& eigenvalues = this->Spectrum.Eigenvalues;
  Eigen::MatrixXd commuting = fitted;
  for (Eigen::Index i = 0; i < fitted.rows(); ++i)
  {
    for (Eigen::Index j = 0; j < fitted.cols(); ++j)
    {
      const double larger = std::max(eigenvalues(i), eigenvalues(j));
      const double apart =
        i == j ? 0.0 : (eigenvalues(i) - eigenvalues(j)) / (EqualEigenvalues * larger);
      commuting(i, j) *= std::exp(-apart * apart);
    }
  }
  const Eigen::BDCSVD<Eigen::MatrixXd> svd(commuting, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

/// The images of points are those with the nearest values of the mapped functions. Distances of
/// functions divided by the roots of their eigenvalues (Rustamov 2007) depend on the first ones
/// most, which are the most exact.
SurfacePoints SelfMaps::FindImages(const Eigen::MatrixXd& fitted) const
{
  const Eigen::Index count = fitted.cols();
  const auto first = this->Spectrum.Eigenfunctions.leftCols(count);
  Eigen::VectorXd weights(count);
  weights(0) = 0.0; // a constant
  weights.tail(count - 1) =
    this->Spectrum.Eigenvalues.segment(1, count - 1).cwiseSqrt().cwiseInverse();
  return FindNearestSurfacePoints(first * (this->FindIsometry(fitted) * weights.asDiagonal()),
    this->Scaled.Triangles(), first * weights.asDiagonal());
}

SurfacePoints SelfMaps::Iterate(
  SurfacePoints map, int functions, int iterations, const Progress& progress) const
{
  const auto first =
    this->Spectrum.Eigenfunctions.leftCols(CutAtGap(this->Spectrum.Eigenvalues, functions));
  for (int i = 0; i < iterations; ++i)
  {
    progress(static_cast<double>(i) / iterations);
    map = this->FindImages(first.transpose() * this->Masses.asDiagonal() *
      PullBack(map, this->Scaled.Triangles(), first));
  }
  return map;
}

SurfacePoints SelfMaps::Fit(
  const std::vector<int>& from, const std::vector<int>& to, const Progress& progress) const
{
  const auto first =
    this->Spectrum.Eigenfunctions.leftCols(CutAtGap(this->Spectrum.Eigenvalues, FitFunctions));
  // first(to) = first(from) C
  const SurfacePoints map =
    this->FindImages(FitCoefficients(first(to, Eigen::all), first(from, Eigen::all)));
  return this->Iterate(map, FitFunctions, FitIterations, progress);
}

SurfacePoints SelfMaps::Refine(const SurfacePoints& map, const Progress& progress) const
{
  return this->Iterate(map, RefineFunctions, RefineIterations, progress);
}

} // namespace shape
