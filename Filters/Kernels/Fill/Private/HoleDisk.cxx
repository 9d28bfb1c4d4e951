#include "Fill/Private/HoleDisk.h"

#include "Planar/PlanarDelaunay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <vector>

namespace shape
{
namespace
{

using Eigen::RowVector2d;

/// Half of the angles that sides of given lengths subtend in a circle of diameter 1 / bend.
Eigen::VectorXd HalfAngles(const Eigen::VectorXd& lengths, double bend)
{
  return (lengths * bend).cwiseMin(1.0).array().asin();
}

/// The points of a triangular grid over a box, as fine as requested.
class GridPoints
{
public:
  GridPoints(const RowVector2d& low, const RowVector2d& high, const FlatDiskOptions& options)
    : Low(low)
    , High(high)
    , Options(options)
    , Side(options.Edge)
  {
    // The inscribed circle of the first cell goes around the box.
    const double radius = 0.5 * (high - low).norm();
    while (this->Side < 2.0 * std::sqrt(3.0) * radius)
    {
      this->Side *= 2.0;
    }
    this->Origin = 0.5 * (low + high) - this->Side * RowVector2d(0.5, std::sqrt(3.0) / 6.0);
  }

  /// Returns the points within the box, each once.
  std::vector<RowVector2d> Find(const Progress& progress)
  {
    this->Split({ 0, 0 }, Finest, 1, progress);
    std::sort(this->Nodes.begin(), this->Nodes.end());
    this->Nodes.erase(std::unique(this->Nodes.begin(), this->Nodes.end()), this->Nodes.end());
    std::vector<RowVector2d> positions;
    for (const Node& node : this->Nodes)
    {
      const RowVector2d position = this->Position(node[0], node[1]);
      if ((position.array() > this->Low.array()).all() &&
        (position.array() < this->High.array()).all())
      {
        positions.push_back(position);
      }
    }
    return positions;
  }

private:
  /// Steps along the sides of the first cell at 0 and 60 degrees, of which it has Finest each.
  using Node = std::array<std::int64_t, 2>;
  // A power of two, so that cells can be halved 40 times in integers: nodes shared by cells are
  // equal.
  static constexpr std::int64_t Finest = std::int64_t(1) << 40;

  RowVector2d Position(double along, double up) const
  {
    // Slightly askew: where cells of two sizes meet, four corners would lie on one circle, and
    // rounding would decide between the triangles.
    const double step = this->Side / static_cast<double>(Finest);
    return this->Origin + step * RowVector2d(along + 0.50002 * up, (std::sqrt(0.75) - 3e-5) * up);
  }

  /// A cell from a corner to the two `size` steps along and up, or down where that is negative.
  void Split(const Node& corner, std::int64_t size, int sense, const Progress& progress)
  {
    const std::int64_t signedSize = sense * size;
    const double third = static_cast<double>(signedSize) / 3.0;
    const RowVector2d centre = this->Position(
      static_cast<double>(corner[0]) + third, static_cast<double>(corner[1]) + third);
    const double side = this->Side * static_cast<double>(size) / static_cast<double>(Finest);
    const double radius = side / std::sqrt(3.0);
    if ((centre.array() + radius < this->Low.array()).any() ||
      (centre.array() - radius > this->High.array()).any())
    {
      return;
    }
    // No position in the cell may want less, since Growth limits the slope of Size.
    const double wanted = this->Options.Size(centre) - this->Options.Growth * radius;
    // Halving lengths gives cells between wanted / sqrt(2) and wanted * sqrt(2). The limit of an
    // edge / 1000 is that of Size.
    if (size == 1 || side <= 1e-3 * this->Options.Edge || side <= std::sqrt(2.0) * wanted)
    {
      this->Nodes.push_back(corner);
      this->Nodes.push_back({ corner[0] + signedSize, corner[1] });
      this->Nodes.push_back({ corner[0], corner[1] + signedSize });
      if (this->Nodes.size() % 10000 < 3)
      {
        progress(0.0);
      }
      return;
    }
    const std::int64_t half = signedSize / 2;
    this->Split(corner, size / 2, sense, progress);
    this->Split({ corner[0] + half, corner[1] }, size / 2, sense, progress);
    this->Split({ corner[0], corner[1] + half }, size / 2, sense, progress);
    // The middle one of the four triangles points the other way.
    this->Split({ corner[0] + half, corner[1] + half }, size / 2, -sense, progress);
  }

