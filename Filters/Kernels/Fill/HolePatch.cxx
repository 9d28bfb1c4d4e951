#include "Fill/HolePatch.h"

#include "Base/Errors.h"
#include "Fill/Private/HoleDisk.h"
#include "Geometry/VertexNormals.h"
#include "Laplacian/Membrane.h"
#include "Parameterize/ConformalFlattening.h"
#include "Planar/PlanarLocator.h"
#include "Search/PointTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

using Eigen::RowVector2d;
using Eigen::RowVector3d;

/// The membrane is an intermediate result: its interior may be coarse.
constexpr double CoarseGrowth = 0.5;

Eigen::MatrixXd InSpace(const Eigen::MatrixXd& flat)
{
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(flat.rows(), 3);
  points.leftCols<2>() = flat;
  return points;
}

/// A point of a triangle that is curved to normals at its corners (one a row): the cubic patch of
/// Vlachos and others, "Curved PN triangles", 2001.
/// A control point beside a corner is a third of the way along the edge, projected to the corner's
/// tangent plane; the middle one is E + (E - V) / 2, with E the mean of the six and V that of the
/// corners.
RowVector3d EvaluateCurvedTriangle(
  const Eigen::Matrix3d& corners, const Eigen::Matrix3d& normals, const RowVector3d& barycentric)
{
  RowVector3d position = RowVector3d::Zero();
  // The control points beside the corners, and by their mean the one in the middle.
  RowVector3d middle = -0.5 * corners.colwise().mean();
  for (int i = 0; i < 3; ++i)
  {
    const RowVector3d corner = corners.row(i), normal = normals.row(i);
    const double u = barycentric(i);
    position += u * u * u * corner;
    for (const int j : { (i + 1) % 3, (i + 2) % 3 })
    {
      const RowVector3d way = corners.row(j) - corner;
      const RowVector3d control = corner + (way - way.dot(normal) * normal) / 3.0;
      position += 3.0 * u * u * barycentric(j) * control;
      middle += 0.25 * control;
    }
  }
  return position + 6.0 * barycentric.prod() * middle;
}

/// Interpolates values at the points of a triangulated layout at any position.
class FlatField
{
public:
  FlatField(const Eigen::MatrixXd& flat, const Eigen::MatrixXi& triangles)
    : Triangles(triangles)
    , Locator(flat, triangles)
    , Tree(InSpace(flat))
  {
  }

  /// Linear in the triangle that contains the position; outside, the value of the nearest point.
  double At(const RowVector2d& position, const Eigen::VectorXd& values) const
  {
    const SurfacePoint found = this->Locator.Find(position);
    return found.Triangle < 0 ? values(this->Nearest(position))
                              : found.Barycentric.dot(values(this->Corners(found)));
  }

  /// The same for the points of a surface whose triangles are curved to normals.
  RowVector3d OnSurface(const RowVector2d& position, const Eigen::MatrixXd& points,
    const Eigen::MatrixXd& normals) const
  {
    const SurfacePoint found = this->Locator.Find(position);
    if (found.Triangle < 0)
    {
      return points.row(this->Nearest(position));
    }
    const Eigen::RowVector3i corners = this->Corners(found);
    return EvaluateCurvedTriangle(
      points(corners, Eigen::all), normals(corners, Eigen::all), found.Barycentric);
  }

private:
  Eigen::RowVector3i Corners(const SurfacePoint& position) const
  {
    return this->Triangles.row(position.Triangle);
  }
  int Nearest(const RowVector2d& position) const
  {
    return this->Tree.Nearest({ position.x(), position.y(), 0.0 }, 1).front();
  }

  const Eigen::MatrixXi& Triangles;
  PlanarLocator Locator;
  PointTree Tree;
};

/// The factor by which edges around each point (n) are longer on another surface with the same
/// triangles.
Eigen::VectorXd Stretch(const Mesh& surface, const Mesh& other)
{
  const Eigen::VectorXd areas = ComputePointAreas(surface), otherAreas = ComputePointAreas(other);
  const double minimum = 1e-6 * (areas.mean() + otherAreas.mean());
  return (otherAreas.array() + minimum).cwiseQuotient(areas.array() + minimum).sqrt();
}

