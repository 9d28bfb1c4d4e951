#include "Hex/Voxels/GridDensity.h"

#include "Base/Parallel.h"
#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shape
{

Eigen::RowVector3d GridDensity::Velocity(const Eigen::RowVector3d& position) const
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const RefinementSeed& seed : this->Seeds)
  {
    const Eigen::RowVector3d off = position - seed.Centre;
    const double scaled = off.squaredNorm() / (2.0 * seed.Radius * seed.Radius);
    // exp(-40) = 4e-18: below the rounding of 1.
    constexpr double negligible = 40.0;
    if (scaled < negligible)
    {
      sum += seed.Strength * std::exp(-scaled) * off;
    }
  }
  return sum;
}

Eigen::MatrixXd GridDensity::Flow(const Eigen::MatrixXd& points, double time) const
{
  Eigen::MatrixXd moved = points;
  if (this->Seeds.empty())
  {
    return moved;
  }
  constexpr int steps = 8; // of the classical Runge-Kutta method
  const double step = time / steps;
  ParallelFor(static_cast<int>(points.rows()), 256,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        Eigen::RowVector3d x = points.row(i);
        for (int k = 0; k < steps; ++k)
        {
          const Eigen::RowVector3d a = this->Velocity(x), b = this->Velocity(x + 0.5 * step * a);
          const Eigen::RowVector3d c = this->Velocity(x + 0.5 * step * b);
          const Eigen::RowVector3d d = this->Velocity(x + step * c);
          x += step / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        }
        moved.row(i) = x;
      }
    });
  return moved;
}

namespace
{

constexpr double Radius = 2.5; // of a seed, in cells

} // namespace

void RefinementSeeds::Add(const Eigen::RowVector3d& centre, double times)
{
  constexpr double strength = 0.4, apart = 1.5; // radii
  if (std::none_of(this->Gathered.begin(), this->Gathered.end(),
        [&](const RefinementSeed& other)
        { return (other.Centre - centre).norm() < apart * other.Radius; }))
  {
    this->Gathered.push_back({ centre, Radius * this->CellSize, times * strength });
  }
}

void RefinementSeeds::AddDistant(const SampledDistances& far, double wanted)
{
  std::vector<int> order(far.Distances.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return far.Distances(a) > far.Distances(b); });
  for (const int i : order)
  {
    if (far.Distances(i) < DistantShare * wanted)
    {
      break;
    }
    // Positions more than four times too far would otherwise need too many rounds.
    constexpr double maximum = 2.0;
    this->Add(
      far.Positions.row(i), std::clamp(std::log2(0.5 * far.Distances(i) / wanted), 1.0, maximum));
  }
}

void RefinementSeeds::AddBad(const HexMesh& mesh, double accepted)
{
  const Eigen::VectorXd quality = ComputeScaledJacobians(mesh);
  for (Eigen::Index hex = 0; hex < quality.size(); ++hex)
  {
    if (quality(hex) < accepted)
    {
      this->Add(mesh.Points(mesh.Hexahedra.row(hex), Eigen::all).colwise().mean());
    }
  }
}

bool RefinementSeeds::AreMostOf(Eigen::Index cells) const
{
  constexpr double pi = 3.14159265358979324, maximum = 0.3; // of the cells
  const double magnified = 4.0 / 3.0 * pi * Radius * Radius * Radius;
  return magnified * static_cast<double>(this->Gathered.size()) >
    maximum * static_cast<double>(cells);
}

} // namespace shape
