#include "Fill/HolePatch.h"

#include "Base/Errors.h"
#include "Fill/Private/HoleDisk.h"
#include "Laplacian/Membrane.h"
#include "Geometry/PatchNormals.h"
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

constexpr double CoarseGrowth = 0.5;

Eigen::MatrixXd InSpace(const Eigen::MatrixXd& flat)
{
  Eigen::MatrixXd points = Eigen::MatrixXd::Zero(flat.rows(), 3);
  points.leftCols<2>() = flat;
  return points;
}

/// Values at the points of a triangulated layout, asked for anywhere.
class FlatField
{
public:
  FlatField(const Eigen::MatrixXd& flat, const Eigen::MatrixXi& triangles)
    : Triangles(triangles)
    , Locator(flat, triangles)
    , Tree(InSpace(flat))
  {
  }

  /// Linear in the triangle that the place is in; outside of all that of the nearest point.
  double At(const RowVector2d& place, const Eigen::VectorXd& values) const
  {
    const PlanarPlace found = this->Locator.Find(place);
    return found.Triangle < 0 ? values(this->Nearest(place))
                              : found.Barycentric.dot(values(this->Corners(found)));
  }

  /// The same of the points of a surface, its triangles curved to normals.
  RowVector3d OnSurface(
    const RowVector2d& place, const Eigen::MatrixXd& points, const Eigen::MatrixXd& normals) const
  {
    const PlanarPlace found = this->Locator.Find(place);
    if (found.Triangle < 0)
    {
      return points.row(this->Nearest(place));
    }
    const Eigen::RowVector3i corners = this->Corners(found);
    return CurvedPlace(
      points(corners, Eigen::all), normals(corners, Eigen::all), found.Barycentric);
  }

private:
  Eigen::RowVector3i Corners(const PlanarPlace& place) const
  {
    return this->Triangles.row(place.Triangle);
  }
  int Nearest(const RowVector2d& place) const
  {
    return this->Tree.Nearest({ place.x(), place.y(), 0.0 }, 1).front();
  }

  const Eigen::MatrixXi& Triangles;
  PlanarLocator Locator;
  PointTree Tree;
};

/// By how much another surface of the same triangles is longer around each point (n).
Eigen::VectorXd Stretch(const Mesh& surface, const Mesh& other)
{
  const Eigen::VectorXd areas = PointAreas(surface), otherAreas = PointAreas(other);
  const double least = 1e-6 * (areas.mean() + otherAreas.mean());
  return (otherAreas.array() + least).cwiseQuotient(areas.array() + least).sqrt();
}

/// Wanted edge lengths at the points of a surface (n).
Eigen::VectorXd WantedSizes(const Mesh& surface, const PatchSizes& sizes)
{
  const Eigen::Index rim = sizes.Rim.size();
  const Eigen::VectorXd areas = PointAreas(surface);
  const Eigen::VectorXd even =
    HarmonicValues(surface, sizes.Rim.array().log().matrix()).array().exp();
  const PointTree tree(surface.Points.topRows(rim));
  Eigen::VectorXd distances = Eigen::VectorXd::Zero(even.size());
  for (Eigen::Index i = rim; i < distances.size(); ++i)
  {
    const int nearest = tree.Nearest(surface.Points.row(i), 1).front();
    distances(i) = (surface.Points.row(i) - surface.Points.row(nearest)).norm();
  }
  const auto wanted = [&](double growth) -> Eigen::VectorXd { return even + growth * distances; };
  const auto count = [&](double growth)
  { return (areas.array() / wanted(growth).array().square()).sum() / std::sqrt(0.75); };
  double growth = sizes.Growth;
  while (count(growth) > sizes.MaximumPoints && growth < 10.0)
  {
    growth = std::max(0.01, 1.25 * growth);
  }
  return wanted(growth);
}

