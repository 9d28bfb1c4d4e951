#include "Correspondence/Functional/FunctionalMap.h"

#include "Base/Errors.h"
#include "Geodesics/FarthestPoints.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/NearestSurfacePoints.h"
#include "Spectrum/SpectralSignatures.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shape
{
namespace
{

/// One of the two surfaces with its area made 1.
struct Side
{
  shape::Surface Surface;
  LaplaceSpectrum Spectrum;
  Eigen::MatrixXd Descriptors;
  std::vector<int> Samples;

  SampledSpectrum Sampled() const
  {
    return { this->Surface.Triangles(), this->Spectrum, this->Samples };
  }
  SurfaceDescriptors Described() const
  {
    return { this->Surface, this->Spectrum, this->Descriptors };
  }
};

Side Prepare(const Surface& surface, int pairs, const Landmarks& landmarks, int which,
  const FunctionalMapOptions& options, const Progress& progress)
{
  Side side{ { surface.Points() / std::sqrt(ComputePointAreas(surface).sum()),
               surface.Triangles() },
    {}, {}, {} };
  constexpr double tolerance = 1e-6; // as good for maps as smaller ones, and found sooner
  side.Spectrum = SolveLaplaceEigenproblem(side.Surface, pairs, progress.Part(0.0, 0.7), tolerance);
  const int count = options.Descriptors;
  // Curves are many landmarks: a few of them tell as much, by their order.
  constexpr std::size_t maximum = 12;
  const std::size_t each = std::min(landmarks.size(), maximum);
  side.Descriptors.resize(surface.Points().rows(), count * (2 + each));
  side.Descriptors.leftCols(count) = ComputeWaveKernelSignature(side.Spectrum, count);
  side.Descriptors.middleCols(count, count) = ComputeHeatKernelSignature(side.Spectrum, count);
  for (std::size_t i = 0; i < each; ++i)
  {
    side.Descriptors.middleCols(count * (2 + i), count) =
      ComputeWaveKernelFrom(side.Spectrum, landmarks[i * landmarks.size() / each][which], count);
  }
  side.Samples = SampleFarthestPoints(side.Surface, options.Samples, progress.Part(0.8, 1.0));
  return side;
}

int CountUsedPoints(const Surface& surface, const char* name)
{
  const Topology topology = RequireManifold(surface, name);
  return static_cast<int>((topology.ComponentId.array() >= 0).count());
}

} // namespace

SurfaceMaps ComputeFunctionalMap(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const FunctionalMapOptions& options, const Progress& progress)
{
  const int points = std::min(CountUsedPoints(a, "SurfaceA"), CountUsedPoints(b, "SurfaceB"));
  const int pairs = std::min(options.Refinement.Last, points);
  FunctionalMapFitOptions fit = options.Fit;
  fit.Size = std::min(fit.Size, pairs);
  ZoomOutOptions refinement = options.Refinement;
  refinement.Last = pairs;

  const Side one = Prepare(a, pairs, landmarks, 0, options, progress.Part(0.0, 0.3));
  const Side two = Prepare(b, pairs, landmarks, 1, options, progress.Part(0.3, 0.6));
  const Eigen::MatrixXd map =
    FitFunctionalMap(one.Described(), two.Described(), fit, progress.Part(0.6, 0.7));
  const FunctionalMaps maps = RefineByZoomOut(
    one.Sampled(), two.Sampled(), map, landmarks, refinement, progress.Part(0.7, 0.85));
  const Eigen::MatrixXd &functionsA = one.Spectrum.Eigenfunctions,
                        &functionsB = two.Spectrum.Eigenfunctions;
  return { FindNearestSurfacePoints(functionsA, b.Triangles(), functionsB * maps.BToA.transpose(),
             progress.Part(0.85, 0.92)),
    FindNearestSurfacePoints(
      functionsB, a.Triangles(), functionsA * maps.AToB.transpose(), progress.Part(0.92, 1.0)) };
}

} // namespace shape
