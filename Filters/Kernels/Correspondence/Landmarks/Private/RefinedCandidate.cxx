#include "Correspondence/Landmarks/Private/RefinedCandidate.h"

#include "Correspondence/Pair/ReversedArea.h"
#include "Search/NearestSurfacePoints.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr int FewestFunctions = 20;

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

CandidateRefinement::CandidateRefinement(const MatchedSurface& a, const MatchedSurface& b)
  : Pairs(static_cast<int>(std::min<Eigen::Index>(
      { Functions, a.Spectrum.Eigenvalues.size(), b.Spectrum.Eigenvalues.size() })))
  , A(a)
  , B(b)
{
}

RefinedCandidate CandidateRefinement::Refine(
  const Eigen::VectorXi& aToB, const Eigen::VectorXi& bToA, const Progress& progress) const
{
  const int first = std::min(FewestFunctions, this->Pairs);
  const auto at = [](const MatchedSurface& side, const std::vector<int>& points, int functions)
  { return Eigen::MatrixXd(side.Spectrum.Eigenfunctions(points, Eigen::seqN(0, functions))); };
  const std::vector<int>&samplesA = this->A.Featured.Samples, &samplesB = this->B.Featured.Samples;
  const Eigen::MatrixXd ofA = at(this->A, samplesA, first), ofB = at(this->B, samplesB, first);
  Eigen::MatrixXd fromA(ofA.rows() + ofB.rows(), first), fromB(fromA.rows(), first);
  fromA << ofA, ofA(bToA, Eigen::all);
  fromB << ofB(aToB, Eigen::all), ofB;
  ZoomOutOptions options;
  options.Last = this->Pairs;
  options.Step = 10; // smaller steps rank the candidates alike
  FunctionalMaps maps = RefineByZoomOut({ this->A.Surface.Triangles(), this->A.Spectrum, samplesA },
    { this->B.Surface.Triangles(), this->B.Spectrum, samplesB },
    { FitCoefficients(fromA, fromB), FitCoefficients(fromB, fromA) }, {}, options,
    progress.Part(0.0, 0.5));

  const Eigen::VectorXd valuesA = this->A.Spectrum.Eigenvalues.head(this->Pairs),
                        valuesB = this->B.Spectrum.Eigenvalues.head(this->Pairs);
  // With C from B to A, phi_A(x) = C phi_B(image of x).
  const Eigen::MatrixXd onB = this->B.Spectrum.Eigenfunctions.leftCols(this->Pairs) *
    maps.BToA.transpose(),
                        imagesOnB = onB(samplesB, Eigen::all);
  RefinedCandidate refined;
  refined.AToB = FindNearestRows(at(this->A, samplesA, this->Pairs), imagesOnB);
  refined.FeaturesToB =
    FindNearestRows(at(this->A, this->A.Featured.Features, this->Pairs), imagesOnB);
  refined.Commutativity = 0.5 *
    (CommutativityError(maps.AToB, valuesA, valuesB) +
      CommutativityError(maps.BToA, valuesB, valuesA));
  refined.Orthonormality = 0.5 * (OrthonormalityError(maps.AToB) + OrthonormalityError(maps.BToA));
  refined.ReversedArea = ComputeReversedArea(this->A.Surface, this->B.Surface,
    FindNearestSurfacePoints(this->A.Spectrum.Eigenfunctions.leftCols(this->Pairs),
      this->B.Surface.Triangles(), onB, progress.Part(0.5, 1.0)));
  refined.Maps = std::move(maps);
  return refined;
}

} // namespace shape