  const RowVector2d Low, High;
  const FlatDiskOptions& Options;
  double Side; ///< of the first cell
  RowVector2d Origin;
  std::vector<Node> Nodes;
};

/// Whether a triangulation's outline neither crosses nor touches itself; marks the points on it.
bool IsSimple(
  const PlanarTriangulation& found, int corners, Eigen::Index given, std::vector<bool>& onOutline)
{
  bool isSimple = found.Points.rows() == given; // none was added where it crosses itself
  for (int i = 0; i < corners; ++i)
  {
    isSimple = isSimple && found.SamePoint(i) == i;
  }
  for (Eigen::Index i = 0; i < found.Edges.rows() && isSimple; ++i)
  {
    const int side = found.EdgeSegments(i);
    for (const int point : found.Edges.row(i))
    {
      isSimple = isSimple && (point >= corners || point == side || point == (side + 1) % corners);
      onOutline[point] = true;
    }
  }
  return isSimple;
}

/// A disk, and which of its points lie on the outline or are its corners.
struct MarkedDisk : FlatDisk
{
  std::vector<bool> OnOutline;
};

/// The Delaunay triangulation of an outline and points; those that are not inside are left out.
MarkedDisk Triangulated(const Eigen::MatrixXd& outline, const std::vector<RowVector2d>& inside)
{
  const auto corners = static_cast<int>(outline.rows());
  Eigen::MatrixXd points(corners + static_cast<Eigen::Index>(inside.size()), 2);
  points.topRows(corners) = outline;
  for (std::size_t i = 0; i < inside.size(); ++i)
  {
    points.row(corners + static_cast<Eigen::Index>(i)) = inside[i];
  }
  Eigen::MatrixXi sides(corners, 2);
  for (int i = 0; i < corners; ++i)
  {
    sides.row(i) << i, (i + 1) % corners;
  }
  PlanarDelaunayOptions options;
  options.Keep = PlanarDelaunayOptions::KeepType::Oddly;
  options.AddCrossings = true;
  const PlanarTriangulation found = TriangulateInPlane(points, sides, options);
  MarkedDisk disk;
  disk.Points = outline;
  disk.Triangles.resize(0, 3);
  std::vector<bool> onOutline(found.Points.rows(), false);
  if (!IsSimple(found, corners, points.rows(), onOutline))
  {
    return disk;
  }
  std::vector<int> number(points.rows(), -1), used(corners);
  std::iota(used.begin(), used.end(), 0);
  for (const int corner : found.Triangles.reshaped())
  {
    number[corner] = 0;
  }
  for (int i = corners; i < static_cast<int>(points.rows()); ++i)
  {
    if (number[i] == 0)
    {
      used.push_back(i);
    }
  }
  disk.Points.resize(static_cast<Eigen::Index>(used.size()), 2);
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    number[used[i]] = static_cast<int>(i);
    disk.Points.row(static_cast<Eigen::Index>(i)) = points.row(used[i]);
    disk.OnOutline.push_back(onOutline[used[i]]);
  }
  disk.Triangles = found.Triangles.unaryExpr([&](int corner) { return number[corner]; });
  return disk;
}

/// Points of a disk that are so close to its outline that they make bad triangles there.
std::vector<bool> TooClose(
  const MarkedDisk& disk, Eigen::Index corners, const FlatDiskOptions& options)
{
  constexpr double close = 0.6; // of the wanted edge
  std::vector<bool> tooClose = disk.OnOutline;
  for (const auto& triangle : disk.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const int point = triangle(k), next = triangle((k + 1) % 3), last = triangle((k + 2) % 3);
      if (point < corners)
      {
        continue;
      }
      const RowVector2d position = disk.Points.row(point);
      const RowVector2d toNext = disk.Points.row(next) - position;
      const RowVector2d toLast = disk.Points.row(last) - position;
      const double wanted = close * options.Size(position);
      tooClose[point] = tooClose[point] || (next < corners && toNext.norm() < wanted) ||
        (last < corners && toLast.norm() < wanted) ||
        // Or it sees an edge of the outline under an obtuse angle.
        (next < corners && last < corners && toNext.dot(toLast) < 0.0);
    }
  }
  return tooClose;
}

/// The midpoints of edges inside a disk that must not exist.
std::vector<RowVector2d> MidpointsOfUnwanted(
  const FlatDisk& disk, int corners, const FlatDiskOptions& options)
{
  const auto isUnwanted = [&](int a, int b)
  {
    const int sides = std::min(b - a, corners - (b - a));
    return sides > 1 &&
      ((options.IsTaken && options.IsTaken(a, b)) ||
        (options.IsOutside && sides > 2 && options.IsOutside(a, b)));
  };
  std::vector<RowVector2d> midpoints;
  for (const auto& triangle : disk.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = triangle(k), b = triangle((k + 1) % 3);
      // Each inner edge is met from both triangles.
      if (a < b && b < corners && isUnwanted(a, b))
      {
        midpoints.push_back(0.5 * (disk.Points.row(a) + disk.Points.row(b)));
      }
    }
  }
  return midpoints;
}

bool IsCounterClockwise(const RowVector2d& a, const RowVector2d& b, const RowVector2d& c)
{
  return (b - a).x() * (c - a).y() > (b - a).y() * (c - a).x();
}

/// Triangles by their edges between two corners of the outline, as they run.
std::map<std::array<int, 2>, int> TrianglesAtChords(const FlatDisk& disk, int corners)
{
  std::map<std::array<int, 2>, int> triangles;
  for (int t = 0; t < static_cast<int>(disk.Triangles.rows()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = disk.Triangles(t, k), b = disk.Triangles(t, (k + 1) % 3);
      if (a < corners && b < corners)
      {
        triangles[{ a, b }] = t;
      }
    }
  }
  return triangles;
}

} // namespace

