#include "Correspondence/Functional/PartialFunctionalMap.h"

#include "Base/Errors.h"
#include "Correspondence/Landmarks/LandmarkEmbedding.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Correspondence/Pair/ZoomOut.h"
#include "Geodesics/FarthestPoints.h"
#include "Search/NearestSurfacePoints.h"
#include "Spectrum/LaplaceEigenproblem.h"
#include "Spectrum/SpectralSignatures.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// Returns the number of eigenvalues up to a bound, at least 1.
Eigen::Index UpTo(const Eigen::VectorXd& eigenvalues, double bound)
{
  return std::max<Eigen::Index>(1, (eigenvalues.array() <= bound).count());
}

Eigen::MatrixXd Stacked(const Eigen::MatrixXd& upper, const Eigen::MatrixXd& lower)
{
  Eigen::MatrixXd both(upper.rows() + lower.rows(), upper.cols());
  both << upper, lower;
  return both;
}

/// Two spectra at one scale, and samples of the part.
struct Refinement
{
  const LaplaceEigenpairs &OfPart, &OfWhole;
  const Eigen::MatrixXi& Triangles; ///< of the full surface
  std::vector<int> Samples, PartLandmarks, WholeLandmarks;
  double Weight; ///< of each landmark; the weight of a sample is 1

  /// Fits the map to the values (samples x size) of the full surface's eigenfunctions at the
  /// images of the samples.
  Eigen::MatrixXd Map(const Eigen::MatrixXd& images) const
  {
    const Eigen::Index size = images.cols();
    const auto own = Eigen::seqN(0, this->PartSize(size));
    const Eigen::MatrixXd functions = this->OfPart.Eigenfunctions(this->Samples, own),
                          there = this->OfPart.Eigenfunctions(this->PartLandmarks, own),
                          wanted = this->OfWhole.Eigenfunctions(
                            this->WholeLandmarks, Eigen::seqN(0, size));
    return FitCoefficients(
      Stacked(images, this->Weight * wanted), Stacked(functions, this->Weight * there));
  }

  // Rodola et al., section 3: by Weyl's law the part has fewer eigenvalues below the same bound, so
  // the map has more columns than rows.
  Eigen::Index PartSize(Eigen::Index size) const
  {
    return UpTo(this->OfPart.Eigenvalues, this->OfWhole.Eigenvalues(size - 1));
  }

  /// The images of points of the part with these values of eigenfunctions (q x all).
  SurfacePoints Positions(const Eigen::MatrixXd& functions, const Eigen::MatrixXd& map,
    const Progress& progress = {}) const
  {
    return FindNearestSurfacePoints(functions.leftCols(map.rows()), this->Triangles,
      this->OfWhole.Eigenfunctions.leftCols(map.cols()) * map.transpose(), progress);
  }
};

} // namespace

SurfaceMaps ComputePartialFunctionalMap(const Surface& part, const Surface& whole,
  const Landmarks& landmarks, double scale, const PartialFunctionalMapOptions& options,
  const Progress& progress)
{
  RequireConnected(part, "the part");
  RequireConnected(whole, "the whole");
  RequireLandmarks(landmarks, part, whole);
  // Distances from two landmarks leave two mirrored positions; a third landmark decides.
  constexpr std::size_t fewest = 3;
  if (landmarks.size() < fewest)
  {
    throw InvalidInput("there are " + std::to_string(landmarks.size()) +
      " landmarks, too few to locate a part on the other surface; give at least three, or none");
  }
  RequireOption(options.Samples >= 10, "Samples", options.Samples, "at least 10");
  RequireOption(options.Eigenpairs >= 10, "Eigenpairs", options.Eigenpairs, "at least 10");
  RequireOption(options.First >= 3, "First", options.First, "at least 3");
  RequireOption(options.Step >= 1, "Step", options.Step, "at least 1");
  const double length = std::sqrt(ComputePointAreas(whole).sum());
  // One unit for both: the full surface gets area 1. Eigenvalues are comparable only at one scale.
  const Surface one(part.Points() * (scale / length), part.Triangles()),
    two(whole.Points() / length, whole.Triangles());
  const auto pairsOf = [&](const Surface& surface)
  { return std::min<int>(options.Eigenpairs, static_cast<int>(surface.Points().rows())); };
  const LaplaceEigenpairs spectrumOne = SolveLaplaceEigenproblem(one, pairsOf(one),
                            progress.Part(0.0, 0.2, "computing the eigenfunctions")),
                          spectrumTwo = SolveLaplaceEigenproblem(two, pairsOf(two),
                            progress.Part(0.2, 0.4, "computing the eigenfunctions"));
  // As in RefineByZoomOut: landmarks decide where samples are ambiguous, and yield where these
  // agree.
  constexpr double share = 0.001; // of the samples, for each landmark
  Refinement refinement{ spectrumOne, spectrumTwo, two.Triangles(),
    SampleFarthestPoints(one, options.Samples, progress.Part(0.4, 0.42)), PointsOf(landmarks, 0),
    PointsOf(landmarks, 1), 0.0 };
  refinement.Weight = std::sqrt(share * static_cast<double>(refinement.Samples.size()));
  const Eigen::MatrixXd positionsOne = EmbedByLandmarks(one, refinement.PartLandmarks, 1.0,
                          progress.Part(0.42, 0.5, "computing geodesic distances")),
                        positionsTwo = EmbedByLandmarks(two, refinement.WholeLandmarks, 1.0,
                          progress.Part(0.5, 0.6, "computing geodesic distances"));
  // Step 1: a first map of the samples, from distances to the landmarks.
  const Eigen::VectorXi start =
    FindNearestRows(positionsOne(refinement.Samples, Eigen::all), positionsTwo);
  const Eigen::MatrixXd& functions = spectrumTwo.Eigenfunctions;
  const Eigen::MatrixXd samples = spectrumOne.Eigenfunctions(refinement.Samples, Eigen::all);
  const Eigen::Index last = functions.cols(), first = std::min<Eigen::Index>(options.First, last);
  // Step 2: the first functional map, fitted to it.
  Eigen::MatrixXd map = refinement.Map(functions(start, Eigen::seqN(0, first)));
  // Step 3: rectangular ZoomOut. Only samples of the part are mapped; with samples of the full
  // surface, those outside the part would be forced onto it.
  for (Eigen::Index size = first;; size = std::min<Eigen::Index>(size + options.Step, last))
  {
    progress(0.6 + 0.2 * static_cast<double>(size) / static_cast<double>(last));
    map = refinement.Map(
      PullBack(refinement.Positions(samples, map), two.Triangles(), functions.leftCols(size)));
    if (size == last)
    {
      break;
    }
  }
  SurfaceMaps maps;
  maps.AToB = refinement.Positions(
    spectrumOne.Eigenfunctions, map, progress.Part(0.8, 0.9, "finding the nearest points"));
  // Step 4: the map back, by proximity to the images of the part. Constant eigenfunctions do not
  // separate points and are left out.
  const auto zeros = static_cast<int>((spectrumTwo.Eigenvalues.array() <= 0.0).count());
  const Eigen::MatrixXd embedding =
    ComputeSpectralEmbedding(spectrumTwo, static_cast<int>(last) - zeros);
  maps.BToA = FindNearestSurfacePoints(embedding, one.Triangles(),
    PullBack(maps.AToB, two.Triangles(), embedding),
    progress.Part(0.9, 1.0, "finding the nearest points"));
  return maps;
}

} // namespace shape
