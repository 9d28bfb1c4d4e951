#pragma once

#include "Mesh/Mesh.h"
#include "Solids/IsoSurface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

// Solids with limbs, for the tests of skeletons.
namespace shapetest
{

/// A rounded cone around the segment from Begin to End.
struct Limb
{
  Eigen::RowVector3d Begin, End;
  double BeginRadius, EndRadius;

  /// The distance from the capsule whose radius is that of the nearest place on the segment.
  double Distance(const Eigen::RowVector3d& point) const
  {
    const Eigen::RowVector3d axis = this->End - this->Begin;
    const double t = std::clamp((point - this->Begin).dot(axis) / axis.squaredNorm(), 0.0, 1.0);
    return (point - this->Begin - t * axis).norm() - this->BeginRadius -
      t * (this->EndRadius - this->BeginRadius);
  }
};

/// Returns the surface of the union of limbs, from samples of their distances on a grid.
inline shape::Mesh Union(const std::vector<Limb>& limbs, double spacing)
{
  Eigen::AlignedBox3d box;
  for (const Limb& limb : limbs)
  {
    const double margin = std::max(limb.BeginRadius, limb.EndRadius) + 2.0 * spacing;
    for (const Eigen::RowVector3d& end : { limb.Begin, limb.End })
    {
      box.extend(Eigen::Vector3d(end.transpose().array() - margin));
      box.extend(Eigen::Vector3d(end.transpose().array() + margin));
    }
  }
  shape::SampledGrid grid;
  // Off the symmetry planes of the shapes, so that no grid point is on a surface.
  grid.Origin = box.min().transpose() - spacing * Eigen::RowVector3d(0.137, 0.311, 0.473);
  grid.Spacing = spacing;
  grid.Counts = (box.sizes().transpose() / spacing).array().ceil().cast<int>() + 2;
  grid.Values.resize(grid.Counts.prod());
  for (int z = 0; z < grid.Counts(2); ++z)
  {
    for (int y = 0; y < grid.Counts(1); ++y)
    {
      for (int x = 0; x < grid.Counts(0); ++x)
      {
        double least = 1e300;
        for (const Limb& limb : limbs)
        {
          least = std::min(least, limb.Distance(grid.Point(x, y, z)));
        }
        grid.Values(grid.Index(x, y, z)) = least;
      }
    }
  }
  return shape::ExtractIsoSurface(grid, 0.0);
}

/// A chain of limbs of one radius along positions.
inline std::vector<Limb> Chain(const std::vector<Eigen::RowVector3d>& positions, double radius)
{
  std::vector<Limb> limbs;
  for (std::size_t i = 1; i < positions.size(); ++i)
  {
    limbs.push_back({ positions[i - 1], positions[i], radius, radius });
  }
  return limbs;
}

/// Limbs from the origin, `lengths` long, evenly spread in the plane z = 0, from the x axis on.
inline std::vector<Limb> Star(const std::vector<double>& lengths, double radius)
{
  std::vector<Limb> limbs;
  for (std::size_t i = 0; i < lengths.size(); ++i)
  {
    const double angle = 2.0 * M_PI * i / lengths.size();
    limbs.push_back({ Eigen::RowVector3d::Zero(),
      lengths[i] * Eigen::RowVector3d(std::cos(angle), std::sin(angle), 0.0), radius, radius });
  }
  return limbs;
}

/// A palm and five fingers. bend: how far the tip of each finger is bent out of z = 0, in radians.
inline shape::Mesh Hand(double bend, double spacing)
{
  const double lengths[] = { 0.5, 1.1, 2.0, 1.5, 0.8 }, angles[] = { 2.7, 2.1, 1.6, 1.1, 0.5 };
  std::vector<Limb> limbs = { { { 0.0, -1.2, 0.0 }, { 0.0, 0.0, 0.0 }, 0.3, 0.5 } };
  for (int i = 0; i < 5; ++i)
  {
    const Eigen::RowVector3d along(std::cos(angles[i]), std::sin(angles[i]), 0.0);
    const Eigen::RowVector3d root = 0.2 * along, middle = root + 0.6 * lengths[i] * along;
    const Eigen::RowVector3d tip = middle +
      0.7 * lengths[i] * (std::cos(bend) * along + std::sin(bend) * Eigen::RowVector3d::UnitZ());
    limbs.push_back({ root, middle, 0.12, 0.12 });
    limbs.push_back({ middle, tip, 0.12, 0.1 });
  }
  return Union(limbs, spacing);
}

} // namespace shapetest