/// Wanted edge lengths at the points of a surface (n).
/// Lengths are interpolated geometrically, since edges grow by a factor from triangle to triangle.
Eigen::VectorXd WantedSizes(const Mesh& surface, const PatchSizes& sizes)
{
  const Eigen::Index loop = sizes.Loop.size();
  const Eigen::VectorXd areas = ComputePointAreas(surface);
  const Eigen::VectorXd even =
    SolveHarmonicValues(surface, sizes.Loop.array().log().matrix()).array().exp();
  const PointTree tree(surface.Points.topRows(loop));
  Eigen::VectorXd distances = Eigen::VectorXd::Zero(even.size());
  for (Eigen::Index i = loop; i < distances.size(); ++i)
  {
    const int nearest = tree.Nearest(surface.Points.row(i), 1).front();
    distances(i) = (surface.Points.row(i) - surface.Points.row(nearest)).norm();
  }
  const auto wanted = [&](double growth) -> Eigen::VectorXd { return even + growth * distances; };
  // An equilateral grid with edges h has one point per sqrt(3 / 4) h^2.
  const auto count = [&](double growth)
  { return (areas.array() / wanted(growth).array().square()).sum() / std::sqrt(0.75); };
  double growth = sizes.Growth;
  while (count(growth) > sizes.MaximumPoints && growth < 10.0)
  {
    growth = std::max(0.01, 1.25 * growth);
  }
  return wanted(growth);
}

/// Triangles inside an outline, with the edge lengths of a field over the layout; and the positions
/// of their points on the surface.
HolePatch Triangulated(const Mesh& surface, const Eigen::MatrixXd& flat,
  const Eigen::VectorXd& wanted, const Eigen::MatrixXd& normals, const PatchSizes& sizes,
  const Progress& progress)
{
  const Eigen::Index loop = sizes.Loop.size();
  const FlatField field(flat, surface.Triangles);
  Eigen::VectorXd edges =
    wanted.cwiseProduct(Stretch(surface, { InSpace(flat), surface.Triangles }));
  // The edge length that suits most points.
  const Eigen::ArrayXd counts =
    ComputePointAreas({ InSpace(flat), surface.Triangles }).array() / edges.array().square();
  FlatDiskOptions options;
  // The grid halves its cells where smaller ones are wanted, so its base should suit most of the
  // points.
  options.Edge = std::exp((counts * edges.array().log()).sum() / counts.sum());
  options.Growth = 0.1;
  options.Size = [&](const RowVector2d& position) { return field.At(position, edges); };
  options.IsTaken = sizes.IsTaken;
  options.IsOutside = sizes.IsOutside;
  const FlatDisk disk = TriangulateDisk(flat.topRows(loop), options, progress);
  HolePatch patch{ { Eigen::MatrixXd(disk.Points.rows(), 3), disk.Triangles }, disk.Points };
  for (Eigen::Index i = 0; i < disk.Points.rows(); ++i)
  {
    patch.Surface.Points.row(i) = i < loop
      ? RowVector3d(surface.Points.row(i))
      : field.OnSurface(disk.Points.row(i), surface.Points, normals);
  }
  return patch;
}

} // namespace

Mesh BuildFlatSurface(const HolePatch& patch)
{
  return { InSpace(patch.Flat), patch.Surface.Triangles };
}

Eigen::VectorXd ComputeBoundarySizes(const Eigen::MatrixXd& loop)
{
  const Eigen::Index count = loop.rows();
  Eigen::VectorXd sides(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    sides(i) = (loop.row((i + 1) % count) - loop.row(i)).norm();
  }
  // A coincident pair of points must not ask for infinitely many triangles.
  sides = sides.cwiseMax(1e-3 * sides.mean());
  // Four edges before and after each point, the nearer ones with more weight.
  constexpr int reach = 4;
  Eigen::VectorXd sizes(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    double sum = 0.0, weights = 0.0;
    for (int step = -reach; step < reach; ++step)
    {
      const double weight = reach + 0.5 - std::abs(step + 0.5);
      sum += weight * sides((i + step + reach * count) % count);
      weights += weight;
    }
    sizes(i) = sum / weights;
  }
  return sizes;
}

