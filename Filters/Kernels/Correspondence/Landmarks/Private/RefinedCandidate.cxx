#include "Correspondence/Landmarks/Private/RefinedCandidate.h"

#include "Search/NearestSurfacePoints.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

constexpr int FewestFunctions = 20, MostFunctions = 60;

double CommutativityError(
  const Eigen::MatrixXd& map, const Eigen::VectorXd& from, const Eigen::VectorXd& to)
{
  const Eigen::MatrixXd difference = to.asDiagonal() * map - map * from.asDiagonal();
  return difference.norm() / from.norm();
}

double OrthonormalityError(const Eigen::MatrixXd& map)
{
  const Eigen::Index size = map.cols();
  const Eigen::MatrixXd difference = map.transpose() * map - Eigen::MatrixXd::Identity(size, size);
  return difference.norm() / std::sqrt(static_cast<double>(size));
}

} // namespace

CandidateRefinement::Side CandidateRefinement::Prepare(
  const Surface& surface, const FeaturedSurface& featured, int pairs, const Progress& progress)
{
  const double length = std::sqrt(ComputePointAreas(surface).sum());
  Side side{ { surface.Points() / length, surface.Triangles() }, {}, featured.Features,
    featured.Samples };
  constexpr double tolerance = 1e-6; // as precise as the comparison needs
  side.Spectrum = SolveLaplaceEigenproblem(side.Surface, pairs, progress, tolerance);
  return side;
}

CandidateRefinement::CandidateRefinement(const Surface& a, const FeaturedSurface& onA,
  const Surface& b, const FeaturedSurface& onB, const Progress& progress)
  : Pairs(static_cast<int>(
      std::min<Eigen::Index>({ MostFunctions, a.Points().rows(), b.Points().rows() })))
  , A(Prepare(a, onA, this->Pairs, progress.Part(0.0, 0.5)))
  , B(Prepare(b, onB, this->Pairs, progress.Part(0.5, 1.0)))
{
}

RefinedCandidate CandidateRefinement::Refine(
  const Eigen::VectorXi& aToB, const Eigen::VectorXi& bToA, const Progress& progress) const
{
  const int first = std::min(FewestFunctions, this->Pairs);
  const Eigen::MatrixXd ofA = this->A.At(this->A.Samples, first),
                        ofB = this->B.At(this->B.Samples, first);
  Eigen::MatrixXd onA(ofA.rows() + ofB.rows(), first), onB(onA.rows(), first);
  onA << ofA, ofA(bToA, Eigen::all);
  onB << ofB(aToB, Eigen::all), ofB;
  ZoomOutOptions options;
  options.Last = this->Pairs;
  options.Step = 10; // smaller steps rank the candidates alike
  const FunctionalMaps maps = RefineByZoomOut(this->A.Sampled(), this->B.Sampled(),
    { FitCoefficients(onA, onB), FitCoefficients(onB, onA) }, {}, options, progress);

  const Eigen::VectorXd &valuesA = this->A.Spectrum.Eigenvalues,
                        &valuesB = this->B.Spectrum.Eigenvalues;
  // With C from B to A, phi_A(x) = C phi_B(image of x).
  const Eigen::MatrixXd samplesOfB =
    this->B.At(this->B.Samples, this->Pairs) * maps.BToA.transpose();
  return { FindNearestRows(this->A.At(this->A.Samples, this->Pairs), samplesOfB),
    FindNearestRows(this->A.At(this->A.Features, this->Pairs), samplesOfB),
    0.5 *
      (CommutativityError(maps.AToB, valuesA, valuesB) +
        CommutativityError(maps.BToA, valuesB, valuesA)),
    0.5 * (OrthonormalityError(maps.AToB) + OrthonormalityError(maps.BToA)) };
}

} // namespace shape
