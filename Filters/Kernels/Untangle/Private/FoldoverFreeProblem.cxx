#include "Untangle/Private/FoldoverFreeProblem.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/Orientation.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace shape
{
namespace
{

constexpr int Grain = 2048;

template <typename Body>
void ForAll(int count, const Body& body)
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

} // namespace

FoldoverFreeProblem::FoldoverFreeProblem(
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
      corners[k] = local.emplace(simplex.Corners[k], static_cast<int>(local.size())).first->second;
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

int FoldoverFreeProblem::CountNegative(const Eigen::Matrix3Xd& x) const
{
  int negative = 0;
  for (const std::array<int, 4>& c : this->Corners)
  {
    negative += EvaluateOrientation(x.col(c[0]).transpose(), x.col(c[1]).transpose(),
                  x.col(c[2]).transpose(), x.col(c[3]).transpose()) <= 0;
  }
  return negative;
}

FoldoverFreeProblem::State FoldoverFreeProblem::Evaluate(
  const Eigen::Matrix3Xd& x, double epsilon) const
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
      sum.MinimumDeterminant = std::min(sum.MinimumDeterminant, energy.Determinant());
    }
  };
  ForAll(count, part);
  State all;
  for (const State& sum : parts)
  {
    all.Energy += sum.Energy;
    all.MinimumDeterminant = std::min(all.MinimumDeterminant, sum.MinimumDeterminant);
  }
  all.Energy /= count;
  return all;
}

FoldoverFreeProblem::Descent FoldoverFreeProblem::NewtonDirection(
  const Eigen::Matrix3Xd& x, double epsilon)
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

void FoldoverFreeProblem::Move(
  Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& direction, double step) const
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

Eigen::Matrix3d FoldoverFreeProblem::JacobianOf(
  std::size_t simplex, const Eigen::Matrix3Xd& x) const
{
  const std::array<int, 4>& c = this->Corners[simplex];
  // From differences: the places themselves may be far larger than the simplex.
  Eigen::Matrix3d edges;
  edges << x.col(c[1]) - x.col(c[0]), x.col(c[2]) - x.col(c[0]), x.col(c[3]) - x.col(c[0]);
  return edges * this->Patch.Simplices[simplex].Gradients.bottomRows<3>();
}

PointDirections FoldoverFreeProblem::BasisOf(int point, const Eigen::Matrix3Xd& x) const
{
  return this->Width(point) == 3
    ? PointDirections(Eigen::Matrix3d::Identity())
    : this->Constraint->Directions(this->Patch.FreePoints[point], x.col(point).transpose());
}

void FoldoverFreeProblem::NumberUnknowns()
{
  this->FirstUnknown.resize(this->FreeCount + 1);
  this->FirstUnknown[0] = 0;
  for (int point = 0; point < this->FreeCount; ++point)
  {
    this->FirstUnknown[point + 1] = this->FirstUnknown[point] +
      (this->Constraint ? this->Constraint->Freedom(this->Patch.FreePoints[point]) : 3);
  }
}

void FoldoverFreeProblem::MakePattern()
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
  std::vector<int> rows, inner;
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
      inner.insert(inner.end(), rows.begin(), rows.end());
      this->Matrix.outerIndexPtr()[column + 1] = static_cast<int>(inner.size());
    }
  }
  this->Matrix.resizeNonZeros(static_cast<Eigen::Index>(inner.size()));
  std::copy(inner.begin(), inner.end(), this->Matrix.innerIndexPtr());
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

void FoldoverFreeProblem::AddSimplex(std::size_t i, const Eigen::Matrix3Xd& x, double epsilon,
  double share, const std::vector<PointDirections>& bases, Eigen::VectorXd& gradient)
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

void FoldoverFreeProblem::Scatter(
  int column, int slot, const Eigen::Ref<const Eigen::MatrixXd>& block)
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

FoldoverFreeProblem::Descent FoldoverFreeProblem::Solve(
  const std::vector<PointDirections>& bases, const Eigen::VectorXd& gradient)
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

} // namespace shape