/// Triangles over an outline, where the layout's field says how long in the layout; and where their
/// points are on the surface.
HolePatch Triangulated(const Mesh& surface, const Eigen::MatrixXd& flat,
  const Eigen::VectorXd& wanted, const Eigen::MatrixXd& normals, const PatchSizes& sizes,
  const Progress& progress)
{
  const Eigen::Index rim = sizes.Rim.size();
  const FlatField field(flat, surface.Triangles);
  Eigen::VectorXd edges =
    wanted.cwiseProduct(Stretch(surface, { InSpace(flat), surface.Triangles }));
  // The side that suits most points.
  const Eigen::ArrayXd counts =
    PointAreas({ InSpace(flat), surface.Triangles }).array() / edges.array().square();
  FlatDiskOptions options;
  options.Edge = std::exp((counts * edges.array().log()).sum() / counts.sum());
  options.Growth = 0.1;
  options.Size = [&](const RowVector2d& place) { return field.At(place, edges); };
  options.IsTaken = sizes.IsTaken;
  options.IsOutside = sizes.IsOutside;
  const FlatDisk disk = TriangulateDisk(flat.topRows(rim), options, progress);
  HolePatch patch{ { Eigen::MatrixXd(disk.Points.rows(), 3), disk.Triangles }, disk.Points };
  for (Eigen::Index i = 0; i < disk.Points.rows(); ++i)
  {
    patch.Surface.Points.row(i) = i < rim
      ? RowVector3d(surface.Points.row(i))
      : field.OnSurface(disk.Points.row(i), surface.Points, normals);
  }
  return patch;
}

} // namespace

Mesh FlatSurface(const HolePatch& patch)
{
  return { InSpace(patch.Flat), patch.Surface.Triangles };
}

Eigen::VectorXd RimSizes(const Eigen::MatrixXd& rim)
{
  const Eigen::Index count = rim.rows();
  Eigen::VectorXd sides(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    sides(i) = (rim.row((i + 1) % count) - rim.row(i)).norm();
  }
  sides = sides.cwiseMax(1e-3 * sides.mean());
  // Four sides before and after each point, the near ones counting more.
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

HolePatch MembranePatch(
  const Eigen::MatrixXd& rim, const PatchSizes& patchSizes, const Progress& progress)
{
  const Eigen::Index corners = rim.rows();
  Eigen::VectorXd sides(corners);
  for (Eigen::Index i = 0; i < corners; ++i)
  {
    sides(i) = (rim.row((i + 1) % corners) - rim.row(i)).norm();
  }
  const Eigen::MatrixXd outline = CircleOutline(sides);
  const Eigen::VectorXd& sizes = patchSizes.Rim;
  std::vector<double> angles; // of the corners, rising
  const auto angleOf = [](const RowVector2d& place)
  {
    const double angle = std::atan2(place.y(), place.x());
    return angle < 0.0 ? angle + 2.0 * M_PI : angle;
  };
  for (Eigen::Index i = 0; i < corners; ++i)
  {
    angles.push_back(std::max(angleOf(outline.row(i)), angles.empty() ? 0.0 : angles.back()));
  }
  FlatDiskOptions options;
  options.Edge = sizes.mean();
  options.Growth = CoarseGrowth;
  options.Size = [&](const RowVector2d& place)
  {
    // The nearest corners are those in the same direction.
    const auto after = std::upper_bound(angles.begin(), angles.end(), angleOf(place));
    const Eigen::Index corner = std::max<std::ptrdiff_t>(after - angles.begin(), 1) - 1;
    return sizes(corner) + CoarseGrowth * (place - outline.row(corner)).norm();
  };
  options.IsTaken = patchSizes.IsTaken;
  options.IsOutside = patchSizes.IsOutside;
  const FlatDisk disk = TriangulateDisk(outline, options, progress.Part(0.0, 0.7));
  HolePatch patch{ { InSpace(disk.Points), disk.Triangles }, disk.Points };
  constexpr int rounds = 3;
  patch.Surface.Points = MembranePoints(patch.Surface, rim, rounds, progress.Part(0.7, 1.0));
  return patch;
}

double GreatestStretch(const Mesh& one, const Mesh& other)
{
  const Eigen::ArrayXd logs = Stretch(one, other).array().log();
  return std::exp((logs - logs.mean()).abs().maxCoeff());
}

HolePatch Retriangulated(const HolePatch& patch, const PatchSizes& sizes,
  const Eigen::MatrixXd& rimNormals, const Progress& progress)
{
  const Eigen::Index rim = sizes.Rim.size();
  const Eigen::VectorXd wanted = WantedSizes(patch.Surface, sizes);
  progress(0.2);
  const Eigen::MatrixXd flat = ConformalFlattening(patch.Surface, progress.Part(0.2, 0.4));
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(patch.Flat.rows(), 3);
  if (rimNormals.rows() > 0)
  {
    normals = MaxNormals(patch.Surface);
    normals.topRows(rim) = rimNormals;
  }
  HolePatch finer =
    Triangulated(patch.Surface, flat, wanted, normals, sizes, progress.Part(0.4, 1.0));
  return finer.Surface.Triangles.rows() > 0
    ? finer
    : Triangulated(patch.Surface, patch.Flat, wanted, normals, sizes, progress.Part(0.4, 1.0));
}

} // namespace shape
