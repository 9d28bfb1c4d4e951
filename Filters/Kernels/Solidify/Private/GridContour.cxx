#include "Solidify/Private/GridContour.h"

#include "Geometry/FeatureAngle.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace shape
{
namespace
{

using Eigen::RowVector2d;
using Eigen::RowVector3d;
using Eigen::RowVector3i;

/// The smallest distance of a point from the boundary of its edge, face or cell, as a share of the
/// spacing.
constexpr double Margin = 1e-4;

/// The four corners of a cell's face, counter-clockwise seen from outside of the cell; corner x + 2
/// y
/// + 4 z of a cell is at (x, y, z).
struct CellFace
{
  int Axis;
  bool IsHigh;
  std::array<int, 4> Corners;
};

std::array<CellFace, 6> ListFaces()
{
  std::array<CellFace, 6> faces;
  for (int face = 0; face < 6; ++face)
  {
    const int axis = face / 2, first = 1 << (axis + 1) % 3, second = 1 << (axis + 2) % 3;
    const bool isHigh = face % 2 == 1;
    const int base = isHigh ? 1 << axis : 0;
    faces[face] = { axis, isHigh, { base, base + first, base + first + second, base + second } };
    if (!isHigh)
    {
      std::swap(faces[face].Corners[1], faces[face].Corners[3]);
    }
  }
  return faces;
}

/// The edge between two corners of a cell: 3 times the lower corner, plus the axis.
int EdgeBetween(int a, int b)
{
  return 3 * std::min(a, b) + (std::abs(a - b) >> 1); // the difference is 1, 2 or 4
}

/// A segment of a loop: it begins at an edge of the cell and lies on a face.
struct LoopSide
{
  int Edge;       ///< of the cell
  int Face;       ///< of the segment to the next edge
  bool IsOnlyOne; ///< whether the face has no other segment
};
using Loop = std::vector<LoopSide>;

/// Whether two edges of a cell lie on one face.
bool ShareFace(int first, int second)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (axis != first % 3 && axis != second % 3 && ((first / 3 ^ second / 3) >> axis & 1) == 0)
    {
      return true;
    }
  }
  return false;
}

class Contour
{
public:
  Contour(const GridSolid& solid, const std::vector<GridEdge>& edges,
    const std::vector<EdgeCrossing>& crossings)
    : Solid(solid)
    , Grid(solid.Grid)
    , Edges(edges)
    , Crossings(crossings)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      this->Steps[corner] = this->Grid.Index(corner & 1, corner >> 1 & 1, corner >> 2);
    }
    this->Points.reserve(2 * edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      const int axis = static_cast<int>(edges[i] % 3);
      RowVector3d position = this->PositionOf(static_cast<int>(edges[i] / 3));
      position(axis) += this->Grid.Spacing * std::clamp(crossings[i].Share, Margin, 1.0 - Margin);
      this->Points.push_back(position);
    }
  }

  void AddCell(int x, int y, int z)
  {
    this->Point = this->Grid.Index(x, y, z);
    const int mask = this->MaskOf(this->Point);
    if (mask == 0 || mask == 255)
    {
      return;
    }
    const std::vector<Loop> loops = FindLoops(mask);
    for (const Loop& loop : loops)
    {
      this->AddLoop(loop, loops.size() == 1);
    }
  }

  Mesh Finish() const
  {
    Mesh mesh{ Eigen::MatrixXd(static_cast<Eigen::Index>(this->Points.size()), 3),
      Eigen::MatrixXi(static_cast<Eigen::Index>(this->Triangles.size()), 3) };
    for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
    {
      mesh.Points.row(i) = this->Points[i];
    }
    for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
    {
      mesh.Triangles.row(t) = this->Triangles[t];
    }
    return mesh;
  }

