#include "Correspondence/Pair/ZoomOut.h"

#include "Search/NearestSurfacePoints.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace shape
{
namespace
{

/// Corresponding rows of both surfaces.
struct Pairs
{
  Eigen::MatrixXd OfA, OfB;

  void Append(const Eigen::MatrixXd& ofA, const Eigen::MatrixXd& ofB)
  {
    const Eigen::Index before = this->OfA.rows(), more = ofA.rows();
    this->OfA.conservativeResize(before + more, ofA.cols());
    this->OfB.conservativeResize(before + more, ofB.cols());
    this->OfA.bottomRows(more) = ofA;
    this->OfB.bottomRows(more) = ofB;
  }
};

/// The points that triangles use: others have no eigenfunctions.
std::vector<int> UsedPoints(const SampledSpectrum& surface)
{
  std::vector<bool> isUsed(surface.Spectrum.Masses.size(), false);
  for (const int point : surface.Triangles.reshaped())
  {
    isUsed[point] = true;
  }
  std::vector<int> used;
  for (int i = 0; i < static_cast<int>(isUsed.size()); ++i)
  {
    if (isUsed[i])
    {
      used.push_back(i);
    }
  }
  return used;
}

} // namespace

Eigen::MatrixXd FitCoefficients(const Eigen::MatrixXd& from, const Eigen::MatrixXd& to)
{
  constexpr double minimum = 1e-9; // of the diagonal: if samples are fewer than eigenfunctions
  Eigen::MatrixXd normal = to.transpose() * to;
  normal.diagonal().array() += minimum * normal.diagonal().maxCoeff();
  return normal.llt().solve(to.transpose() * from);
}

FunctionalMaps RefineByZoomOut(const SampledSpectrum& a, const SampledSpectrum& b,
  const FunctionalMaps& start, const Landmarks& landmarks, const ZoomOutOptions& options,
  const Progress& progress)
{
  std::vector<int> ofA, ofB;
  for (const auto& [pointA, pointB] : landmarks)
  {
    ofA.push_back(pointA);
    ofB.push_back(pointB);
  }
  // The squared weight of a landmark's row is this share of the number of samples.
  constexpr double share = 0.001; // of the samples, for each landmark
  // Rows enter the normal equations squared, hence the root.
  const double weight = std::sqrt(share * static_cast<double>(a.Samples.size()));
  const Eigen::MatrixXd functionsA = a.Spectrum.Eigenfunctions(a.Samples, Eigen::all),
                        functionsB = b.Spectrum.Eigenfunctions(b.Samples, Eigen::all),
                        landmarksA = weight * a.Spectrum.Eigenfunctions(ofA, Eigen::all),
                        landmarksB = weight * b.Spectrum.Eigenfunctions(ofB, Eigen::all),
                        candidatesA = a.Spectrum.Eigenfunctions(UsedPoints(a), Eigen::all),
                        candidatesB = b.Spectrum.Eigenfunctions(UsedPoints(b), Eigen::all);
  FunctionalMaps maps = start;
  if (options.Step == 0)
  {
    return maps;
  }
  const Eigen::Index first = std::max(start.AToB.rows(), start.AToB.cols()),
                     last = std::max<Eigen::Index>(first, options.Last);
  const auto samplesAt = [&](Eigen::Index size, Eigen::Index all)
  {
    return options.SamplesPerFunction > 0.0
      ? std::min(
          all, static_cast<Eigen::Index>(options.SamplesPerFunction * static_cast<double>(size)))
      : all;
  };
  // The first pass has the size of the given map and repairs it; each later pass adds Step
  // functions.
  for (Eigen::Index size = first;; size = std::min<Eigen::Index>(size + options.Step, last))
  {
    progress(last > first ? static_cast<double>(size - first) / (last - first) : 1.0);
    const Eigen::Index knownA = maps.AToB.cols(), knownB = maps.AToB.rows(),
                       samplesA = samplesAt(size, functionsA.rows()),
                       samplesB = samplesAt(size, functionsB.rows());
    // From functional maps to point maps (Melzi et al.): nearest rows, at vertices. Positions on
    // triangles gave larger errors (Decisions). A point's row of eigenfunctions on b is its image's
    // row on a times the map's transpose.
    const Eigen::VectorXi onA = FindNearestRows(functionsB.topLeftCorner(samplesB, knownB),
                            candidatesA.leftCols(knownA) * maps.AToB.transpose()),
                          onB = FindNearestRows(functionsA.topLeftCorner(samplesA, knownA),
                            candidatesB.leftCols(knownB) * maps.BToA.transpose());
    // From point maps to functional maps of the next size. Both point maps and the landmarks enter
    // both fits (MapTree, section 5).
    Pairs pairs{ functionsA.topLeftCorner(samplesA, size),
      candidatesB.leftCols(size)(onB, Eigen::all) };
    pairs.Append(
      candidatesA.leftCols(size)(onA, Eigen::all), functionsB.topLeftCorner(samplesB, size));
    pairs.Append(landmarksA.leftCols(size), landmarksB.leftCols(size));
    maps.AToB = FitCoefficients(pairs.OfA, pairs.OfB);
    maps.BToA = FitCoefficients(pairs.OfB, pairs.OfA);
    if (size == last)
    {
      return maps;
    }
  }
}

SurfaceMaps FindPointMaps(const SampledSpectrum& a, const SampledSpectrum& b,
  const FunctionalMaps& maps, const Progress& progress)
{
  // The row of a point's image: with C from B to A, phi_A(x) = C phi_B(image of x), for all
  // eigenfunctions of the map together.
  const Eigen::Index ofA = maps.AToB.cols(), ofB = maps.AToB.rows();
  const auto functionsA = a.Spectrum.Eigenfunctions.leftCols(ofA),
             functionsB = b.Spectrum.Eigenfunctions.leftCols(ofB);
  return { FindNearestSurfacePoints(
             functionsA, b.Triangles, functionsB * maps.BToA.transpose(), progress.Part(0.0, 0.5)),
    FindNearestSurfacePoints(
      functionsB, a.Triangles, functionsA * maps.AToB.transpose(), progress.Part(0.5, 1.0)) };
}

} // namespace shape
