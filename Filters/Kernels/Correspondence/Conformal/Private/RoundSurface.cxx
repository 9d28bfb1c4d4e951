#include "Correspondence/Conformal/Private/RoundSurface.h"

#include "Mesh/BoundaryLoops.h"
#include "Parameterize/SphericalTriangles.h"
#include "Spectrum/Smacof.h"

#include <cmath>

namespace shape
{

RoundSurface MakeRoundSurface(
  const Surface& surface, SphereMapMethod first, const Progress& progress)
{
  RoundSurface round;
  const Eigen::VectorXd areas = ComputePointAreas(surface);
  const Surface unit(surface.Points() / std::sqrt(areas.sum()), surface.Triangles());
  round.Areas = areas / areas.sum();
  const std::vector<std::vector<int>> loops = FindManifoldBoundaryLoops(unit);
  const Surface closed = FillWithFans(unit, loops);
  SphereMapOptions options;
  options.First = first;
  const SphereMapResult map = MapToSphere(closed, options, progress.Part(0.0, 0.6));
  round.Sphere = { map.Points, closed.Triangles() };
  round.Method = map.Method;
  round.Points = ToComplexPoints(round.Sphere.Points);
  const Eigen::VectorXd angles = ComputeSolidAngles(closed.Triangles(), round.Sphere.Points);
  Eigen::VectorXd onSphere = Eigen::VectorXd::Zero(closed.Points().rows());
  for (Eigen::Index t = 0; t < angles.size(); ++t)
  {
    // A point gets a third of each solid angle around it, as it gets a third of each triangle's
    // area.
    for (const int corner : closed.Triangles().row(t))
    {
      onSphere(corner) += angles(t) / 3.0;
    }
  }
  // A point without area has no logarithm; the limit keeps its scale finite.
  constexpr double tiny = 1e-300;
  round.LogScales =
    ComputePointAreas(closed).array().max(tiny).log() - onSphere.array().max(tiny).log();
  SmacofOptions scaling;
  scaling.Samples = 300;
  round.Embedding.setZero(closed.Points().rows(), scaling.Dimensions);
  round.Embedding.topRows(surface.Points().rows()) =
    EmbedBySmacof(unit, scaling, progress.Part(0.6, 1.0));
  // The centre of a fan is not on the surface; it is embedded at the mean of its loop.
  for (std::size_t k = 0; k < loops.size(); ++k)
  {
    round.Embedding.row(surface.Points().rows() + static_cast<Eigen::Index>(k)) =
      round.Embedding(loops[k], Eigen::all).colwise().mean();
  }
  return round;
}

ConformalImages ComputeConformalImages(const RoundSurface& from, const std::vector<int>& points,
  const RoundSurface& to, const SurfaceLocator& locator, const Eigen::Matrix2cd& moebius)
{
  const ComplexPoints own = from.Points(points, Eigen::all);
  const ClosestPoints positions = locator.Find(ToSphere(ApplyMoebiusTransform(own, moebius)));
  // The map from A to B is: A to its sphere, the Moebius transform, B's sphere to B. The logarithms
  // of the three area scales add up.
  const Eigen::VectorXd scales = ComputeLogAreaScales(own, moebius) - from.LogScales(points) +
    PullBack(positions, to.Sphere.Triangles, to.LogScales);
  // An isometry has scale 1 and trust 1 / cosh(0) = 1.
  return { PullBack(positions, to.Sphere.Triangles, to.Embedding),
    scales.array().cosh().inverse() };
}

} // namespace shape