/// A chord of length l subtends the half angle asin(l bend), with bend = 1 / diameter. The half
/// angles add up to pi if the centre is inside. If it is outside, that of the longest edge equals
/// the sum of the others. The equation is monotone in bend, so it is bisected.
Eigen::MatrixXd BuildCircleOutline(const Eigen::VectorXd& lengths)
{
  Eigen::VectorXd sides = lengths.cwiseMax(1e-3 * lengths.mean());
  Eigen::Index longest = 0;
  sides.maxCoeff(&longest);
  const double others = sides.sum() - sides(longest);
  // Otherwise no polygon has these edges.
  sides(longest) = std::min(sides(longest), 0.999 * others);
  // The difference between the edges' angles and a full turn, with the centre outside or inside.
  const bool isOutside = HalfAngles(sides, 1.0 / sides(longest)).sum() < M_PI;
  const auto excess = [&](double bend)
  {
    const Eigen::VectorXd angles = HalfAngles(sides, bend);
    return isOutside ? 2.0 * angles(longest) - angles.sum() : angles.sum() - M_PI;
  };
  double low = 0.0, high = 1.0 / sides(longest);
  // More than the bits of a double: the interval becomes as small as it can.
  for (int round = 0; round < 100; ++round)
  {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? high : low) = middle;
  }
  const double bend = 0.5 * (low + high);
  Eigen::VectorXd angles = 2.0 * HalfAngles(sides, bend);
  if (isOutside)
  {
    angles(longest) = -angles(longest);
  }
  Eigen::MatrixXd outline(sides.size(), 2);
  double angle = 0.0;
  for (Eigen::Index i = 0; i < sides.size(); ++i)
  {
    outline.row(i) << 0.5 / bend * std::cos(angle), 0.5 / bend * std::sin(angle);
    angle += angles(i);
  }
  return outline;
}

// 1. Triangulate the outline with all points of the grid inside.
// 2. Remove the points that are too close to the outline there, and triangulate again (TooClose).
// 3. Split inner edges that must not exist, until there are none (MidpointsOfUnwanted).
// 4. Flip those that cut off a single corner (FlipTips).
FlatDisk TriangulateDisk(
  const Eigen::MatrixXd& outline, const FlatDiskOptions& options, const Progress& progress)
{
  const auto corners = static_cast<int>(outline.rows());
  const RowVector2d low = outline.colwise().minCoeff(), high = outline.colwise().maxCoeff();
  const MarkedDisk all = Triangulated(outline, GridPoints(low, high, options).Find(progress));
  progress(0.5);
  const std::vector<bool> tooClose = TooClose(all, outline.rows(), options);
  std::vector<RowVector2d> kept;
  for (Eigen::Index i = outline.rows(); i < all.Points.rows(); ++i)
  {
    if (!tooClose[i])
    {
      kept.push_back(all.Points.row(i));
    }
  }
  progress(0.6);
  FlatDisk disk = all.Triangles.rows() == 0 ? FlatDisk(all) : Triangulated(outline, kept);
  constexpr int rounds = 10; // a new point may create another such edge
  for (int round = 0; round < rounds; ++round)
  {
    const std::vector<RowVector2d> midpoints = MidpointsOfUnwanted(disk, corners, options);
    if (midpoints.empty())
    {
      break;
    }
    kept.insert(kept.end(), midpoints.begin(), midpoints.end());
    disk = Triangulated(outline, kept);
  }
  if (options.IsOutside)
  {
    FlipTips(disk, corners, options.IsOutside, options.IsTaken);
  }
  return disk;
}

void FlipTips(FlatDisk& disk, int corners, const std::function<bool(int, int)>& isOutside,
  const std::function<bool(int, int)>& isTaken)
{
  const std::map<std::array<int, 2>, int> triangles = TrianglesAtChords(disk, corners);
  std::vector<bool> isChanged(disk.Triangles.rows(), false);
  for (int tip = 0; tip < corners; ++tip)
  {
    const int last = (tip + corners - 1) % corners, next = (tip + 1) % corners;
    const auto inner = triangles.find({ next, last }), outer = triangles.find({ last, next });
    if (inner == triangles.end() || outer == triangles.end() || isChanged[inner->second] ||
      isChanged[outer->second] || !isOutside(last, next))
    {
      continue;
    }
    const int far = disk.Triangles.row(outer->second).sum() - last - next;
    const RowVector2d from = disk.Points.row(tip), to = disk.Points.row(far);
    if ((far < corners && isTaken && isTaken(tip, far)) ||
      !IsCounterClockwise(from, to, disk.Points.row(last)) ||
      !IsCounterClockwise(to, from, disk.Points.row(next)))
    {
      continue;
    }
    disk.Triangles.row(inner->second) << last, tip, far;
    disk.Triangles.row(outer->second) << tip, next, far;
    isChanged[inner->second] = isChanged[outer->second] = true;
  }
}

} // namespace shape
