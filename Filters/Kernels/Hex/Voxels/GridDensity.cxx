#include "Hex/Voxels/GridDensity.h"

#include "Base/Parallel.h"

#include <cmath>

namespace shape
{

Eigen::RowVector3d GridDensity::Velocity(const Eigen::RowVector3d& position) const
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const RefinementSeed& magnifier : this->Seeds)
  {
    const Eigen::RowVector3d off = position - magnifier.Centre;
    const double scaled = off.squaredNorm() / (2.0 * magnifier.Radius * magnifier.Radius);
    constexpr double negligible = 40.0;
    if (scaled < negligible)
    {
      sum += magnifier.Strength * std::exp(-scaled) * off;
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

} // namespace shape
