#include "ExponentialMap/ConformalPatch.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Mesh/DiskGrowth.h"
#include "Parameterize/ConformalFlattening.h"
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

std::complex<double> ToComplex(const Eigen::RowVector2d& position)
{
  return { position.x(), position.y() };
}

/// Moves, rotates and scales the positions to match the exponential map around the seed.
/// The similarity that fits one map to the other best around the seed: with complex numbers, the
/// ratio of the weighted sums of conj(from) * to and |from|^2. Only its rotation is kept; the scale
/// is that of all distances.
void Align(const ExponentialPatch& patch, Eigen::MatrixXd& positions)
{
  // Both maps are compared near the seed: the nearest points have the largest weights.
  const Eigen::Index near = std::min<Eigen::Index>(positions.rows(), 12);
  Eigen::VectorXd weights(near);
  for (Eigen::Index i = 0; i < near; ++i)
  {
    // A tenth of the farthest one limits the weight of a point at the seed.
    weights(i) = 1.0 / (patch.Distances(i) + 0.1 * patch.Distances(near - 1));
  }
  weights /= weights.sum();
  const Eigen::RowVector2d centre = weights.transpose() * positions.topRows(near);
  const Eigen::RowVector2d wanted = weights.transpose() * patch.Positions.topRows(near);
  std::complex<double> turn = 0.0, size = 0.0;
  for (Eigen::Index i = 0; i < near; ++i)
  {
    const std::complex<double> from = ToComplex(positions.row(i) - centre);
    turn += weights(i) * std::conj(from) * ToComplex(patch.Positions.row(i) - wanted);
    size += weights(i) * std::norm(from);
  }
  const std::complex<double> similarity = turn / size;
  const std::complex<double> seed = ToComplex(centre) - ToComplex(wanted) / similarity;
  std::complex<double> rotation = similarity / std::abs(similarity);
  double far = 0.0, along = 0.0;
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    far += std::abs(ToComplex(positions.row(i)) - seed);
    along += patch.Distances(i);
  }
  rotation *= along / far;
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    const std::complex<double> position = rotation * (ToComplex(positions.row(i)) - seed);
    positions.row(i) << position.real(), position.imag();
  }
}

void RequireArea(const Mesh& part)
{
  // relative to the squared diagonal; far above rounding error
  constexpr double minimumShare = 1e-12;
  const double diagonal = part.Triangles.rows() > 0 ? ComputeBoxDiagonal(part.Points) : 0.0;
  const double area = diagonal > 0.0 ? ComputeAreaVectors(part).rowwise().norm().sum() : 0.0;
  if (!(area > minimumShare * diagonal * diagonal))
  {
    throw InvalidInput(
      "the surface has no area near the seed; move the seed, or check the points there");
  }
}

Eigen::MatrixXd FlatPositions(const Mesh& part, bool refine, const Progress& progress)
{
  if (!refine)
  {
    Mesh unit = part; // scaled to size 1, which avoids overflow and underflow
    unit.Points.rowwise() -= part.Points.row(0);
    unit.Points /= ComputeBoxDiagonal(part.Points);
    return FlattenConformally(unit, progress);
  }
  FreeBoundaryMapOptions options;
  options.Refine = true;
  return MapWithFreeBoundary(part, options, progress).Points.leftCols(2);
}

} // namespace

// 1. Cut the patch to a disk, from the seed outwards (GrowDisk).
// 2. Flatten the disk (FlatPositions).
// 3. Rotate, scale and move it to agree with the exponential map at the seed (Align).
ExponentialPatch FlattenPatchConformally(
  const Surface& surface, const ExponentialPatch& patch, bool refine, const Progress& progress)
{
  const auto points = static_cast<int>(patch.Points.size());
  // Triangles are in the order of the front, so the first one is at the seed.
  const std::vector<int> rows = GrowDisk(patch.Corners, points);
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
  part.ReachesBoundary = patch.ReachesBoundary;
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
  part.Positions = patch.Positions(kept, Eigen::all);
  part.Distances = patch.Distances(kept);
  part.Corners = Eigen::MatrixXi(patch.Corners(rows, Eigen::all))
                   .unaryExpr([&](int corner) { return number[corner]; });
  const Mesh cut{ surface.Points()(part.Points, Eigen::all), part.Corners };
  RequireArea(cut);
  Eigen::MatrixXd positions = FlatPositions(cut, refine, progress);
  Align(part, positions);
  part.Positions = std::move(positions);
  part.Flipped = FindInvertedTriangles(part.Corners, part.Positions);
  return part;
}

} // namespace shape
