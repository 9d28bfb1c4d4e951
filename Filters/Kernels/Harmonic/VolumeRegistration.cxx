#include "Harmonic/VolumeRegistration.h"

#include "Base/Errors.h"
#include "Correspondence/Evaluate/Congruence.h"
#include "Harmonic/Private/RegistrationEnergy.h"
#include "Harmonic/Private/ScaledBoundary.h"
#include "Laplacian/CotangentWeights.h"
#include "Linear/LimitedMemoryBfgs.h"
#include "Linear/SparseSolve.h"

#include <Eigen/LU>

#include <cmath>
#include <utility>

namespace shape
{
namespace
{

/// A stage smooths the gradient over a length, relative to the image's size, and weights the
/// distortion by a multiple of DistortionWeight.
struct Stage
{
  double Length, Weight;
};
constexpr Stage Stages[] = { { 0.3, 100.0 }, { 0.1, 10.0 }, { 0.1, 1.0 } };
constexpr int StageCount = 3;

/// The operator (M + l^2 L)^-1 of a surface with masses M and stiffness L: it smooths over the
/// length l.
class SobolevGradient
{
public:
  SobolevGradient(const Mesh& surface, double length)
  {
    const TriangleAngles angles = ComputeTriangleAngles(surface);
    const Eigen::Index n = surface.Points.rows();
    Eigen::SparseMatrix<double> matrix =
      length * length * BuildCotangentStiffness(surface.Triangles, angles.Cotangents, n);
    matrix.diagonal() += ComputeLumpedMasses(surface.Triangles, angles.Areas, n);
    this->Factor.Factorize(matrix);
  }

  Eigen::MatrixXd operator()(const Eigen::MatrixXd& gradient) const
  {
    return this->Factor.Solve(gradient);
  }

private:
  SparseCholesky Factor;
};

/// Images with their energy.
struct Registered
{
  Eigen::MatrixXd Images;
  RegistrationEnergy::State State;
};

/// Lowers the energy of one stage. Returns the number of steps.
int Descend(const RegistrationEnergy& energy, const Stage& stage,
  const VolumeRegistrationOptions& options, Registered& at, const Mesh& start,
  const Progress& progress)
{
  const double size = ComputeLongestBoxEdge(start.Points),
               weight = stage.Weight * options.DistortionWeight;
  const SobolevGradient smooth(start, stage.Length * size);
  LimitedMemoryBfgs hessian([&](const Eigen::MatrixXd& gradient) { return smooth(gradient); });
  Eigen::MatrixXd gradient = energy.Gradient(at.State, weight, progress.Part(0.0, 0.0));
  constexpr int patience = 3; // steps in a row that hardly lower the energy
  int idle = 0;
  for (int step = 0; step < options.MaximumIterations; ++step)
  {
    const double share = static_cast<double>(step) / options.MaximumIterations;
    const Progress still = progress.Part(share, share);
    const Eigen::MatrixXd direction = -hessian.Apply(gradient);
    const double slope = InnerProduct(direction, gradient);
    const double farthest = direction.rowwise().norm().maxCoeff();
    if (!(slope < 0.0))
    {
      return step;
    }
    // No point moves farther than this in one step: closest points change.
    constexpr double reach = 0.1, enough = 1e-4, shortest = 1e-6, leastGain = 3e-3;
    const double before = at.State.Value(weight);
    Registered next;
    double factor = reach * size / farthest;
    factor = hessian.IsEmpty() ? factor : std::min(1.0, factor);
    for (; factor > shortest; factor *= 0.5)
    {
      next.Images = at.Images + factor * direction;
      next.State = energy.Evaluate(next.Images, still);
      if (next.State.Value(weight) <= before + enough * factor * slope)
      {
        break;
      }
    }
    if (factor <= shortest)
    {
      return step;
    }
    Eigen::MatrixXd nextGradient = energy.Gradient(next.State, weight, still);
    hessian.Add(next.Images - at.Images, nextGradient - gradient);
    gradient = std::move(nextGradient);
    at = std::move(next);
    idle = before - at.State.Value(weight) < leastGain * before ? idle + 1 : 0;
    if (idle == patience)
    {
      return step + 1;
    }
  }
  return options.MaximumIterations;
}

} // namespace

VolumeRegistrationResult RegisterVolume(const Surface& boundary, const Surface& target,
  const VolumeRegistrationOptions& options, const Progress& progress)
{
  // Outline:
  // 1. The solid is moved onto the target as a whole.
  // 2. The images of its boundary's points descend, stage by stage.
  // 3. The harmonic map of the final images.
  RequireOption(options.DistortionWeight > 0.0 && std::isfinite(options.DistortionWeight),
    "DistortionWeight", options.DistortionWeight, "positive and finite");
  RequireOption(
    options.MaximumIterations >= 1, "MaximumIterations", options.MaximumIterations, "at least 1");
  if (!HasArea(target))
  {
    throw InvalidInput("the Target has no area; give a surface with triangles");
  }
  RequireFinite(target.Points(), "the Target");
  const ScaledBoundary scaled = ScaleBoundary(boundary, boundary.Points());
  const Surface solid(boundary.Points()(scaled.Points, Eigen::all), scaled.Surface.Triangles());
  // Step 1.
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  if (options.Align)
  {
    motion = FindCongruence(solid, target, progress.Part(0.0, 0.05, "aligning the solid")).Motion;
  }
  const auto moved = [&](const Eigen::MatrixXd& points)
  {
    return Eigen::MatrixXd((points * motion.topLeftCorner<3, 3>().transpose()).rowwise() +
      motion.topRightCorner<3, 1>().transpose());
  };
  const double scale = std::cbrt(motion.topLeftCorner<3, 3>().determinant());
  // Step 2. A descent needs no more digits than these.
  LinearVolumeMapOptions maps;
  maps.Tolerance = 1e-7;
  maps.GradientTolerance = 1e-5;
  const RegistrationEnergy energy(
    solid, target, scale, maps, progress.Part(0.05, 0.1, "preparing the solid"));
  const Mesh start{ moved(solid.Points()), solid.Triangles() };
  Registered at{ start.Points, energy.Evaluate(start.Points) };
  VolumeRegistrationResult result;
  result.Before = energy.Judge(at.Images, at.State);
  for (int k = 0; k < StageCount; ++k)
  {
    result.Iterations += Descend(energy, Stages[k], options, at, start,
      progress.Part(0.1 + 0.3 * k, 0.4 + 0.3 * k, "registering the solid"));
  }
  // Step 3.
  result.After = energy.Judge(at.Images, at.State);
  result.Map = std::move(at.State.Map);
  result.Targets = moved(boundary.Points());
  result.Targets(scaled.Points, Eigen::all) = at.Images;
  progress(1.0);
  return result;
}

} // namespace shape
