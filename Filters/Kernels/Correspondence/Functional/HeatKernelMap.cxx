#include "Correspondence/Functional/HeatKernelMap.h"

#include "Base/Errors.h"
#include "Correspondence/Landmarks/AutomaticLandmarks.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Mesh/Topology.h"
#include "Search/NearestSurfacePoints.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// Throws InvalidInput if a component contains none of `points`.
void RequireReached(
  const Topology& topology, const std::vector<int>& points, const std::string& name)
{
  std::vector<char> isReached(topology.Components, 0);
  for (const int point : points)
  {
    isReached[topology.ComponentId(point)] = 1;
  }
  for (int i = 0; i < static_cast<int>(topology.ComponentId.size()); ++i)
  {
    if (!isReached[topology.ComponentId(i)])
    {
      throw InvalidInput(name + " has " + std::to_string(topology.Components) +
        " components, and the one with point " + std::to_string(i) +
        " has no landmark, so no heat reaches it; give each component a landmark");
    }
  }
}

/// The spectrum of a surface scaled to area 1.
LaplaceEigenpairs UnitSpectrum(const Surface& surface, int pairs, const Progress& progress)
{
  const double length = std::sqrt(ComputePointAreas(surface).sum());
  return SolveLaplaceEigenproblem({ surface.Points() / length, surface.Triangles() },
    std::min(pairs, static_cast<int>(surface.Points().rows())), progress);
}

/// The largest and the smallest non-zero eigenvalue.
/// One eigenvalue is 0 for each component.
std::array<double, 2> Range(const LaplaceEigenpairs& spectrum, const std::string& name)
{
  const Eigen::Index last = spectrum.Eigenvalues.size() - 1;
  const auto zeros = (spectrum.Eigenvalues.array() <= 0.0).count();
  if (zeros > last)
  {
    const std::string count = std::to_string(last + 1);
    throw InvalidInput("Eigenpairs is " + count + ", but the first " + count +
      " eigenfunctions of " + name +
      " are all constant on each of its components; increase Eigenpairs");
  }
  return { spectrum.Eigenvalues(last), spectrum.Eigenvalues(zeros) };
}

/// n x (points * times): the heat received from each of `points` at each time.
Eigen::MatrixXd Heat(
  const LaplaceEigenpairs& spectrum, const std::vector<int>& points, const Eigen::VectorXd& times)
{
  const Eigen::ArrayXd& values = spectrum.Eigenvalues;
  const Eigen::MatrixXd& functions = spectrum.Eigenfunctions;
  Eigen::MatrixXd weights(values.size(), static_cast<Eigen::Index>(points.size()) * times.size());
  Eigen::Index at = 0;
  for (const int point : points)
  {
    for (const double time : times)
    {
      // Constant functions are left out: they carry the total heat, which is equal everywhere.
      const Eigen::ArrayXd decay = (values > 0.0).select((-time * values).exp(), 0.0);
      weights.col(at) = decay * functions.row(point).transpose().array();
      // Since the eigenfunctions are orthonormal, this is the norm of the heat itself.
      const double norm = weights.col(at).norm();
      weights.col(at++) /= norm > 0.0 ? norm : 1.0;
    }
  }
  return functions * weights;
}

/// At the first time, the highest eigenfunction has decayed to this.
constexpr double Decay = 1e-4;

/// n x (points * times): the logarithm of the heat received from each of `points` at each time,
/// relative to the heat that the point itself keeps.
Eigen::MatrixXd LogHeat(
  const LaplaceEigenpairs& spectrum, const std::vector<int>& points, const Eigen::VectorXd& times)
{
  const Eigen::MatrixXd& functions = spectrum.Eigenfunctions;
  Eigen::MatrixXd heat(functions.rows(), static_cast<Eigen::Index>(points.size()) * times.size());
  Eigen::Index at = 0;
  for (const int point : points)
  {
    for (const double time : times)
    {
      const Eigen::VectorXd own =
        (-time * spectrum.Eigenvalues.array()).exp() * functions.row(point).transpose().array();
      // The eigenfunctions that are not computed count for less than this.
      heat.col(at) = functions * own;
      heat.col(at) = (heat.col(at) / heat(point, at)).array().max(Decay).log();
      ++at;
    }
  }
  return heat;
}