private:
  /// Bit k says whether corner k of the cell is inside.
  int MaskOf(int cell) const
  {
    int mask = 0;
    for (int corner = 0; corner < 8; ++corner)
    {
      mask |= (this->Solid.Inside[cell + this->Steps[corner]] ? 1 : 0) << corner;
    }
    return mask;
  }

  RowVector3d PositionOf(int point) const
  {
    const RowVector3i& counts = this->Grid.Counts;
    return this->Grid.Point(
      point % counts(0), point / counts(0) % counts(1), point / counts(0) / counts(1));
  }

  /// The loops of a cell (MaskOf).
  static std::vector<Loop> FindLoops(int mask)
  {
    static const std::array<CellFace, 6> faces = ListFaces();
    std::array<int, 24> next;
    next.fill(-1);
    std::array<LoopSide, 24> sides{};
    for (int f = 0; f < 6; ++f)
    {
      const std::array<int, 4>& ring = faces[f].Corners;
      const auto isInside = [&](int i) { return (mask >> ring[i % 4] & 1) != 0; };
      const bool isOnlyOne =
        isInside(0) != isInside(2) || isInside(1) != isInside(3) || isInside(0) == isInside(1);
      for (int i = 0; i < 4; ++i)
      {
        if (isInside(i) || !isInside(i + 1))
        {
          continue;
        }
        int last = i + 1;
        while (isInside(last + 1))
        {
          ++last;
        }
        const int begin = EdgeBetween(ring[i], ring[(i + 1) % 4]);
        next[begin] = EdgeBetween(ring[last % 4], ring[(last + 1) % 4]);
        sides[begin] = { begin, f, isOnlyOne };
      }
    }
    std::vector<Loop> loops;
    for (int begin = 0; begin < 24; ++begin)
    {
      Loop loop;
      for (int edge = begin; next[edge] >= 0;)
      {
        loop.push_back(sides[edge]);
        const int following = next[edge];
        next[edge] = -1;
        edge = following;
      }
      if (!loop.empty())
      {
        loops.push_back(loop);
      }
    }
    return loops;
  }

  /// The index of the point on an edge of the cell.
  int PointOn(int edge) const
  {
    const GridEdge key = 3 * static_cast<GridEdge>(this->Point + this->Steps[edge / 3]) + edge % 3;
    return static_cast<int>(
      std::lower_bound(this->Edges.begin(), this->Edges.end(), key) - this->Edges.begin());
  }

  bool IsFeature(int first, int second) const
  {
    static const double cosine = std::cos(DefaultFeatureAngle * M_PI / 180.0);
    const RowVector3d &a = this->Crossings[first].Normal, &b = this->Crossings[second].Normal;
    return !a.isZero() && !b.isZero() && a.dot(b) < cosine;
  }

  bool HasOneLoop(int cell) const { return FindLoops(this->MaskOf(cell)).size() == 1; }

  /// The index of the corner between two points on a face of the cell, or -1 if there is none.
  int CornerOnFace(int face, int first, int second)
  {
    const int axis = face / 2;
    const int low = this->Point + (face % 2 == 1 ? this->Steps[1 << axis] : 0);
    const auto [entry, isNew] =
      this->FaceCorners.emplace(3 * static_cast<GridEdge>(low) + axis, -1);
    // The cells on both sides must agree.
    if (isNew && this->IsFeature(first, second) && this->HasOneLoop(low) &&
      this->HasOneLoop(low - this->Steps[1 << axis]))
    {
      entry->second = this->AddCorner(low, axis, std::min(first, second), std::max(first, second));
    }
    return entry->second;
  }

  int AddCorner(int low, int axis, int first, int second)
  {
    const std::array<int, 2> across = { (axis + 1) % 3, (axis + 2) % 3 };
    Eigen::Matrix2d lines;
    Eigen::Vector2d levels;
    for (const int row : { 0, 1 })
    {
      const int point = row == 0 ? first : second;
      const RowVector3d& normal = this->Crossings[point].Normal;
      lines.row(row) << normal(across[0]), normal(across[1]);
      if (lines.row(row).norm() < 0.1) // the face is nearly tangential
      {
        return -1;
      }
      lines.row(row).normalize();
      levels(row) = lines(row, 0) * this->Points[point](across[0]) +
        lines(row, 1) * this->Points[point](across[1]);
    }
    constexpr double parallel = 0.1;
    if (std::abs(lines.determinant()) < parallel)
    {
      return -1;
    }
    RowVector3d position = this->PositionOf(low);
    const Eigen::Vector2d corner = lines.inverse() * levels;
    for (const int i : { 0, 1 })
    {
      const double share = (corner(i) - position(across[i])) / this->Grid.Spacing;
      if (share < Margin || share > 1.0 - Margin)
      {
        return -1;
      }
      position(across[i]) = corner(i);
    }
    return this->AddPoint(position);
  }

  int AddPoint(const RowVector3d& position)
  {
    this->Points.push_back(position);
    return static_cast<int>(this->Points.size()) - 1;
  }

  void AddLoop(const Loop& loop, bool mayHaveFeatures)
  {
    std::vector<int> ring, onEdges;
    for (const LoopSide& side : loop)
    {
      onEdges.push_back(this->PointOn(side.Edge));
    }
    const std::size_t count = loop.size();
    bool isSharp = false;
    for (std::size_t i = 0; i < count; ++i)
    {
      ring.push_back(onEdges[i]);
      const int next = onEdges[(i + 1) % count];
      const int corner = mayHaveFeatures && loop[i].IsOnlyOne
        ? this->CornerOnFace(loop[i].Face, onEdges[i], next)
        : -1;
      if (corner >= 0)
      {
        ring.push_back(corner);
        isSharp = true;
      }
      for (std::size_t j = 0; j < i && mayHaveFeatures; ++j)
      {
        isSharp = isSharp || this->IsFeature(onEdges[i], onEdges[j]);
      }
    }
    if (isSharp)
    {
      this->AddCone(ring, this->FindApex(onEdges, ring));
      return;
    }
    for (std::size_t i = 0; i < count; ++i)
    {
      bool isAllowed = true;
      for (std::size_t step = 2; step + 1 < count; ++step)
      {
        isAllowed = isAllowed && !ShareFace(loop[i].Edge, loop[(i + step) % count].Edge);
      }
      if (isAllowed)
      {
        for (std::size_t step = 1; step + 1 < count; ++step)
        {
          this->Triangles.emplace_back(
            onEdges[i], onEdges[(i + step) % count], onEdges[(i + step + 1) % count]);
        }
        return;
      }
    }
    this->AddCone(ring, this->Mean(ring));
  }

  RowVector3d Mean(const std::vector<int>& points) const
  {
    RowVector3d mean = RowVector3d::Zero();
    for (const int point : points)
    {
      mean += this->Points[point] / static_cast<double>(points.size());
    }
    return mean;
  }

  void AddCone(const std::vector<int>& ring, const RowVector3d& apex)
  {
    const int top = this->AddPoint(apex);
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      this->Triangles.emplace_back(ring[i], ring[(i + 1) % ring.size()], top);
    }
  }

  /// The position that is closest to the tangent planes at the points on edges. Among such
  /// positions, it is the one closest to the mean of the corners on faces, or of all points if
  /// there are none.
  RowVector3d FindApex(const std::vector<int>& onEdges, const std::vector<int>& ring) const
  {
    std::vector<int> corners;
    for (const int point : ring)
    {
      if (point >= static_cast<int>(this->Edges.size()))
      {
        corners.push_back(point);
      }
    }
    const RowVector3d middle = this->Mean(corners.empty() ? onEdges : corners);
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const int point : onEdges)
    {
      const RowVector3d& normal = this->Crossings[point].Normal;
      squares += normal.transpose() * normal;
      right += normal.transpose() * normal.dot(this->Points[point] - middle);
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(squares);
    const Eigen::Vector3d& values = solver.eigenvalues();
    RowVector3d apex = middle;
    constexpr double flat = 0.05; // directions in which the planes say little
    for (int i = 0; i < 3; ++i)
    {
      if (values(i) > flat * values(2))
      {
        const Eigen::Vector3d axis = solver.eigenvectors().col(i);
        apex += axis.dot(right) / values(i) * axis.transpose();
      }
    }
    const RowVector3d low = this->PositionOf(this->Point);
    for (int i = 0; i < 3; ++i)
    {
      apex(i) = std::clamp(apex(i), low(i) + Margin * this->Grid.Spacing,
        low(i) + (1.0 - Margin) * this->Grid.Spacing);
    }
    return apex;
  }

  const GridSolid& Solid;
  const SampledGrid& Grid;
  const std::vector<GridEdge>& Edges;
  const std::vector<EdgeCrossing>& Crossings;
  std::array<int, 8> Steps; ///< from the first corner of a cell to the others
  int Point = 0;            ///< the first corner of the cell
  std::unordered_map<GridEdge, int> FaceCorners;
  std::vector<RowVector3d> Points;
  std::vector<RowVector3i> Triangles;
};

} // namespace

