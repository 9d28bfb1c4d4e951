#include "Volume/SimplexPatch.h"

#include "Core/Errors.h"
#include "Core/Orientation.h"
#include "Core/Parallel.h"
#include "Core/SparseSolve.h"

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace shape
{
namespace
{

constexpr double LeastEpsilon = 1e-10;
/// By which chi of the least determinant falls from step to step.
constexpr double LeastShare = 0.1, GreatestShare = 0.5;
constexpr int Grain = 2048;

/// A patch on points of its own: the free ones first.
class Problem
{
public:
  Problem(
    const Eigen::MatrixXd& points, const SimplexPatch& patch, const PointConstraint* constraint)
    : Patch(patch)
    , Constraint(constraint)
    , FreeCount(static_cast<int>(patch.FreePoints.size()))
  {
    std::unordered_map<int, int> local;
    local.reserve(2 * patch.FreePoints.size());
    for (const int point : patch.FreePoints)
    {
      local.emplace(point, static_cast<int>(local.size()));
    }
    this->Corners.reserve(patch.Simplices.size());
    for (const ReferenceSimplex& simplex : patch.Simplices)
    {
      std::array<int, 4> corners;
      for (int k = 0; k < 4; ++k)
      {
        corners[k] =
          local.emplace(simplex.Corners[k], static_cast<int>(local.size())).first->second;
      }
      this->Corners.push_back(corners);
    }
    this->Start.resize(3, static_cast<Eigen::Index>(local.size()));
    for (const auto& [point, index] : local)
    {
      this->Start.col(index) = points.row(point).transpose();
    }
    this->NumberUnknowns();
    this->MakePattern();
  }

  int CountNegative(const Eigen::Matrix3Xd& x) const
  {
    int negative = 0;
    for (const std::array<int, 4>& c : this->Corners)
    {
      negative += Orientation(x.col(c[0]).transpose(), x.col(c[1]).transpose(),
                    x.col(c[2]).transpose(), x.col(c[3]).transpose()) <= 0;
    }
    return negative;
  }

  struct State
  {
    double Energy = 0.0;
    double LeastDeterminant = std::numeric_limits<double>::max();
  };

  State Evaluate(const Eigen::Matrix3Xd& x, double epsilon) const
  {
    const int count = static_cast<int>(this->Corners.size());
    std::vector<State> parts(count / Grain + 1);
    const auto part = [&](int begin, int end)
    {
      State& sum = parts[begin / Grain];
      for (int i = begin; i < end; ++i)
      {
        const EllipticEnergy energy(this->JacobianOf(i, x), epsilon);
        sum.Energy += energy.Value();
        sum.LeastDeterminant = std::min(sum.LeastDeterminant, energy.Determinant());
      }
    };
    ForAll(count, part);
    State all;
    for (const State& sum : parts)
    {
      all.Energy += sum.Energy;
      all.LeastDeterminant = std::min(all.LeastDeterminant, sum.LeastDeterminant);
    }
    all.Energy /= count;
    return all;
  }

  /// The Newton direction (3 x free points) and by how much it lowers the energy at first.
  struct Descent
  {
    Eigen::Matrix3Xd Direction;
    double Slope = 0.0;
  };

  Descent NewtonDirection(const Eigen::Matrix3Xd& x, double epsilon)
  {
    std::vector<PointDirections> bases(this->FreeCount);
    for (int point = 0; point < this->FreeCount; ++point)
    {
      bases[point] = this->BasisOf(point, x);
    }
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(this->FirstUnknown[this->FreeCount]);
    std::fill_n(this->Matrix.valuePtr(), this->Matrix.nonZeros(), 0.0);
    const double share = 1.0 / static_cast<double>(this->Corners.size());
    for (std::size_t i = 0; i < this->Corners.size(); ++i)
    {
      this->AddSimplex(i, x, epsilon, share, bases, gradient);
    }
    return this->Solve(bases, gradient);
  }

  /// The minimiser of the sum of |J|^2, from which garbage is untangled.
  Eigen::Matrix3Xd Smoothest(const Eigen::Matrix3Xd& x)
  {
    // One step of the same method with an epsilon beside which every determinant is nothing.
    const Descent descent = this->NewtonDirection(x, 1e100);
    Eigen::Matrix3Xd smooth = x;
    this->Move(smooth, descent.Direction, 1.0);
    return smooth;
  }

  void Move(Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& direction, double step) const
  {
    x.leftCols(this->FreeCount) += step * direction;
    for (int point = 0; this->Constraint && point < this->FreeCount; ++point)
    {
      if (this->Width(point) < 3)
      {
        x.col(point) =
          this->Constraint->Nearest(this->Patch.FreePoints[point], x.col(point).transpose())
            .transpose();
      }
    }
  }

  Eigen::Matrix3Xd Start; ///< 3 x local points

private:
  template <typename Body>
  static void ForAll(int count, const Body& body)
  {
    if (count <= Grain)
    {
      body(0, count);
    }
    else
    {
      ParallelFor(count, Grain, body);
    }
  }

  Eigen::Matrix3d JacobianOf(std::size_t simplex, const Eigen::Matrix3Xd& x) const
  {
    const std::array<int, 4>& c = this->Corners[simplex];
    // From differences: the places themselves may be far larger than the simplex.
    Eigen::Matrix3d edges;
    edges << x.col(c[1]) - x.col(c[0]), x.col(c[2]) - x.col(c[0]), x.col(c[3]) - x.col(c[0]);
    return edges * this->Patch.Simplices[simplex].Gradients.bottomRows<3>();
  }

  int Width(int point) const { return this->FirstUnknown[point + 1] - this->FirstUnknown[point]; }

  PointDirections BasisOf(int point, const Eigen::Matrix3Xd& x) const
  {
    return this->Width(point) == 3
      ? PointDirections(Eigen::Matrix3d::Identity())
      : this->Constraint->Directions(this->Patch.FreePoints[point], x.col(point).transpose());
  }

  void NumberUnknowns()
  {
    this->FirstUnknown.resize(this->FreeCount + 1);
    this->FirstUnknown[0] = 0;
    for (int point = 0; point < this->FreeCount; ++point)
    {
      this->FirstUnknown[point + 1] = this->FirstUnknown[point] +
        (this->Constraint ? this->Constraint->Freedom(this->Patch.FreePoints[point]) : 3);
    }
  }

  /// All columns of a point have the same rows: block (u, v) starts at Slots in the first of them.
  void MakePattern()
  {
    std::vector<std::vector<int>> neighbours(this->FreeCount);
    for (const std::array<int, 4>& corners : this->Corners)
    {
      for (const int v : corners)
      {
        for (const int u : corners)
        {
          if (v < this->FreeCount && u < this->FreeCount)
          {
            neighbours[v].push_back(u);
          }
        }
      }
    }
    const int unknowns = this->FirstUnknown[this->FreeCount];
    this->Matrix.resize(unknowns, unknowns);
    std::vector<int> rows;
    for (int v = 0; v < this->FreeCount; ++v)
    {
      std::vector<int>& all = neighbours[v];
      std::sort(all.begin(), all.end());
      all.erase(std::unique(all.begin(), all.end()), all.end());
      rows.clear();
      for (const int u : all)
      {
        for (int i = this->FirstUnknown[u]; i < this->FirstUnknown[u + 1]; ++i)
        {
          rows.push_back(i);
        }
      }
      this->ColumnLengths.push_back(static_cast<int>(rows.size()));
      for (int k = 0; k < this->Width(v); ++k)
      {
        const int column = this->FirstUnknown[v] + k;
        this->Inner.insert(this->Inner.end(), rows.begin(), rows.end());
        this->Matrix.outerIndexPtr()[column + 1] = static_cast<int>(this->Inner.size());
      }
    }
    this->Matrix.resizeNonZeros(static_cast<Eigen::Index>(this->Inner.size()));
    std::copy(this->Inner.begin(), this->Inner.end(), this->Matrix.innerIndexPtr());
    this->Inner = {};
    this->Slots.resize(this->Corners.size());
    for (std::size_t i = 0; i < this->Corners.size(); ++i)
    {
      const std::array<int, 4>& c = this->Corners[i];
      for (int b = 0; b < 4; ++b)
      {
        for (int a = 0; a < 4; ++a)
        {
          this->Slots[i][4 * b + a] = -1;
          if (c[a] < this->FreeCount && c[b] < this->FreeCount)
          {
            const int* first =
              this->Matrix.innerIndexPtr() + this->Matrix.outerIndexPtr()[this->FirstUnknown[c[b]]];
            const int* found =
              std::lower_bound(first, first + this->ColumnLengths[c[b]], this->FirstUnknown[c[a]]);
            this->Slots[i][4 * b + a] = static_cast<int>(found - first);
          }
        }
      }
    }
  }

  void AddSimplex(std::size_t i, const Eigen::Matrix3Xd& x, double epsilon, double share,
    const std::vector<PointDirections>& bases, Eigen::VectorXd& gradient)
  {
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
      gradient.segment(this->FirstUnknown[c[b]], this->Width(c[b])) +=
        bases[c[b]].transpose() * slopes.col(b);
      for (int a = 0; a < 4; ++a)
      {
        const int slot = this->Slots[i][4 * b + a];
        if (slot < 0)
        {
          continue;
        }
        Eigen::Matrix3d block =
          mixed * (byJ.col(a) * byC.col(b).transpose() + byC.col(a) * byJ.col(b).transpose()) +
          rank * byC.col(a) * byC.col(b).transpose();
        block.diagonal().array() += identity * hats.row(a).dot(hats.row(b));
        block *= share;
        const int column = this->FirstUnknown[c[b]];
        if (this->Width(c[a]) == 3 && this->Width(c[b]) == 3)
        {
          this->Scatter(column, slot, block);
        }
        else
        {
          this->Scatter(column, slot, bases[c[a]].transpose() * block * bases[c[b]]);
        }
      }
    }
  }

  void Scatter(int column, int slot, const Eigen::Ref<const Eigen::MatrixXd>& block)
  {
    for (Eigen::Index k = 0; k < block.cols(); ++k)
    {
      double* values = this->Matrix.valuePtr() + this->Matrix.outerIndexPtr()[column + k] + slot;
      for (Eigen::Index j = 0; j < block.rows(); ++j)
      {
        values[j] += block(j, k);
      }
    }
  }

  Descent Solve(const std::vector<PointDirections>& bases, const Eigen::VectorXd& gradient)
  {
    // Unknowns in units of their own, so that a ridge means the same to all of them.
    const Eigen::VectorXd diagonal = this->Matrix.diagonal();
    const double greatest = diagonal.maxCoeff();
    const Eigen::VectorXd scale =
      diagonal.array().max(1e-300 + 1e-30 * greatest).sqrt().inverse().matrix();
    for (int column = 0; column < this->Matrix.cols(); ++column)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(this->Matrix, column); entry; ++entry)
      {
        entry.valueRef() *= scale(column) * scale(entry.row());
      }
    }
    Descent descent;
    descent.Direction = Eigen::Matrix3Xd::Zero(3, this->FreeCount);
    for (double ridge = 1e-12; ridge < 1.0; ridge *= 1e3)
    {
      this->Matrix.diagonal().array() += ridge;
      try
      {
        this->Cholesky.Factorize(this->Matrix);
      }
      catch (const SolveFailure&)
      {
        continue;
      }
      const Eigen::VectorXd step =
        -scale.cwiseProduct(this->Cholesky.Solve(scale.cwiseProduct(gradient)).col(0));
      if (!step.allFinite())
      {
        continue;
      }
      descent.Slope = -step.dot(gradient);
      for (int point = 0; point < this->FreeCount; ++point)
      {
        descent.Direction.col(point) =
          bases[point] * step.segment(this->FirstUnknown[point], this->Width(point));
      }
      break;
    }
    return descent;
  }

  const SimplexPatch& Patch;
  const PointConstraint* Constraint;
  int FreeCount;
  std::vector<std::array<int, 4>> Corners;
  std::vector<std::array<int, 16>> Slots;
  std::vector<int> FirstUnknown, ColumnLengths, Inner;
  Eigen::SparseMatrix<double> Matrix;
  SparseCholesky Cholesky;
};

} // namespace