// Section 4.1 of Schmidt and Singh, the first steps: the loop on a circle with its edge lengths,
// interior vertices on a regular triangular grid, Delaunay triangulation, and the membrane.
HolePatch BuildMembranePatch(
  const Eigen::MatrixXd& loop, const PatchSizes& patchSizes, const Progress& progress)
{
  const Eigen::Index corners = loop.rows();
  Eigen::VectorXd sides(corners);
  for (Eigen::Index i = 0; i < corners; ++i)
  {
    sides(i) = (loop.row((i + 1) % corners) - loop.row(i)).norm();
  }
  const Eigen::MatrixXd outline = BuildCircleOutline(sides);
  const Eigen::VectorXd& sizes = patchSizes.Loop;
  std::vector<double> angles; // of the corners, ascending
  const auto angleOf = [](const RowVector2d& position)
  {
    const double angle = std::atan2(position.y(), position.x());
    return angle < 0.0 ? angle + 2.0 * M_PI : angle;
  };
  for (Eigen::Index i = 0; i < corners; ++i)
  {
    angles.push_back(std::max(angleOf(outline.row(i)), angles.empty() ? 0.0 : angles.back()));
  }
  FlatDiskOptions options;
  options.Edge = sizes.mean();
  options.Growth = CoarseGrowth;
  options.Size = [&](const RowVector2d& position)
  {
    // The nearest corners are those in the same direction.
    const auto after = std::upper_bound(angles.begin(), angles.end(), angleOf(position));
    const Eigen::Index corner = std::max<std::ptrdiff_t>(after - angles.begin(), 1) - 1;
    return sizes(corner) + CoarseGrowth * (position - outline.row(corner)).norm();
  };
  options.IsTaken = patchSizes.IsTaken;
  options.IsOutside = patchSizes.IsOutside;
  const FlatDisk disk = TriangulateDisk(outline, options, progress.Part(0.0, 0.7));
  HolePatch patch{ { InSpace(disk.Points), disk.Triangles }, disk.Points };
  // Each round minimises the Dirichlet energy over the last surface (Pinkall and Polthier); a few
  // rounds come near the minimal surface.
  constexpr int rounds = 3;
  patch.Surface.Points = SolveMembrane(patch.Surface, loop, rounds, progress.Part(0.7, 1.0));
  return patch;
}

double ComputeMaximumStretch(const Mesh& one, const Mesh& other)
{
  const Eigen::ArrayXd logs = Stretch(one, other).array().log();
  return std::exp((logs - logs.mean()).abs().maxCoeff());
}

// Section 4.1, the next step: the free-boundary conformal map of the membrane, which gives the disk
// nearly the shape of the hole.
HolePatch RemeshPatch(const HolePatch& patch, const PatchSizes& sizes,
  const Eigen::MatrixXd& loopNormals, const Progress& progress)
{
  const Eigen::Index loop = sizes.Loop.size();
  const Eigen::VectorXd wanted = WantedSizes(patch.Surface, sizes);
  progress(0.2);
  // Without an area, angles are not defined: the rim lies on a line.
  const Eigen::MatrixXd flat = HasArea(patch.Surface)
    ? FlattenConformally(patch.Surface, progress.Part(0.2, 0.4))
    : patch.Flat;
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(patch.Flat.rows(), 3);
  if (loopNormals.rows() > 0)
  {
    normals = ComputeVertexNormals(patch.Surface, NormalWeight::Max);
    normals.topRows(loop) = loopNormals;
  }
  HolePatch finer =
    Triangulated(patch.Surface, flat, wanted, normals, sizes, progress.Part(0.4, 1.0));
  return finer.Surface.Triangles.rows() > 0
    ? finer
    : Triangulated(patch.Surface, patch.Flat, wanted, normals, sizes, progress.Part(0.4, 1.0));
}

} // namespace shape
