#include "Distortion/InjectiveRefinement.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/Orientation.h"
#include "Linear/NewtonSystem.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

constexpr int TermsGrain = 1024; // simplices

/// The directions in which a point may move, one per column.
template <int D>
using Directions = Eigen::Matrix<double, D, Eigen::Dynamic, 0, D, D>;

template <int D>
using DirectionsBlock = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, D, D>;

/// The contribution of each simplex to the gradient and to the quadratic form of its measure.
template <int D>
struct LocalTerms
{
  std::vector<Eigen::Matrix<double, D + 1, D>> Gradients; ///< one row for each corner
  std::vector<Eigen::Matrix<double, D, D>> Forms;         ///< size U diag(weights) U'
};

template <int D>
LocalTerms<D> TermsAt(const Eigen::MatrixXd& points, const SimplexElements<D>& elements,
  const InjectiveRefinementOptions& options, const Progress& progress)
{
  using Square = Eigen::Matrix<double, D, D>;
  const auto count = static_cast<int>(elements.Count());
  LocalTerms<D> terms;
  terms.Gradients.resize(count);
  terms.Forms.resize(count);
  ParallelFor(
    count, TermsGrain,
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        // J = U diag(s) V'. The measure depends on s alone, so its derivative by J is U
        // diag(gradient) V'. The weights belong to the quadratic form of Rabinovich et al. 2017,
        // section 3.2, which has the same gradient.
        const PositiveDecomposition<D> parts = DecomposePositive(elements.Jacobian(t, points));
        const DistortionTerms<D> measure =
          EvaluateDistortion(options.Measure, options.Exponent, parts.Singular);
        const double size = elements.Sizes()(t);
        const Square byJacobian =
          parts.U * (size * measure.Gradient).asDiagonal() * parts.V.transpose();
        terms.Gradients[t] = elements.HatGradients(t) * byJacobian.transpose();
        terms.Forms[t] = parts.U * (size * measure.Weights).asDiagonal() * parts.U.transpose();
      }
    },
    progress);
  return terms;
}

/// Descends without inverting a simplex.
template <int D>
class Descent
{
public:
  Descent(
    const SimplexElements<D>& elements, const PointMotion<D>& motion, const Progress& progress)
    : Elements(elements)
    , Motion(motion)
    , System(FindWidths(elements, motion), FindBlocks(elements, motion), D + 1, progress)
  {
  }

  /// Descends from `start`; StartEnergy is left to the caller.
  InjectiveRefinementResult From(const Eigen::MatrixXd& start,
    const InjectiveRefinementOptions& options, const Progress& progress);

private:
  using Row = Eigen::Matrix<double, 1, D>;

  static std::vector<int> FindWidths(
    const SimplexElements<D>& elements, const PointMotion<D>& motion)
  {
    std::vector<int> widths(motion.Freedom.size(), 0);
    for (const int point : elements.Simplices().reshaped())
    {
      widths[point] = motion.Freedom[point];
    }
    return widths;
  }

  static std::vector<int> FindBlocks(
    const SimplexElements<D>& elements, const PointMotion<D>& motion)
  {
    std::vector<int> blocks;
    blocks.reserve(elements.Simplices().size());
    for (Eigen::Index t = 0; t < elements.Count(); ++t)
    {
      for (const int point : elements.Simplices().row(t))
      {
        blocks.push_back(motion.Freedom[point] > 0 ? point : -1);
      }
    }
    return blocks;
  }

  Directions<D> DirectionsOf(int point, const Eigen::MatrixXd& points) const
  {
    if (this->Motion.Freedom[point] == D)
    {
      return Eigen::Matrix<double, D, D>::Identity();
    }
    return this->Motion.Directions(point, points.row(point));
  }

  /// Returns the steps of all points (n x D) to the minimum of the quadratic forms. slope: the rate
  /// at which the energy falls along them.
  Eigen::MatrixXd FindSteps(const LocalTerms<D>& terms, const Eigen::MatrixXd& points,
    double& slope, const Progress& progress);

  /// Halves the step until the energy decreases by a share of the gradient's prediction. Returns
  /// false and leaves the points unchanged if it never does.
  bool Search(Eigen::MatrixXd& points, double& energy, const Eigen::MatrixXd& steps, double slope,
    const InjectiveRefinementOptions& options) const;

