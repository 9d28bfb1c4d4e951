#include "Harmonic/Private/ScaledBoundary.h"

#include "Base/Errors.h"
#include "Fmm/FmmLatticeOrder.h"
#include "Mesh/UsedPoints.h"
#include "Solids/Nesting.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace shape
{

namespace
{

/// Returns the points used by triangles, sorted by their coordinates alone. Neighbours are close in
/// memory, which makes searches and sums faster.
std::vector<int> UsedPointsByPosition(const Mesh& boundary)
{
  std::vector<int> used = FindUsedPoints(boundary.Triangles, boundary.Points.rows());
  const auto position = [&](int i)
  {
    return std::array<double, 3>{ boundary.Points(i, 0), boundary.Points(i, 1),
      boundary.Points(i, 2) };
  };
  // OrderOnLattice keeps the order of equal keys. Sorting first makes that order independent of the
  // input's numbering.
  std::stable_sort(
    used.begin(), used.end(), [&](int a, int b) { return position(a) < position(b); });
  const Eigen::MatrixXd positions = boundary.Points(used, Eigen::all);
  const FmmLatticeOrder order =
    OrderOnLattice(positions, { positions.colwise().minCoeff(), ComputeLongestBoxEdge(positions) });
  std::vector<int> ordered;
  ordered.reserve(used.size());
  for (const int k : order.Ids)
  {
    ordered.push_back(used[k]);
  }
  return ordered;
}

/// Returns the triangles in ascending order, each rotated to begin with its lowest corner.
Eigen::MatrixXi SortTriangles(const Eigen::MatrixXi& triangles)
{
  std::vector<std::array<int, 3>> rows(triangles.rows());
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    rows[t] = { triangles(t, 0), triangles(t, 1), triangles(t, 2) };
    std::rotate(rows[t].begin(), std::min_element(rows[t].begin(), rows[t].end()), rows[t].end());
  }
  std::sort(rows.begin(), rows.end());
  Eigen::MatrixXi sorted(triangles.rows(), 3);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    sorted.row(t) << rows[t][0], rows[t][1], rows[t][2];
  }
  return sorted;
}

/// Throws InvalidInput unless exactly one component faces outwards; the others bound voids.
void RequireOneSolid(const Surface& oriented)
{
  const Topology& topology = oriented.Topology();
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(topology.Components);
  for (Eigen::Index t = 0; t < oriented.Triangles().rows(); ++t)
  {
    volumes(topology.ComponentId(oriented.Triangles()(t, 0))) +=
      GetCorners(oriented, t).determinant();
  }
  const auto solids = (volumes.array() > 0.0).count();
  if (solids != 1)
  {
    throw InvalidInput("the boundary bounds " + std::to_string(solids) +
      " solids that do not touch; separate them with Connectivity and map each of them alone");
  }
}

} // namespace

SortedSurface SortByPosition(const Mesh& surface)
{
  std::vector<int> used = UsedPointsByPosition(surface);
  Mesh sorted{ surface.Points(used, Eigen::all),
    SortTriangles(RenumberPoints(surface.Triangles, used, surface.Points.rows())) };
  return { std::move(sorted), std::move(used) };
}

ScaledBoundary ScaleBoundary(const Surface& boundary, const Eigen::MatrixXd& targets)
{
  RequireClosedSurface(boundary, "the boundary");
  if (targets.rows() != boundary.Points().rows() || targets.cols() != 3)
  {
    throw InvalidInput("the boundary has " + std::to_string(boundary.Points().rows()) +
      " points and its map " + std::to_string(targets.rows()) + " rows of " +
      std::to_string(targets.cols()) + " numbers; give each point three coordinates");
  }
  RequireFinite(targets, "the boundary map");

  // Orientation and numbering come first. Then all further sums have the same order for any
  // numbering of the input.
  auto [surface, used] = SortByPosition(OrientByNesting(boundary, "the boundary"));
  ScaledBoundary scaled;
  scaled.Origin = surface.Points.colwise().minCoeff();
  scaled.Size = ComputeLongestBoxEdge(surface.Points);
  surface.Points = (surface.Points.rowwise() - scaled.Origin) / scaled.Size;
  const double volume = ComputeEnclosedVolume(surface);
  scaled.Surface = Surface(std::move(surface));
  RequireOneSolid(scaled.Surface);
  // Relative to the cube of the longest side.
  if (!(volume > 1e-12))
  {
    throw InvalidInput("the boundary encloses no volume; give the surface of a solid");
  }
  scaled.Targets = targets(used, Eigen::all);
  scaled.Points = std::move(used);
  scaled.TargetOrigin = scaled.Targets.colwise().minCoeff();
  const double targetSize = ComputeLongestBoxEdge(scaled.Targets);
  scaled.TargetSize = targetSize > 0.0 ? targetSize : 1.0;
  scaled.Targets = (scaled.Targets.rowwise() - scaled.TargetOrigin) / scaled.TargetSize;
  return scaled;
}

} // namespace shape