PatchResult LowerEnergy(Eigen::MatrixXd& points, const SimplexPatch& patch,
  const PointConstraint* constraint, const PatchOptions& options, const Progress& progress)
{
  Problem problem(points, patch, constraint);
  Eigen::Matrix3Xd x = problem.Start;
  PatchResult result;
  result.Negative = problem.CountNegative(x);
  double epsilon = result.Negative > 0 ? 1.0 : LeastEpsilon;
  Problem::State state = problem.Evaluate(x, epsilon);
  if (result.Negative > 0)
  {
    Eigen::Matrix3Xd smooth = problem.Smoothest(x);
    const Problem::State other = problem.Evaluate(smooth, epsilon);
    if (other.Energy < state.Energy)
    {
      x = std::move(smooth);
      state = other;
      result.Negative = problem.CountNegative(x);
    }
  }
  result.EnergyBefore = state.Energy;
  int further = 0;
  double share = LeastShare;
  Eigen::Matrix3Xd trial;
  for (; result.Steps < options.MaximumSteps; ++result.Steps)
  {
    progress(static_cast<double>(result.Steps) / options.MaximumSteps);
    if (result.Negative == 0 && further >= options.FurtherSteps)
    {
      break;
    }
    further += result.Negative == 0;
    const auto descent = problem.NewtonDirection(x, epsilon);
    Problem::State next;
    double step = 1.0;
    for (; step > 1e-9; step *= 0.5)
    {
      trial = x;
      problem.Move(trial, descent.Direction, step);
      next = problem.Evaluate(trial, epsilon);
      const bool valid = epsilon > LeastEpsilon || next.LeastDeterminant > 0.0;
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
    // Whole steps that gain little mean that the minimiser for this epsilon is near: go faster.
    if (step == 1.0 && gain < 0.05)
    {
      share = std::min(1.3 * share, GreatestShare);
    }
    else if (step < 1.0)
    {
      share = std::max(0.5 * share, LeastShare);
    }
    const double chi =
      (1.0 - std::max(gain, share)) * EllipticEnergy::Chi(state.LeastDeterminant, epsilon);
    epsilon = EllipticEnergy::EpsilonFor(state.LeastDeterminant, chi, LeastEpsilon);
    result.Negative = problem.CountNegative(x);
    if (result.Negative == 0)
    {
      epsilon = LeastEpsilon;
      if (before == epsilon && gain < options.LeastGain)
      {
        break;
      }
    }
    if (epsilon != before)
    {
      state = problem.Evaluate(x, epsilon);
    }
  }
  result.EnergyAfter = state.Energy;
  for (std::size_t i = 0; i < patch.FreePoints.size(); ++i)
  {
    points.row(patch.FreePoints[i]) = x.col(static_cast<Eigen::Index>(i)).transpose();
  }
  return result;
}

} // namespace shape