  const SimplexElements<D>& Elements;
  const PointMotion<D>& Motion;
  NewtonSystem System;
};

template <int D>
Eigen::MatrixXd Descent<D>::FindSteps(const LocalTerms<D>& terms, const Eigen::MatrixXd& points,
  double& slope, const Progress& progress)
{
  const auto count = static_cast<int>(points.rows());
  std::vector<Directions<D>> directions(count);
  for (int point = 0; point < count; ++point)
  {
    if (this->System.Width(point) > 0)
    {
      directions[point] = this->DirectionsOf(point, points);
    }
  }
  this->System.Clear();
  for (int t = 0; t < this->Elements.Count(); ++t)
  {
    const auto corners = this->Elements.Simplices().row(t);
    const typename SimplexElements<D>::Gradient gradients = this->Elements.HatGradients(t);
    for (int l = 0; l <= D; ++l)
    {
      if (this->System.Width(corners(l)) == 0)
      {
        continue;
      }
      this->System.AddGradient(
        t, l, directions[corners(l)].transpose() * terms.Gradients[t].row(l).transpose());
      for (int k = 0; k <= D; ++k)
      {
        if (this->System.Width(corners(k)) > 0)
        {
          // The second derivative of a form is twice its matrix.
          const double product = 2.0 * gradients.row(k).dot(gradients.row(l));
          const DirectionsBlock<D> block =
            product * directions[corners(k)].transpose() * terms.Forms[t] * directions[corners(l)];
          this->System.AddCurvature(t, k, l, block);
        }
      }
    }
  }
  // Weights of different simplices may differ so much that the smallest are lost in rounding.
  const NewtonSystem::Step step = this->System.Solve({ 1e-12, 1e3 }, progress);
  slope = step.Slope;
  Eigen::MatrixXd steps = Eigen::MatrixXd::Zero(count, D);
  for (int point = 0; point < count; ++point)
  {
    if (this->System.Width(point) > 0)
    {
      steps.row(point) = (directions[point] * step.Of(this->System, point)).transpose();
    }
  }
  return steps;
}

template <int D>
bool Descent<D>::Search(Eigen::MatrixXd& points, double& energy, const Eigen::MatrixXd& steps,
  double slope, const InjectiveRefinementOptions& options) const
{
  // Armijo's rule with the usual small share.
  constexpr double share = 1e-4;
  // At most 0.8 of the way to the first flip, where the measure is infinite.
  double step = std::min(1.0, 0.8 * this->Elements.LargestStep(points, steps));
  for (int halving = 0; halving < 50; ++halving, step *= 0.5)
  {
    Eigen::MatrixXd trial = points + step * steps;
    for (int point = 0; point < trial.rows(); ++point)
    {
      const int width = this->System.Width(point);
      if (width > 0 && width < D)
      {
        trial.row(point) = this->Motion.Nearest(point, trial.row(point));
      }
    }
    const double value = this->Elements.Energy(trial, options.Measure, options.Exponent);
    if (value <= energy - share * step * slope)
    {
      points = std::move(trial);
      energy = value;
      return true;
    }
  }
  return false;
}

template <int D>
InjectiveRefinementResult Descent<D>::From(
  const Eigen::MatrixXd& start, const InjectiveRefinementOptions& options, const Progress& progress)
{
  // Each iteration (Rabinovich et al. 2017): the local step computes gradients and weights of all
  // simplices, the global step solves one linear system for the direction, and a line search bounds
  // the step so that no simplex is inverted.
  InjectiveRefinementResult result;
  result.Points = start;
  result.StartEnergy = result.Energy =
    this->Elements.Energy(start, options.Measure, options.Exponent);
  if (!std::isfinite(result.Energy))
  {
    throw SolveFailure("the measure exceeds double precision at the start; choose a smaller "
                       "exponent, or a measure that is no exponential");
  }
  const double size = this->Elements.Sizes().sum();
  // One small gain may be due to a step limited by a single simplex.
  constexpr int patience = 5;
  int smallGains = 0;
  while (result.Iterations < options.MaximumIterations && smallGains < patience)
  {
    // The first iterations gain most.
    const double done = 1.0 - 20.0 / (20.0 + result.Iterations);
    progress(done);
    // Local step.
    const LocalTerms<D> terms =
      TermsAt(result.Points, this->Elements, options, progress.Part(done, done));
    // Global step.
    double slope = 0.0;
    const Eigen::MatrixXd steps = this->FindSteps(
      terms, result.Points, slope, progress.Part(done, 1.0 - 20.0 / (21.0 + result.Iterations)));
    const double before = result.Energy;
    ++result.Iterations;
    // Line search. The energy is divided by the size, so the slope is, too.
    if (!this->Search(result.Points, result.Energy, steps, slope / size, options))
    {
      break;
    }
    const bool isSmall = before - result.Energy <= options.Tolerance * before;
    smallGains = isSmall ? smallGains + 1 : 0;
  }
  progress(1.0);
  return result;
}