std::vector<GridEdge> FindBoundaryEdges(const GridSolid& solid)
{
  const RowVector3i& counts = solid.Grid.Counts;
  const std::array<int, 3> steps = { 1, counts(0), counts(0) * counts(1) };
  std::vector<GridEdge> edges;
  int point = 0;
  for (int z = 0; z < counts(2); ++z)
  {
    for (int y = 0; y < counts(1); ++y)
    {
      for (int x = 0; x < counts(0); ++x, ++point)
      {
        const RowVector3i at(x, y, z);
        for (int axis = 0; axis < 3; ++axis)
        {
          if (at(axis) + 1 < counts(axis) &&
            (solid.Inside[point] != 0) != (solid.Inside[point + steps[axis]] != 0))
          {
            edges.push_back(3 * static_cast<GridEdge>(point) + axis);
          }
        }
      }
    }
  }
  return edges;
}

Mesh ContourGrid(const GridSolid& solid, const std::vector<GridEdge>& edges,
  const std::vector<EdgeCrossing>& crossings, const Progress& progress)
{
  Contour contour(solid, edges, crossings);
  const RowVector3i cells = solid.Grid.Counts.array() - 1;
  for (int z = 0; z < cells(2); ++z)
  {
    progress(static_cast<double>(z) / cells(2));
    for (int y = 0; y < cells(1); ++y)
    {
      for (int x = 0; x < cells(0); ++x)
      {
        contour.AddCell(x, y, z);
      }
    }
  }
  return contour.Finish();
}

} // namespace shape
