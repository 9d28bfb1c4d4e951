#include "ExponentialMap/ConformalPatch.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Parameterize/ConformalFlattening.h"
#include "Mesh/DiskGrowth.h"
#include "Parameterize/FreeBoundaryMap.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <complex>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

std::complex<double> ToComplex(const Eigen::RowVector2d& place)
{
  return { place.x(), place.y() };
}

/// The places, moved, turned and scaled to agree with the exponential map around the seed.
void Align(const ExponentialPatch& patch, Eigen::MatrixXd& places)
{
  // Both maps near the seed: the nearest points count most.
  const Eigen::Index near = std::min<Eigen::Index>(places.rows(), 12);
  Eigen::VectorXd weights(near);
  for (Eigen::Index i = 0; i < near; ++i)
  {
    weights(i) = 1.0 / (patch.Distances(i) + 0.1 * patch.Distances(near - 1));
  }
  weights /= weights.sum();
  const Eigen::RowVector2d middle = weights.transpose() * places.topRows(near);
  const Eigen::RowVector2d wanted = weights.transpose() * patch.Places.topRows(near);
  std::complex<double> turn = 0.0, size = 0.0;
  for (Eigen::Index i = 0; i < near; ++i)
  {
    const std::complex<double> from = ToComplex(places.row(i) - middle);
    turn += weights(i) * std::conj(from) * ToComplex(patch.Places.row(i) - wanted);
    size += weights(i) * std::norm(from);
  }
  const std::complex<double> similarity = turn / size;
  const std::complex<double> seed = ToComplex(middle) - ToComplex(wanted) / similarity;
  std::complex<double> rotation = similarity / std::abs(similarity);
  double far = 0.0, along = 0.0;
  for (Eigen::Index i = 0; i < places.rows(); ++i)
  {
    far += std::abs(ToComplex(places.row(i)) - seed);
    along += patch.Distances(i);
  }
  rotation *= along / far;
  for (Eigen::Index i = 0; i < places.rows(); ++i)
  {
    const std::complex<double> place = rotation * (ToComplex(places.row(i)) - seed);
    places.row(i) << place.real(), place.imag();
  }
}

void RequireArea(const Mesh& part)
{
  constexpr double leastShare = 1e-12; // of the square of the diagonal: far above what is rounded
  const double diagonal = part.Triangles.rows() > 0 ? BoxDiagonal(part.Points) : 0.0;
  const double area = diagonal > 0.0 ? AreaVectors(part).rowwise().norm().sum() : 0.0;
  if (!(area > leastShare * diagonal * diagonal))
  {
    throw InvalidInput("the surface has no area near the seed; move it, or check the points there");
  }
}

Eigen::MatrixXd FlatPlaces(const Mesh& part, bool refine, const Progress& progress)
{
  if (!refine)
  {
    Mesh unit = part; // of the size of 1, so that no unit of length is too large or small
    unit.Points.rowwise() -= part.Points.row(0);
    unit.Points /= BoxDiagonal(part.Points);
    return ConformalFlattening(unit, progress);
  }
  FreeBoundaryMapOptions options;
  options.Refine = true;
  return FreeBoundaryMap(part, options, progress).Points.leftCols(2);
}

} // namespace

ExponentialPatch LaidOutConformally(
  const Mesh& surface, const ExponentialPatch& patch, bool refine, const Progress& progress)
{
  const auto points = static_cast<int>(patch.Points.size());
  // The triangles' order is that of the front: the first is at the seed.
  const std::vector<int> rows = GrownDisk(patch.Corners, points);
  std::vector<int> number(points, -1);
  for (const int row : rows)
  {
    for (const int corner : patch.Corners.row(row))
    {
      number[corner] = 0;
    }
  }
  ExponentialPatch part;
  part.Seed = patch.Seed;
  part.ReachesRim = patch.ReachesRim;
  std::vector<int> kept;
  for (int point = 0; point < points; ++point)
  {
    if (number[point] == 0)
    {
      number[point] = static_cast<int>(kept.size());
      kept.push_back(point);
      part.Points.push_back(patch.Points[point]);
    }
  }
  for (const int row : rows)
  {
    part.Triangles.push_back(patch.Triangles[row]);
  }
  part.Places = patch.Places(kept, Eigen::all);
  part.Distances = patch.Distances(kept);
  part.Corners = Eigen::MatrixXi(patch.Corners(rows, Eigen::all))
                   .unaryExpr([&](int corner) { return number[corner]; });
  const Mesh cut{ surface.Points(part.Points, Eigen::all), part.Corners };
  RequireArea(cut);
  Eigen::MatrixXd places = FlatPlaces(cut, refine, progress);
  Align(part, places);
  part.Places = std::move(places);
  part.Flipped = TurnedOver(part.Corners, part.Places);
  return part;
}

} // namespace shape
