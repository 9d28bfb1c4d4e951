#include "Parameterize/InjectiveRefinement.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/Orientation.h"
#include "Linear/SparseSolve.h"
#include "Parameterize/Private/PlanarElements.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

constexpr int Grain = 1024; // triangles

/// The contribution of each triangle to the gradient and to the quadratic form of its measure.
struct LocalTerms
{
  std::vector<Eigen::Matrix<double, 3, 2>> Gradients; ///< one row for each corner
  std::vector<Eigen::Matrix2d> Forms;                 ///< area U diag(weights) U'
};

LocalTerms TermsAt(const Eigen::MatrixXd& points, const PlanarElements& elements,
  Distortion distortion, double exponent, const Progress& progress)
{
  const auto count = static_cast<int>(elements.Areas().size());
  LocalTerms terms;
  terms.Gradients.resize(count);
  terms.Forms.resize(count);
  ParallelFor(
    count, Grain,
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        // J = U diag(s) V'. The measure depends on s alone, so its derivative by J is U
        // diag(gradient) V'. The weights belong to the quadratic form of Rabinovich et al. 2017,
        // section 3.2, which has the same gradient.
        const PlanarDecomposition parts = DecomposePlanar(elements.Jacobian(t, points));
        const DistortionTerms measure = EvaluateDistortion(distortion, exponent, parts.Singular);
        const double area = elements.Areas()(t);
        const Eigen::Matrix2d byJacobian =
          parts.U * (area * measure.Gradient).asDiagonal() * parts.V.transpose();
        terms.Gradients[t] = elements.Gradients(t) * byJacobian.transpose();
        terms.Forms[t] = parts.U * (area * measure.Weights).asDiagonal() * parts.U.transpose();
      }
    },
    progress);
  return terms;
}

/// The sum of the triangles' quadratic forms: matrices of one pattern, factorised repeatedly.
class ProxySystem
{
public:
  ProxySystem(const PlanarElements& elements, Eigen::Index points, const std::vector<int>& fixed,
    const Progress& progress)
    : Elements(elements)
    , Rows(points, 0)
  {
    for (const int point : fixed)
    {
      this->Rows[point] = -1;
    }
    if (fixed.empty())
    {
      this->Rows[0] = -1; // The forms are invariant under translation, so one point is fixed.
    }
    for (int& row : this->Rows)
    {
      row = row < 0 ? row : this->Count++;
    }
    this->MakePattern(progress);
  }

  int Unknowns() const { return this->Count; }

  /// Returns the gradient of the sum of measures (unknowns x and y alternate).
  Eigen::VectorXd Gradient(const LocalTerms& terms) const
  {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * this->Count);
    for (Eigen::Index t = 0; t < this->Elements.Triangles().rows(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int row = this->Rows[this->Elements.Triangles()(t, k)];
        if (row >= 0)
        {
          gradient.segment<2>(2 * row) += terms.Gradients[t].row(k).transpose();
        }
      }
    }
    return gradient;
  }

  /// Returns the step to the minimum of the sum of the forms.
  Eigen::VectorXd Direction(
    const LocalTerms& terms, const Eigen::VectorXd& gradient, const Progress& progress)
  {
    this->Assemble(terms);
    this->Solver.Factorize(this->Matrix, progress);
    // The second derivative of the forms is twice their matrix.
    return this->Solver.Solve(-0.5 * gradient);
  }

  /// Converts the unknowns to steps of all points (n x 2).
  Eigen::MatrixXd Spread(const Eigen::VectorXd& unknowns) const
  {
    Eigen::MatrixXd steps = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(this->Rows.size()), 2);
    for (std::size_t i = 0; i < this->Rows.size(); ++i)
    {
      if (this->Rows[i] >= 0)
      {
        steps.row(static_cast<Eigen::Index>(i)) =
          unknowns.segment<2>(2 * this->Rows[i]).transpose();
      }
    }
    return steps;
  }

