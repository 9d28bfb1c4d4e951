#include "Hex/Polycube/Private/ConstrainedEnergy.h"

#include "Base/Parallel.h"
#include "Geometry/Orientation.h"
#include "Linear/NewtonSystem.h"
#include "Untangle/MinimizeEnergy.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <vector>

namespace shape
{
namespace
{

/// Sums are taken over ranges of this fixed size, so that they do not depend on the number of
/// threads.
constexpr int EnergyGrain = 1024;
/// Tetrahedra are weighted as if they had at least this fraction of the mean volume.
/// A sliver must resist inversion, too.
constexpr double MinimumWeight = 0.1;

/// The energy of a solid as a function of its unknown coordinates; each is a block of NewtonSystem.
class ConstrainedEnergy : public EnergyProblem
{
public:
  ConstrainedEnergy(
    const WorkingSolid& solid, const ConstrainedCoordinates& tied, const Progress& progress)
    : Solid(solid)
    , Tied(tied)
    , Weights(solid.Tetrahedra.rows())
    , System(std::vector<int>(tied.Count, 1), this->UnknownsOfAll(), 12, progress)
  {
    for (int t = 0; t < solid.Tetrahedra.rows(); ++t)
    {
      const Eigen::Matrix3d edges = this->EdgesOf(t, solid.Points.transpose());
      this->Hats.push_back(ComputeHatGradients(edges));
      this->Weights(t) = edges.determinant();
    }
    this->Weights = (this->Weights / this->Weights.mean()).cwiseMax(MinimumWeight);
    // Weights sum to 1, so the energy of a rotation is 1.
    this->Weights /= this->Weights.sum();
  }

  int CountNegative(const Eigen::Matrix3Xd& x) const override
  {
    int negative = 0;
    for (const auto& c : this->Solid.Tetrahedra.rowwise())
    {
      negative += EvaluateOrientation(x.col(c(0)).transpose(), x.col(c(1)).transpose(),
                    x.col(c(2)).transpose(), x.col(c(3)).transpose()) <= 0;
    }
    return negative;
  }

  State Evaluate(const Eigen::Matrix3Xd& x, double epsilon) const override
  {
    const int count = static_cast<int>(this->Hats.size());
    std::vector<State> parts(count / EnergyGrain + 1);
    ParallelFor(count, EnergyGrain,
      [&](int begin, int end)
      {
        State& sum = parts[begin / EnergyGrain];
        for (int t = begin; t < end; ++t)
        {
          const EllipticEnergy energy(this->JacobianOf(t, x), epsilon);
          sum.Energy += this->Weights(t) * energy.Value();
          sum.MinimumDeterminant = std::min(sum.MinimumDeterminant, energy.Determinant());
        }
      });
    State all;
    for (const State& sum : parts)
    {
      all.Energy += sum.Energy;
      all.MinimumDeterminant = std::min(all.MinimumDeterminant, sum.MinimumDeterminant);
    }
    return all;
  }

  Descent NewtonDirection(
    const Eigen::Matrix3Xd& x, double epsilon, const Progress& progress) override
  {
    const int count = static_cast<int>(this->Hats.size());
    std::vector<Eigen::Matrix<double, 12, 12>> blocks(count);
    std::vector<Eigen::Matrix<double, 12, 1>> slopes(count);
    ParallelFor(
      count, EnergyGrain,
      [&](int begin, int end)
      {
        for (int t = begin; t < end; ++t)
        {
          this->Expand(t, x, epsilon, blocks[t], slopes[t]);
        }
      },
      progress.Part(0.0, 0.3));
    this->System.Clear();
    for (int t = 0; t < count; ++t)
    {
      const std::array<int, 12> unknowns = this->UnknownsOf(t);
      for (int b = 0; b < 12; ++b)
      {
        if (unknowns[b] < 0)
        {
          continue;
        }
        this->System.AddGradient(t, b, slopes[t].segment<1>(b));
        for (int a = 0; a < 12; ++a)
        {
          if (unknowns[a] >= 0)
          {
            this->System.AddCurvature(t, a, b, blocks[t].block<1, 1>(a, b));
          }
        }
      }
    }
    const NewtonSystem::Step step = this->System.Solve({ 1e-10, 1e2 }, progress.Part(0.3, 1.0));
    Descent descent{ Eigen::Matrix3Xd::Zero(3, this->Solid.Points.rows()), step.Slope };
    // Tied coordinates take the same step, and so stay exactly equal; fixed ones take none.
    for (Eigen::Index i = 0; i < this->Tied.Unknowns.size(); ++i)
    {
      const int unknown = this->Tied.Unknowns(i);
      descent.Direction.data()[i] = unknown >= 0 ? step.Values(unknown) : 0.0;
    }
    return descent;
  }

