#include "Labels/Private/RegionVolumes.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The volumes are right after a few steps of Newton's method, because the motion is small.
constexpr int Steps = 8;
/// Relative error of a volume that needs no further step.
constexpr double Tolerance = 1e-6;

/// Weight of a region whose points cannot move, relative to the mean of all regions.
constexpr double Ridge = 1e-10;

/// The gradient of the volume of a region with respect to a point.
struct Gradient
{
  int Region;
  Eigen::RowVector3d Value;
};

using Held = Eigen::Array<bool, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// The gradients at each point, and the area that belongs to it.
struct Gradients
{
  std::vector<std::vector<Gradient>> At;
  Eigen::VectorXd Areas;
};

/// held: coordinates that cannot change.
Gradients FindGradients(const SurfaceNet& net, const std::map<int, int>& indexOf, const Held& held)
{
  Gradients gradients;
  gradients.At.resize(net.Points.rows());
  gradients.Areas = Eigen::VectorXd::Zero(net.Points.rows());
  for (Eigen::Index t = 0; t < net.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = net.Triangles.row(t);
    const Eigen::RowVector3d a = net.Points.row(corners(0));
    const Eigen::RowVector3d toB = net.Points.row(corners(1)) - a;
    const Eigen::RowVector3d toC = net.Points.row(corners(2)) - a;
    const Eigen::RowVector3d third = toB.cross(toC) / 6.0; // a third of the area vector
    for (const int corner : corners)
    {
      gradients.Areas(corner) += third.norm();
      for (int side = 0; side < 2; ++side)
      {
        const auto region = indexOf.find(net.Regions(t, side));
        if (region == indexOf.end())
        {
          continue; // the outside
        }
        std::vector<Gradient>& own = gradients.At[corner];
        auto known = std::find_if(own.begin(), own.end(),
          [&](const Gradient& gradient) { return gradient.Region == region->second; });
        if (known == own.end())
        {
          known = own.insert(own.end(), { region->second, Eigen::RowVector3d::Zero() });
        }
        known->Value += side == 0 ? third : -third;
      }
    }
  }
  for (Eigen::Index i = 0; i < net.Points.rows(); ++i)
  {
    for (Gradient& gradient : gradients.At[i])
    {
      gradient.Value = held.row(i).select(0.0, gradient.Value.array());
    }
  }
  return gradients;
}

/// Returns the multiples of the gradients whose sum changes the volumes by `missing`.
Eigen::VectorXd SolvePressures(const Gradients& gradients, const Eigen::VectorXd& missing)
{
  std::map<std::pair<int, int>, double> couplings;
  for (std::size_t i = 0; i < gradients.At.size(); ++i)
  {
    const double area = gradients.Areas(static_cast<Eigen::Index>(i));
    for (const Gradient& row : gradients.At[i])
    {
      for (const Gradient& column : gradients.At[i])
      {
        if (area > 0.0)
        {
          couplings[{ row.Region, column.Region }] += row.Value.dot(column.Value) / area;
        }
      }
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  double trace = 0.0;
  for (const auto& [at, value] : couplings)
  {
    entries.emplace_back(at.first, at.second, value);
    trace += at.first == at.second ? value : 0.0;
  }
  const Eigen::Index regions = missing.size();
  for (int i = 0; i < static_cast<int>(regions); ++i)
  {
    entries.emplace_back(i, i, Ridge * (trace / static_cast<double>(regions) + 1.0));
  }
  Eigen::SparseMatrix<double> matrix(regions, regions);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  return solver.solve(missing);
}

} // namespace

std::map<int, double> ComputeRegionVolumes(const SurfaceNet& net)
{
  std::map<int, double> volumes;
  for (Eigen::Index t = 0; t < net.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = net.Points.row(net.Triangles(t, 0));
    const Eigen::RowVector3d b = net.Points.row(net.Triangles(t, 1));
    const Eigen::RowVector3d c = net.Points.row(net.Triangles(t, 2));
    const double volume = a.dot(b.cross(c)) / 6.0;
    volumes[net.Regions(t, 0)] += volume;
    volumes[net.Regions(t, 1)] -= volume;
  }
  volumes.erase(0);
  return volumes;
}

void RestoreVolumes(SurfaceNet& net, const std::map<int, double>& volumes)
{
  std::map<int, int> indexOf;
  for (const auto& [label, volume] : volumes)
  {
    indexOf.emplace(label, static_cast<int>(indexOf.size()));
  }
  const auto regions = static_cast<Eigen::Index>(indexOf.size());
  Held held = Held::Constant(net.Points.rows(), 3, false);
  for (int step = 0; step < Steps; ++step)
  {
    const std::map<int, double> present = ComputeRegionVolumes(net);
    Eigen::VectorXd missing(regions);
    double worst = 0.0;
    for (const auto& [label, volume] : volumes)
    {
      const auto found = present.find(label);
      missing(indexOf.at(label)) = found == present.end() ? 0.0 : volume - found->second;
      worst = std::max(worst, std::abs(missing(indexOf.at(label))) / volume);
    }
    if (worst <= Tolerance)
    {
      return;
    }
    const Gradients gradients = FindGradients(net, indexOf, held);
    const Eigen::VectorXd pressures = SolvePressures(gradients, missing);
    for (Eigen::Index i = 0; i < net.Points.rows(); ++i)
    {
      const Eigen::RowVector3d centre = net.Centres.row(i);
      Eigen::RowVector3d offset = net.Points.row(i) - centre;
      for (const Gradient& gradient : gradients.At[i])
      {
        if (gradients.Areas(i) > 0.0)
        {
          offset += pressures(gradient.Region) / gradients.Areas(i) * gradient.Value;
        }
      }
      held.row(i) = held.row(i) || offset.array().abs() > net.Reach(i);
      net.Points.row(i) = centre + offset.cwiseMax(-net.Reach(i)).cwiseMin(net.Reach(i));
    }
  }
}

} // namespace shape
