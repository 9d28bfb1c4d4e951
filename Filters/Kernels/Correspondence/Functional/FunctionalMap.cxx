#include "Correspondence/Functional/FunctionalMap.h"

#include "Base/Errors.h"
#include "Correspondence/Functional/Private/LandmarkKernels.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Geodesics/FarthestPoints.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Spectrum/SpectralSignatures.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shape
{

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
  std::vector<std::vector<int>> Curves;
  Eigen::MatrixXd Displacements;

  SampledSpectrum Sampled() const
  {
    return { this->Surface.Triangles(), this->Spectrum, this->Samples };
  }
  SurfaceDescriptors Described() const
  {
    return { this->Surface, this->Spectrum, this->Descriptors, this->Given, this->Curves,
      this->Displacements };
  }
};

/// `count` wave kernels, `count` heat kernels, and `count` wave kernels from each landmark.
Eigen::MatrixXd BuiltInDescriptors(
  const LaplaceEigenpairs& spectrum, const Landmarks& landmarks, int which, int count)
{
  const Eigen::MatrixXd kernels = ComputeLandmarkKernels(spectrum, landmarks, which, count);
  Eigen::MatrixXd descriptors(spectrum.Masses.size(), 2 * count + kernels.cols());
  descriptors << ComputeWaveKernelSignature(spectrum, count),
    ComputeHeatKernelSignature(spectrum, count), kernels;
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

/// The descriptors that are used, of the built-in ones, those of the curves, and the given ones.
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
  const double length = std::sqrt(ComputePointAreas(surface).sum());
  Side side{ { surface.Points() / length, surface.Triangles() }, {}, {}, 0, {}, {},
    (which == 0 ? options.Guide.DisplacementsOfA : options.Guide.DisplacementsOfB) / length };
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
  for (const Landmarks& curve : options.Guide.Curves)
  {
    side.Curves.push_back(PointsOf(curve, which));
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
    const Eigen::Index size = std::min(basis.cols(), side.Spectrum.Eigenvalues.size());
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
// 2. Fit small functional maps to the descriptors (FitFunctionalMaps), or take the given one.
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
  const Eigen::MatrixXd& matrix = options.Guide.Matrix;
  const int given =
    matrix.size() == 0 ? 0 : static_cast<int>(std::max(matrix.rows(), matrix.cols()));
  const int pairs = std::min(std::max(options.Refinement.Last, given), points);
  FunctionalMapFitOptions fit = options.Fit;
  fit.Size = std::min(fit.Size, pairs);
  ZoomOutOptions refinement = options.Refinement;
  refinement.Last = pairs;

  const Side one = Prepare(a, pairs, landmarks, 0, options, progress.Part(0.0, 0.2));
  const Side two = Prepare(b, pairs, landmarks, 1, options, progress.Part(0.2, 0.4));
  const FunctionalMaps start = given > 0 ? WithTranspose(GivenMap(options.Guide, one, two))
                                         : FitFunctionalMaps(one.Described(), two.Described(), fit,
                                             progress.Part(0.4, 0.5, "fitting the functional map"));
  const FunctionalMaps maps = RefineByZoomOut(one.Sampled(), two.Sampled(), start, landmarks,
    refinement, progress.Part(0.5, 0.9, "refining the functional map"));
  return FindPointMaps(
    one.Sampled(), two.Sampled(), maps, progress.Part(0.9, 1.0, "finding the nearest points"));
}

} // namespace shape