/// Times from that at which the highest eigenfunction has decayed, to that at which even the lowest
/// has. Earlier, the eigenfunctions beyond the last one would count; later, no heat is left. The
/// times are common to both surfaces, so the rows can be compared.
Eigen::VectorXd Times(
  const std::array<double, 2>& rangeA, const std::array<double, 2>& rangeB, int count)
{
  const double decay = -std::log(Decay);
  return Eigen::VectorXd::LinSpaced(count, std::log(decay / std::min(rangeA[0], rangeB[0])),
    std::log(decay / std::max(rangeA[1], rangeB[1])))
    .array()
    .exp();
}

/// The points with the most similar heat, both ways.
/// Ovsjanikov et al., equation 3: the image of x minimises the difference of heat at all times.
SurfaceMaps Nearest(const Surface& a, const Eigen::MatrixXd& heatA, const Surface& b,
  const Eigen::MatrixXd& heatB, const Progress& progress)
{
  return { FindNearestSurfacePoints(
             heatA, b.Triangles(), heatB, progress.Part(0.0, 0.5, "finding the nearest points")),
    FindNearestSurfacePoints(
      heatB, a.Triangles(), heatA, progress.Part(0.5, 1.0, "finding the nearest points")) };
}

void RequireHeatOptions(const HeatKernelMapOptions& options)
{
  RequireOption(options.Eigenpairs >= 2, "Eigenpairs", options.Eigenpairs, "at least 2");
  RequireOption(options.Times >= 1, "Times", options.Times, "at least 1");
}

} // namespace

SurfaceMaps ComputeHeatKernelMap(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const HeatKernelMapOptions& options, const Progress& progress)
{
  RequireHeatOptions(options);
  const Topology topologyA = RequireWhole(a, "surface A"), topologyB = RequireWhole(b, "surface B");
  RequireLandmarks(landmarks, a, b);
  const Landmarks used = landmarks.empty()
    ? FindLandmarks(a, b, {}, progress.Part(0.0, 0.2, "finding landmarks")).Pairs
    : landmarks;
  const std::vector<int> onA = PointsOf(used, 0), onB = PointsOf(used, 1);
  RequireReached(topologyA, onA, "surface A");
  RequireReached(topologyB, onB, "surface B");
  const LaplaceEigenpairs spectrumA = UnitSpectrum(a, options.Eigenpairs,
                            progress.Part(0.2, 0.5, "computing the eigenfunctions")),
                          spectrumB = UnitSpectrum(b, options.Eigenpairs,
                            progress.Part(0.5, 0.8, "computing the eigenfunctions"));
  const Eigen::VectorXd times =
    Times(Range(spectrumA, "surface A"), Range(spectrumB, "surface B"), options.Times);
  return Nearest(
    a, Heat(spectrumA, onA, times), b, Heat(spectrumB, onB, times), progress.Part(0.8, 1.0));
}

SurfaceMaps ComputePartialHeatKernelMap(const Surface& part, const Surface& whole,
  const Landmarks& landmarks, double scale, const HeatKernelMapOptions& options,
  const Progress& progress)
{
  RequireHeatOptions(options);
  RequireConnected(part, "the part");
  const Topology topology = RequireWhole(whole, "the whole");
  RequireLandmarks(landmarks, part, whole);
  const std::vector<int> onPart = PointsOf(landmarks, 0), onWhole = PointsOf(landmarks, 1);
  RequireReached(topology, onWhole, "the whole");
  // One unit for both: eigenvalues are comparable only at one scale.
  const double length = std::sqrt(ComputePointAreas(whole).sum());
  const Surface one(part.Points() * (scale / length), part.Triangles()),
    two(whole.Points() / length, whole.Triangles());
  const auto spectrum = [&](const Surface& surface, const Progress& own)
  {
    return SolveLaplaceEigenproblem(
      surface, std::min(options.Eigenpairs, static_cast<int>(surface.Points().rows())), own);
  };
  const LaplaceEigenpairs ofPart =
                            spectrum(one, progress.Part(0.0, 0.4, "computing the eigenfunctions")),
                          ofWhole =
                            spectrum(two, progress.Part(0.4, 0.8, "computing the eigenfunctions"));
  const Eigen::VectorXd times =
    Times(Range(ofPart, "the part"), Range(ofWhole, "the whole"), options.Times);
  return Nearest(one, LogHeat(ofPart, onPart, times), two, LogHeat(ofWhole, onWhole, times),
    progress.Part(0.8, 1.0));
}

} // namespace shape
