#include "Harmonic/RegisterVolume.h"

#include "Base/Errors.h"
#include "Correspondence/Evaluate/Congruence.h"
#include "Distance/HausdorffDistance.h"
#include "Harmonic/Private/RegistrationEnergy.h"
#include "Linear/LimitedMemoryBfgs.h"
#include "Mesh/Topology.h"
#include "Search/RowFinder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Weights of the distortion, relative to DistortionWeight.
constexpr double Stages[] = { 1000.0, 100.0, 10.0, 1.0 };
constexpr int StageCount = 4;

/// Number of tetrahedra that would fill the solid, if all had the maximum volume.
constexpr double Parts = 12000.0;

/// Images with their energy.
struct Registered
{
  Eigen::MatrixXd Images;
  RegistrationEnergy::Terms Terms;
};

/// Lowers the energy with a weight. Returns the number of steps.
int Descend(const RegistrationEnergy& energy, double weight, int maximumSteps, Registered& at,
  const Progress& progress)
{
  // No point moves farther than `reach` in one step, because closest points change. The descent
  // ends after `patience` steps in a row that hardly lower the energy, or when a step would lower
  // it by less than `rounding`: it is the square of a distance relative to the target's size.
  constexpr double reach = 0.1, enough = 1e-4, shortest = 1e-6, leastGain = 1e-3, rounding = 1e-12;
  constexpr int patience = 3;
  const BoundaryHessian hessian = energy.ApproximateHessian(weight, progress.Part(0.0, 0.1));
  LimitedMemoryBfgs history([&](const Eigen::MatrixXd& vector) { return hessian.Solve(vector); });
  Eigen::MatrixXd gradient = at.Terms.Gradient(weight);
  int idle = 0, step = 0;
  for (; step < maximumSteps && idle < patience; ++step)
  {
    const double share = 0.1 + 0.9 * step / maximumSteps;
    const Progress still = progress.Part(share, share);
    const Eigen::MatrixXd direction = -history.Apply(gradient);
    const double slope = InnerProduct(direction, gradient);
    const double farthest = direction.rowwise().norm().maxCoeff();
    const double before = at.Terms.Value(weight);
    Registered next;
    double factor = slope < -rounding ? std::min(1.0, reach * energy.Size() / farthest) : 0.0;
    for (; factor > shortest; factor *= 0.5)
    {
      next.Images = at.Images + factor * direction;
      next.Terms = energy.Evaluate(next.Images, still);
      if (next.Terms.Value(weight) <= before + enough * factor * slope)
      {
        break;
      }
    }
    if (!(factor > shortest))
    {
      break;
    }
    Eigen::MatrixXd nextGradient = next.Terms.Gradient(weight);
    history.Add(next.Images - at.Images, nextGradient - gradient);
    gradient = std::move(nextGradient);
    at = std::move(next);
    idle = before - at.Terms.Value(weight) < leastGain * before ? idle + 1 : 0;
  }
  progress(1.0);
  return step;
}

RegistrationQuality Judge(const RegistrationEnergy& energy, const Registered& at,
  const Surface& target, const Progress& progress)
{
  const Surface image = energy.Image(at.Images);
  const Eigen::VectorXd there =
    ComputeDistancesToSurface(image, SurfaceLocator(target), progress.Part(0.0, 0.5)).Distances;
  const Eigen::VectorXd back =
    ComputeDistancesToSurface(target, SurfaceLocator(image), progress.Part(0.5, 1.0)).Distances;
  return { 0.5 * (there.mean() + back.mean()) / energy.Size(),
    std::max(there.maxCoeff(), back.maxCoeff()) / energy.Size(), at.Terms.Distortion };
}

} // namespace

RegisterVolumeResult RegisterVolume(const Surface& boundary, const Surface& target,
  const RegisterVolumeOptions& options, const Progress& progress)
{
  // Outline:
  // 1. The solid is filled with tetrahedra, and moved onto the target as a whole.
  // 2. The images of its boundary's points descend, stage by stage.
  // 3. The images of all points.
  RequireOption(options.DistortionWeight > 0.0 && std::isfinite(options.DistortionWeight),
    "DistortionWeight", options.DistortionWeight, "positive and finite");
  RequireOption(
    options.MaximumIterations >= 1, "MaximumIterations", options.MaximumIterations, "at least 1");
  RequireClosedSurface(boundary, "the Input");
  RequireFinite(target.Points(), "the Target");
  if (!HasArea(target))
  {
    throw InvalidInput("the Target has no area; give a surface with triangles");
  }
  // Step 1.
  RegisterVolumeResult result;
  TetrahedralizeOptions fill;
  fill.MaximumVolume = std::abs(ComputeEnclosedVolume(boundary)) / Parts;
  result.Solid =
    Tetrahedralize(boundary, {}, fill, progress.Part(0.0, 0.1, "tetrahedralizing the solid"));
  Eigen::Affine3d motion = Eigen::Affine3d::Identity();
  if (options.Align)
  {
    motion.matrix() =
      FindCongruence(boundary, target, progress.Part(0.1, 0.15, "aligning the solid")).Motion;
  }
  const auto moved = [&](const Eigen::MatrixXd& points)
  {
    return Eigen::MatrixXd(
      (points * motion.linear().transpose()).rowwise() + motion.translation().transpose());
  };
  FilledSolid solid{ moved(result.Solid.Points), result.Solid.Tetrahedra, {} };
  std::vector<int> origins; // of the boundary points of the solid
  for (int i = 0; i < result.Solid.Provenance.Points.size(); ++i)
  {
    if (const int origin = result.Solid.Provenance.Points(i); origin >= 0)
    {
      solid.Boundary.push_back(i);
      origins.push_back(origin);
    }
  }
  // Points at the same position are one point of the solid.
  const Eigen::MatrixXd positions = boundary.Points()(origins, Eigen::all);
  const std::vector<int> number = RowFinder(positions).Find(boundary.Points());
  const Eigen::MatrixXi triangles =
    boundary.Triangles().unaryExpr([&](int point) { return number[point]; });
  // Step 2.
  const RegistrationEnergy energy(
    std::move(solid), triangles, target, progress.Part(0.15, 0.2, "preparing the solid"));
  Registered at;
  at.Images = moved(positions);
  at.Terms = energy.Evaluate(at.Images);
  result.Before = Judge(energy, at, target, progress.Part(0.2, 0.25));
  for (int k = 0; k < StageCount; ++k)
  {
    result.Iterations +=
      Descend(energy, Stages[k] * options.DistortionWeight, options.MaximumIterations, at,
        progress.Part(
          0.25 + 0.7 * k / StageCount, 0.25 + 0.7 * (k + 1) / StageCount, "registering the solid"));
  }
  result.After = Judge(energy, at, target, progress.Part(0.95, 1.0));
  // Step 3.
  result.SolidTargets = energy.Map().Map(at.Images);
  result.Targets = moved(boundary.Points());
  for (Eigen::Index i = 0; i < result.Targets.rows(); ++i)
  {
    if (number[i] >= 0)
    {
      result.Targets.row(i) = at.Images.row(number[i]);
    }
  }
  progress(1.0);
  return result;
}

} // namespace shape