private:
  /// Calls visit(triangle, k, l, row, column) for every pair of free corners of each triangle.
  template <typename Visit>
  void ForEachBlock(const Visit& visit) const
  {
    const Eigen::MatrixXi& triangles = this->Elements.Triangles();
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        for (int l = 0; l < 3; ++l)
        {
          const int row = this->Rows[triangles(t, k)], column = this->Rows[triangles(t, l)];
          if (row >= 0 && column >= 0)
          {
            visit(t, k, l, row, column);
          }
        }
      }
    }
  }

  /// Finds the index of the first entry of each block in the matrix's values.
  void MakePattern(const Progress& progress)
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(36 * this->Elements.Triangles().rows());
    this->ForEachBlock(
      [&](Eigen::Index, int, int, int row, int column)
      {
        for (int b = 0; b < 2; ++b)
        {
          entries.emplace_back(2 * row, 2 * column + b, 1.0);
          entries.emplace_back(2 * row + 1, 2 * column + b, 1.0);
        }
      });
    progress(0.0);
    this->Matrix.resize(2 * this->Count, 2 * this->Count);
    this->Matrix.setFromTriplets(entries.begin(), entries.end());
    progress(0.0);
    const int* inner = this->Matrix.innerIndexPtr();
    const int* outer = this->Matrix.outerIndexPtr();
    this->ForEachBlock(
      [&](Eigen::Index, int, int, int row, int column)
      {
        const int* end = inner + outer[2 * column + 1];
        const int* position = std::lower_bound(inner + outer[2 * column], end, 2 * row);
        this->Positions.push_back(static_cast<int>(position - inner));
      });
  }

  void Assemble(const LocalTerms& terms)
  {
    double* values = this->Matrix.valuePtr();
    const int* outer = this->Matrix.outerIndexPtr();
    std::fill_n(values, this->Matrix.nonZeros(), 0.0);
    std::size_t next = 0;
    this->ForEachBlock(
      [&](Eigen::Index t, int k, int l, int, int column)
      {
        const Eigen::Matrix<double, 3, 2> gradients = this->Elements.Gradients(t);
        const double product = gradients.row(k).dot(gradients.row(l));
        const int first = this->Positions[next++];
        // Both columns of a block have the same rows.
        const int second = first + outer[2 * column + 1] - outer[2 * column];
        const Eigen::Matrix2d block = product * terms.Forms[t];
        values[first] += block(0, 0);
        values[first + 1] += block(1, 0);
        values[second] += block(0, 1);
        values[second + 1] += block(1, 1);
      });
    // Weights of different triangles may differ so much that the smallest are lost in rounding.
    constexpr double raise = 1e-12;
    for (int i = 0; i < 2 * this->Count; ++i)
    {
      this->Matrix.coeffRef(i, i) *= 1.0 + raise;
    }
  }

  const PlanarElements& Elements;
  std::vector<int> Rows; ///< first of the two unknowns of each point, or -1
  int Count = 0;
  Eigen::SparseMatrix<double> Matrix;
  std::vector<int> Positions; ///< index of each block's first value, in the order of ForEachBlock
  SparseCholesky Solver;
};

void RequireStart(
  const Mesh& surface, const Eigen::MatrixXd& start, const InjectiveRefinementOptions& options)
{
  RequireOption(options.Exponent > 0.0, "Exponent", options.Exponent, "positive");
  RequireOption(options.Scale > 0.0, "Scale", options.Scale, "positive");
  RequireOption(
    options.MaximumIterations >= 0, "MaximumIterations", options.MaximumIterations, "at least 0");
  RequireOption(options.Tolerance >= 0.0 && options.Tolerance < 1.0, "Tolerance", options.Tolerance,
    "in [0, 1)");
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = surface.Triangles.row(t);
    if (EvaluateOrientation(start.row(corners(0)), start.row(corners(1)), start.row(corners(2))) <=
      0)
    {
      throw InvalidInput("triangle " + std::to_string(t) +
        " of the start is not counter-clockwise; start from a convex combination map");
    }
  }
}