void RequireOptions(const InjectiveRefinementOptions& options)
{
  RequireOption(options.Exponent > 0.0, "Exponent", options.Exponent, "positive");
  RequireOption(options.Scale > 0.0, "Scale", options.Scale, "positive");
  RequireOption(
    options.MaximumIterations >= 0, "MaximumIterations", options.MaximumIterations, "at least 0");
  RequireOption(options.Tolerance >= 0.0 && options.Tolerance < 1.0, "Tolerance", options.Tolerance,
    "in [0, 1)");
}

} // namespace

Distortion GetMeasure(RefineType refine)
{
  // The enumerations have the same order, but for None.
  return static_cast<Distortion>(static_cast<int>(refine) - 1);
}

template <int Dimension>
InjectiveRefinementResult RefineInjectively(const SimplexElements<Dimension>& elements,
  const Eigen::MatrixXd& start, const PointMotion<Dimension>& motion,
  const InjectiveRefinementOptions& options, const Progress& progress)
{
  RequireOptions(options);
  progress(0.0);
  if (std::all_of(motion.Freedom.begin(), motion.Freedom.end(), [](int f) { return f == 0; }))
  {
    const double energy = elements.Energy(start, options.Measure, options.Exponent);
    return { start, energy, energy, 0 };
  }
  Descent<Dimension> descent(elements, motion, progress.Part(0.0, 0.0));
  if (!IsExponential(options.Measure))
  {
    return descent.From(start, options, progress);
  }
  // The exponential measure of a bad start may overflow, so SymmetricDirichlet improves it first.
  InjectiveRefinementOptions gentle = options;
  gentle.Measure = Distortion::SymmetricDirichlet;
  const InjectiveRefinementResult first = descent.From(start, gentle, progress.Part(0.0, 0.5));
  InjectiveRefinementResult result = descent.From(first.Points, options, progress.Part(0.5, 1.0));
  result.Iterations += first.Iterations;
  return result;
}

template InjectiveRefinementResult RefineInjectively<2>(const SimplexElements<2>&,
  const Eigen::MatrixXd&, const PointMotion<2>&, const InjectiveRefinementOptions&,
  const Progress&);
template InjectiveRefinementResult RefineInjectively<3>(const SimplexElements<3>&,
  const Eigen::MatrixXd&, const PointMotion<3>&, const InjectiveRefinementOptions&,
  const Progress&);

InjectiveRefinementResult RefineInjectively(const Mesh& surface, const Eigen::MatrixXd& start,
  const std::vector<int>& fixed, const InjectiveRefinementOptions& options,
  const Progress& progress)
{
  RequireOptions(options);
  const std::vector<int> flipped = FindInvertedTriangles(surface.Triangles, start);
  if (!flipped.empty())
  {
    throw InvalidInput("triangle " + std::to_string(flipped.front()) +
      " of the start is not counter-clockwise; start from a convex combination map");
  }
  PointMotion<2> motion;
  motion.Freedom.assign(surface.Points.rows(), 2);
  for (const int point : fixed)
  {
    motion.Freedom[point] = 0;
  }
  if (fixed.empty())
  {
    motion.Freedom[0] = 0; // The forms are invariant under translation.
  }
  progress(0.0);
  const SimplexElements<2> elements = BuildTriangleElements(surface, options.Scale);
  return RefineInjectively<2>(elements, start, motion, options, progress);
}

} // namespace shape
