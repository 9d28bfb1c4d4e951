#include "Untangle/MinimizeEnergy.h"

#include "Base/Parallel.h"
#include "Geometry/Orientation.h"
#include "Linear/NewtonSystem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace shape
{
namespace
{

/// At this epsilon the energy is a barrier: no step may make a determinant negative.
constexpr double MinimumEpsilon = 1e-10;
/// The factor by which chi of the minimum determinant falls from step to step.
constexpr double MinimumShare = 0.1, MaximumShare = 0.5;

/// Sums are taken over ranges of this fixed size, so that they do not depend on the number of
/// threads.
constexpr int SimplexGrain = 2048;

template <typename Body>
void ForAllSimplices(int count, const Body& body)
{
  if (count <= SimplexGrain)
  {
    body(0, count);
  }
  else
  {
    ParallelFor(count, SimplexGrain, body);
  }
}

/**
 * The energy of a patch, and its Newton directions, on points of its own: columns, those of
 * patch.FreePoints first. The patch and the constraint must outlive it.
 */
class PatchEnergy : public EnergyProblem
{
public:
  PatchEnergy(const Eigen::MatrixXd& points, const SimplexPatch& patch,
    const PointConstraint* constraint, const Progress& progress)
    : Patch(patch)
    , Constraint(constraint)
    , FreeCount(static_cast<int>(patch.FreePoints.size()))
    , Corners(NumberCorners(points))
    , System(this->Widths(), this->FreeCorners(), 4, progress)
  {
  }

  const Eigen::Matrix3Xd& Start() const { return this->Given; } ///< 3 x local points

  int CountNegative(const Eigen::Matrix3Xd& x) const override
  {
    int negative = 0;
    for (const std::array<int, 4>& c : this->Corners)
    {
      negative += EvaluateOrientation(x.col(c[0]).transpose(), x.col(c[1]).transpose(),
                    x.col(c[2]).transpose(), x.col(c[3]).transpose()) <= 0;
    }
    return negative;
  }

  State Evaluate(const Eigen::Matrix3Xd& x, double epsilon) const override
  {
    const int count = static_cast<int>(this->Corners.size());
    std::vector<State> parts(count / SimplexGrain + 1);
    const auto part = [&](int begin, int end)
    {
      State& sum = parts[begin / SimplexGrain];
      for (int i = begin; i < end; ++i)
      {
        const EllipticEnergy energy(this->JacobianOf(i, x), epsilon);
        sum.Energy += energy.Value();
        sum.MinimumDeterminant = std::min(sum.MinimumDeterminant, energy.Determinant());
      }
    };
    ForAllSimplices(count, part);
    State all;
    for (const State& sum : parts)
    {
      all.Energy += sum.Energy;
      all.MinimumDeterminant = std::min(all.MinimumDeterminant, sum.MinimumDeterminant);
    }
    all.Energy /= count;
    return all;
  }

  /// The direction in which every point moves by a step of its own unknowns.
  Descent NewtonDirection(
    const Eigen::Matrix3Xd& x, double epsilon, const Progress& progress) override
  {
    std::vector<PointDirections> bases(this->FreeCount);
    for (int point = 0; point < this->FreeCount; ++point)
    {
      bases[point] = this->BasisOf(point, x);
    }
    this->System.Clear();
    const auto count = static_cast<int>(this->Corners.size());
    for (int i = 0; i < count; ++i)
    {
      if (i % SimplexGrain == 0)
      {
        progress(0.3 * i / count);
      }
      this->AddSimplex(i, x, epsilon, bases);
    }
    const NewtonSystem::Step step = this->System.Solve({ 1e-12, 1e3 }, progress.Part(0.3, 1.0));
    Descent descent{ Eigen::Matrix3Xd(3, this->FreeCount), step.Slope };
    for (int point = 0; point < this->FreeCount; ++point)
    {
      descent.Direction.col(point) = bases[point] * step.Of(this->System, point);
    }
    return descent;
  }

  void Move(Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& direction, double step) const override
  {
    x.leftCols(this->FreeCount) += step * direction;
    for (int point = 0; this->Constraint && point < this->FreeCount; ++point)
    {
      if (this->System.Width(point) < 3)
      {
        x.col(point) =
          this->Constraint->Nearest(this->Patch.FreePoints[point], x.col(point).transpose())
            .transpose();
      }
    }
  }

private:
  /// Numbers the points of the patch, the free ones first, and takes their positions.
  std::vector<std::array<int, 4>> NumberCorners(const Eigen::MatrixXd& points)
  {
    std::unordered_map<int, int> local;
    local.reserve(2 * this->Patch.FreePoints.size());
    for (const int point : this->Patch.FreePoints)
    {
      local.emplace(point, static_cast<int>(local.size()));
    }
    std::vector<std::array<int, 4>> all;
    all.reserve(this->Patch.Simplices.size());
    for (const ReferenceSimplex& simplex : this->Patch.Simplices)
    {
      std::array<int, 4>& corners = all.emplace_back();
      for (int k = 0; k < 4; ++k)
      {
        corners[k] =
          local.emplace(simplex.Corners[k], static_cast<int>(local.size())).first->second;
      }
    }
    this->Given.resize(3, static_cast<Eigen::Index>(local.size()));
    for (const auto& [point, index] : local)
    {
      this->Given.col(index) = points.row(point).transpose();
    }
    return all;
  }

  std::vector<int> Widths() const
  {
    std::vector<int> widths;
    for (const int point : this->Patch.FreePoints)
    {
      widths.push_back(this->Constraint ? this->Constraint->Freedom(point) : 3);
    }
    return widths;
  }

  std::vector<int> FreeCorners() const
  {
    std::vector<int> free;
    free.reserve(4 * this->Corners.size());
    for (const std::array<int, 4>& corners : this->Corners)
    {
      for (const int point : corners)
      {
        free.push_back(point < this->FreeCount ? point : -1);
      }
    }
    return free;
  }

  Eigen::Matrix3d JacobianOf(std::size_t simplex, const Eigen::Matrix3Xd& x) const
  {
    const std::array<int, 4>& c = this->Corners[simplex];
    // From differences: the positions themselves may be far larger than the simplex.
    Eigen::Matrix3d edges;
    edges << x.col(c[1]) - x.col(c[0]), x.col(c[2]) - x.col(c[0]), x.col(c[3]) - x.col(c[0]);
    return edges * this->Patch.Simplices[simplex].Gradients.bottomRows<3>();
  }

  PointDirections BasisOf(int point, const Eigen::Matrix3Xd& x) const
  {
    return this->System.Width(point) == 3
      ? PointDirections(Eigen::Matrix3d::Identity())
      : this->Constraint->Directions(this->Patch.FreePoints[point], x.col(point).transpose());
  }

  void AddSimplex(
    int i, const Eigen::Matrix3Xd& x, double epsilon, const std::vector<PointDirections>& bases)
  {
    const double share = 1.0 / static_cast<double>(this->Corners.size());
    const EllipticEnergy energy(this->JacobianOf(i, x), epsilon);
    const Eigen::Matrix<double, 4, 3>& hats = this->Patch.Simplices[i].Gradients;
    const auto [identity, mixed, rank] = energy.SecondDerivative();
    const Eigen::Matrix<double, 3, 4> byJ = energy.Jacobian() * hats.transpose();
    const Eigen::Matrix<double, 3, 4> byC = energy.Cofactors() * hats.transpose();
    const Eigen::Matrix<double, 3, 4> slopes = share * energy.Gradient() * hats.transpose();
    const std::array<int, 4>& c = this->Corners[i];
    for (int b = 0; b < 4; ++b)
    {
      if (c[b] >= this->FreeCount)
      {
        continue;
      }
      this->System.AddGradient(i, b, bases[c[b]].transpose() * slopes.col(b));
      for (int a = 0; a < 4; ++a)
      {
        if (!this->System.HasCurvature(i, a, b))
        {
          continue;
        }
        // The curvature of EllipticEnergy by the chain rule from J to the corners' positions.
        Eigen::Matrix3d block =
          mixed * (byJ.col(a) * byC.col(b).transpose() + byC.col(a) * byJ.col(b).transpose()) +
          rank * byC.col(a) * byC.col(b).transpose();
        block.diagonal().array() += identity * hats.row(a).dot(hats.row(b));
        block *= share;
        if (this->System.Width(c[a]) == 3 && this->System.Width(c[b]) == 3)
        {
          this->System.AddCurvature(i, a, b, block);
        }
        else
        {
          this->System.AddCurvature(
            i, a, b, Eigen::MatrixXd(bases[c[a]].transpose() * block * bases[c[b]]));
        }
      }
    }
  }

  const SimplexPatch& Patch;
  const PointConstraint* Constraint;
  int FreeCount;
  Eigen::Matrix3Xd Given;
  std::vector<std::array<int, 4>> Corners; ///< of the simplices
  NewtonSystem System;
};

/// Returns the minimiser of the sum of |J|^2, the start for very distorted positions.
Eigen::Matrix3Xd Smoothest(
  const Eigen::Matrix3Xd& x, EnergyProblem& problem, const Progress& progress)
{
  // One step of the same method, with an epsilon so large that all determinants are negligible.
  const EnergyProblem::Descent descent = problem.NewtonDirection(x, 1e100, progress);
  Eigen::Matrix3Xd smooth = x;
  problem.Move(smooth, descent.Direction, 1.0);
  return smooth;
}

} // namespace

// The iteration of Garanzha et al. 2021. In each step:
// 1. A Newton direction of the energy with the present epsilon.
// 2. A line search: steps are halved until the energy falls enough (Armijo's condition).
// 3. The next epsilon follows from the minimum determinant and the gain (eq. 7).
// It ends a few steps after all determinants are positive, or at the maximum number of steps.
PatchResult MinimizeEnergy(Eigen::Matrix3Xd& x, EnergyProblem& problem, const PatchOptions& options,
  const Progress& progress)
{
  PatchResult result;
  result.Negative = problem.CountNegative(x);
  double epsilon = result.Negative > 0 ? options.FirstEpsilon : MinimumEpsilon;
  EnergyProblem::State state = problem.Evaluate(x, epsilon);
  if (result.Negative > 0 && options.FromSmoothest)
  {
    Eigen::Matrix3Xd smooth = Smoothest(x, problem, progress.Part(0.0, 0.0));
    const EnergyProblem::State other = problem.Evaluate(smooth, epsilon);
    if (other.Energy < state.Energy)
    {
      x = std::move(smooth);
      state = other;
      result.Negative = problem.CountNegative(x);
    }
  }
  result.EnergyBefore = state.Energy;
  int further = 0, stalled = 0, fewest = result.Negative;
  double lowest = state.MinimumDeterminant;
  double share = MinimumShare;
  Eigen::Matrix3Xd trial;
  for (; result.Steps < options.MaximumSteps; ++result.Steps)
  {
    const double begin = static_cast<double>(result.Steps) / options.MaximumSteps;
    const double end = (result.Steps + 1.0) / options.MaximumSteps;
    progress(begin);
    if (result.Negative == 0 && further >= options.FurtherSteps)
    {
      break;
    }
    further += result.Negative == 0;
    const auto descent = problem.NewtonDirection(x, epsilon, progress.Part(begin, end));
    EnergyProblem::State next;
    double step = 1.0;
    for (; step > 1e-9; step *= 0.5)
    {
      progress(end);
      trial = x;
      problem.Move(trial, descent.Direction, step);
      next = problem.Evaluate(trial, epsilon);
      // With the smallest epsilon, a positive patch must stay positive.
      const bool valid = epsilon > MinimumEpsilon || next.MinimumDeterminant > 0.0;
      if (valid && next.Energy <= state.Energy - 1e-4 * step * descent.Slope)
      {
        break;
      }
    }
    const bool moved = step > 1e-9 && descent.Slope > 0.0;
    const double gain = moved ? 1.0 - next.Energy / state.Energy : 0.0;
    if (moved)
    {
      x.swap(trial);
      state = next;
    }
    const double before = epsilon;
    // Full steps with little gain mean that the minimiser for this epsilon is near: go faster.
    if (step == 1.0 && gain < 0.05)
    {
      share = std::min(1.3 * share, MaximumShare);
    }
    else if (step < 1.0)
    {
      share = std::max(0.5 * share, MinimumShare);
    }
    // Eq. 7: chi of the minimum determinant falls by the relative gain, at least by `share`.
    const double chi =
      (1.0 - std::max(gain, share)) * EllipticEnergy::Chi(state.MinimumDeterminant, epsilon);
    epsilon = EllipticEnergy::EpsilonFor(state.MinimumDeterminant, chi, MinimumEpsilon);
    result.Negative = problem.CountNegative(x);
    if (result.Negative == 0)
    {
      epsilon = MinimumEpsilon;
      if (before == epsilon && gain < options.LeastGain)
      {
        break;
      }
    }
    if (result.Negative < fewest || state.MinimumDeterminant > lowest + 0.01 * std::abs(lowest))
    {
      fewest = std::min(fewest, result.Negative);
      lowest = std::max(lowest, state.MinimumDeterminant);
      stalled = 0;
    }
    else if (result.Negative > 0 && ++stalled > options.Patience)
    {
      break;
    }
    if (epsilon != before)
    {
      state = problem.Evaluate(x, epsilon);
    }
  }
  result.EnergyAfter = state.Energy;
  return result;
}

PatchResult MinimizeEnergy(Eigen::MatrixXd& points, const SimplexPatch& patch,
  const PointConstraint* constraint, const PatchOptions& options, const Progress& progress)
{
  PatchEnergy problem(points, patch, constraint, progress.Part(0.0, 0.0));
  Eigen::Matrix3Xd x = problem.Start();
  const PatchResult result = MinimizeEnergy(x, problem, options, progress);
  for (std::size_t i = 0; i < patch.FreePoints.size(); ++i)
  {
    points.row(patch.FreePoints[i]) = x.col(static_cast<Eigen::Index>(i)).transpose();
  }
  return result;
}

} // namespace shape