/// Halves the step until the energy decreases by a share of the gradient's prediction. Returns
/// false and leaves the points unchanged if it never does.
bool Search(Eigen::MatrixXd& points, double& energy, const Eigen::MatrixXd& steps, double slope,
  const PlanarElements& elements, const InjectiveRefinementOptions& options)
{
  // Armijo's rule with the usual small share.
  constexpr double share = 1e-4;
  // At most 0.8 of the way to the first flip, where the measure is infinite.
  double step = std::min(1.0, 0.8 * elements.LargestStep(points, steps));
  for (int halving = 0; halving < 50; ++halving, step *= 0.5)
  {
    const Eigen::MatrixXd trial = points + step * steps;
    const double value = elements.Energy(trial, options.Measure, options.Exponent);
    if (value <= energy + share * step * slope)
    {
      points = trial;
      energy = value;
      return true;
    }
  }
  return false;
}

/// Descends from `points`, which it overwrites; StartEnergy is left to the caller.
InjectiveRefinementResult Descend(const PlanarElements& elements, ProxySystem& system,
  const Eigen::MatrixXd& start, const InjectiveRefinementOptions& options, const Progress& progress)
{
  // Each iteration (Rabinovich et al. 2017): the local step computes gradients and weights of all
  // triangles, the global step solves one linear system for the direction, and a line search bounds
  // the step so that no triangle flips.
  InjectiveRefinementResult result;
  result.Points = start;
  result.StartEnergy = result.Energy = elements.Energy(start, options.Measure, options.Exponent);
  if (!std::isfinite(result.Energy))
  {
    throw SolveFailure("the measure exceeds double precision at the start; choose a smaller "
                       "exponent, or a measure that is no exponential");
  }
  const double area = elements.Areas().sum();
  // One small gain may be due to a step limited by a single triangle.
  constexpr int patience = 5;
  int smallGains = 0;
  while (result.Iterations < options.MaximumIterations && smallGains < patience)
  {
    // The first iterations gain most.
    const double done = 1.0 - 20.0 / (20.0 + result.Iterations);
    progress(done);
    // Local step.
    const LocalTerms terms = TermsAt(
      result.Points, elements, options.Measure, options.Exponent, progress.Part(done, done));
    const Eigen::VectorXd gradient = system.Gradient(terms);
    // Global step.
    const Eigen::VectorXd direction = system.Direction(
      terms, gradient, progress.Part(done, 1.0 - 20.0 / (21.0 + result.Iterations)));
    const double before = result.Energy;
    ++result.Iterations;
    // Line search. Energy and slope are divided by the area.
    if (!Search(result.Points, result.Energy, system.Spread(direction),
          gradient.dot(direction) / area, elements, options))
    {
      break;
    }
    const bool isSmall = before - result.Energy <= options.Tolerance * before;
    smallGains = isSmall ? smallGains + 1 : 0;
  }
  progress(1.0);
  return result;
}

} // namespace

InjectiveRefinementResult RefineInjectively(const Mesh& surface, const Eigen::MatrixXd& start,
  const std::vector<int>& fixed, const InjectiveRefinementOptions& options,
  const Progress& progress)
{
  progress(0.0);
  RequireStart(surface, start, options);
  progress(0.0);
  const PlanarElements elements(surface, options.Scale);
  progress(0.0);
  ProxySystem system(elements, surface.Points.rows(), fixed, progress.Part(0.0, 0.0));
  progress(0.0);
  if (system.Unknowns() == 0)
  {
    const double energy = elements.Energy(start, options.Measure, options.Exponent);
    return { start, energy, energy, 0 };
  }
  if (!IsExponential(options.Measure))
  {
    return Descend(elements, system, start, options, progress);
  }
  // The exponential measure of a bad start may overflow, so SymmetricDirichlet improves it first.
  InjectiveRefinementOptions gentle = options;
  gentle.Measure = Distortion::SymmetricDirichlet;
  const InjectiveRefinementResult first =
    Descend(elements, system, start, gentle, progress.Part(0.0, 0.5));
  InjectiveRefinementResult result =
    Descend(elements, system, first.Points, options, progress.Part(0.5, 1.0));
  result.Iterations += first.Iterations;
  return result;
}

} // namespace shape