  void Move(Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& direction, double step) const override
  {
    x += step * direction;
  }

private:
  Eigen::Matrix3d EdgesOf(int t, const Eigen::Matrix3Xd& x) const
  {
    const auto c = this->Solid.Tetrahedra.row(t);
    Eigen::Matrix3d edges;
    edges << x.col(c(1)) - x.col(c(0)), x.col(c(2)) - x.col(c(0)), x.col(c(3)) - x.col(c(0));
    return edges;
  }

  Eigen::Matrix3d JacobianOf(int t, const Eigen::Matrix3Xd& x) const
  {
    return this->EdgesOf(t, x) * this->Hats[t].bottomRows<3>();
  }

  std::array<int, 12> UnknownsOf(int t) const
  {
    std::array<int, 12> unknowns;
    for (int i = 0; i < 12; ++i)
    {
      unknowns[i] = this->Tied.Unknowns(3 * this->Solid.Tetrahedra(t, i / 3) + i % 3);
    }
    return unknowns;
  }

  std::vector<int> UnknownsOfAll() const
  {
    std::vector<int> all;
    for (int t = 0; t < static_cast<int>(this->Solid.Tetrahedra.rows()); ++t)
    {
      const std::array<int, 12> unknowns = this->UnknownsOf(t);
      all.insert(all.end(), unknowns.begin(), unknowns.end());
    }
    return all;
  }

  /// The second derivative and gradient with respect to the twelve coordinates of a tetrahedron.
  void Expand(int t, const Eigen::Matrix3Xd& x, double epsilon,
    Eigen::Matrix<double, 12, 12>& block, Eigen::Matrix<double, 12, 1>& slope) const
  {
    const EllipticEnergy energy(this->JacobianOf(t, x), epsilon);
    const Eigen::Matrix<double, 4, 3>& hats = this->Hats[t];
    const auto [identity, mixed, rank] = energy.SecondDerivative();
    // The Jacobian is J = x hats. By the chain rule its second derivative, identity I + mixed (J
    // C^T + C J^T) + rank C C^T with the cofactors C, becomes one of the twelve coordinates in x.
    const Eigen::Matrix<double, 3, 4> slopes = energy.Gradient() * hats.transpose();
    const Eigen::Matrix<double, 3, 4> jacobian = energy.Jacobian() * hats.transpose();
    const Eigen::Matrix<double, 3, 4> cofactors = energy.Cofactors() * hats.transpose();
    const Eigen::Map<const Eigen::Matrix<double, 12, 1>> byJ(jacobian.data());
    const Eigen::Map<const Eigen::Matrix<double, 12, 1>> byC(cofactors.data());
    block.noalias() = byC * (mixed * byJ + rank * byC).transpose();
    block.noalias() += mixed * byJ * byC.transpose();
    for (int a = 0; a < 4; ++a)
    {
      for (int b = 0; b < 4; ++b)
      {
        block.block<3, 3>(3 * a, 3 * b).diagonal().array() +=
          identity * hats.row(a).dot(hats.row(b));
      }
    }
    block *= this->Weights(t);
    slope = this->Weights(t) * Eigen::Map<const Eigen::Matrix<double, 12, 1>>(slopes.data());
  }

  const WorkingSolid& Solid;
  const ConstrainedCoordinates& Tied;
  std::vector<Eigen::Matrix<double, 4, 3>> Hats;
  Eigen::VectorXd Weights;
  NewtonSystem System;
};

} // namespace

PatchResult MinimizeConstrainedEnergy(Eigen::MatrixXd& positions, const WorkingSolid& solid,
  const ConstrainedCoordinates& tied, const PatchOptions& options, const Progress& progress)
{
  ConstrainedEnergy problem(solid, tied, progress.Part(0.0, 0.0));
  Eigen::Matrix3Xd x = positions.transpose();
  const PatchResult result = MinimizeEnergy(x, problem, options, progress);
  positions = x.transpose();
  return result;
}

} // namespace shape
