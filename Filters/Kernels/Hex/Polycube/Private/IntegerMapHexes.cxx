#include "Hex/Polycube/Private/IntegerMapHexes.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shape
{
namespace
{

/// The tolerance for a position outside a tetrahedron to be inside, for rounding.
constexpr double Rounding = 1e-9;

} // namespace

TetrahedralWalk::TetrahedralWalk(const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra)
  : Points(points)
  , Tetrahedra(tetrahedra)
  , Neighbours(tetrahedra.rows(), { -1, -1, -1, -1 })
{
  using Face = std::pair<std::array<int, 3>, std::array<int, 2>>;
  std::vector<Face> faces;
  for (int t = 0; t < tetrahedra.rows(); ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      std::array<int, 3> corners = { tetrahedra(t, (k + 1) % 4), tetrahedra(t, (k + 2) % 4),
        tetrahedra(t, (k + 3) % 4) };
      std::sort(corners.begin(), corners.end());
      faces.push_back({ corners, { t, k } });
    }
  }
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 0; i + 1 < faces.size(); ++i)
  {
    if (faces[i].first == faces[i + 1].first)
    {
      const auto [t, k] = faces[i].second;
      const auto [u, l] = faces[i + 1].second;
      this->Neighbours[t][k] = u;
      this->Neighbours[u][l] = t;
    }
  }
}

Eigen::Vector4d TetrahedralWalk::Weights(int tetrahedron, const Eigen::Vector3d& position) const
{
  const auto c = this->Tetrahedra.row(tetrahedron);
  const Eigen::Vector3d origin = this->Points.row(c(0)).transpose();
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k)
  {
    edges.col(k) = this->Points.row(c(k + 1)).transpose() - origin;
  }
  Eigen::Vector4d weights;
  weights.tail<3>() = edges.inverse() * (position - origin);
  weights(0) = 1.0 - weights.tail<3>().sum();
  return weights;
}

TetrahedralWalk::Position TetrahedralWalk::Go(
  int tetrahedron, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const
{
  int entered = -2; // no face yet; -1 would be the outside
  // A straight line meets each tetrahedron of its sheet once; rounding may add a few.
  for (Eigen::Index step = 0; step <= this->Tetrahedra.rows(); ++step)
  {
    const Eigen::Vector4d end = this->Weights(tetrahedron, to);
    const Eigen::Vector4d begin = this->Weights(tetrahedron, from);
    int exit = -1;
    double minimum = 2.0;
    for (int k = 0; k < 4; ++k)
    {
      // The face by which the line leaves is the first that it crosses. It never goes back through
      // the face by which it came, where rounding could make the weight negative.
      if (end(k) < -Rounding && this->Neighbours[tetrahedron][k] != entered)
      {
        const double share = begin(k) / (begin(k) - end(k));
        if (end(k) < begin(k) && share < minimum)
        {
          minimum = share;
          exit = k;
        }
      }
    }
    const bool arrived = exit < 0;
    const int next = arrived ? -1 : this->Neighbours[tetrahedron][exit];
    if (next < 0)
    {
      Eigen::Vector4d weights =
        arrived ? end : Eigen::Vector4d(begin + std::clamp(minimum, 0.0, 1.0) * (end - begin));
      weights = weights.cwiseMax(0.0);
      return { tetrahedron, weights / weights.sum(), arrived, exit };
    }
    entered = tetrahedron;
    tetrahedron = next;
  }
  return { tetrahedron, Eigen::Vector4d::Constant(0.25), false, -1 };
}

namespace
{

/// An offset from the centres of cells, so that hardly any lies on the face of a tetrahedron.
const Eigen::Vector3d Offset(1.1e-4, 1.7e-4, 2.3e-4);

/// The corners of a cell in the order of HexMesh.
constexpr int CornerPositions[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 },
  { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };

using Cell = std::array<int, 3>;

/// A cell of the grid as it is found in one tetrahedron.
struct Visit
{
  Cell Where;
  int Tetrahedron;
};

Eigen::Vector3d Centre(const Cell& cell)
{
  return Eigen::Vector3d(cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5) + Offset;
}

/// Finds the tetrahedra that contain the centre of a cell. A cell occurs once for each sheet of the
/// map that covers it.
std::vector<Visit> FindCells(
  const Eigen::MatrixXd& images, const Eigen::MatrixXi& tetrahedra, const TetrahedralWalk& walk)
{
  std::vector<Visit> visits;
  for (int t = 0; t < tetrahedra.rows(); ++t)
  {
    Eigen::Vector3d low = images.row(tetrahedra(t, 0)).transpose(), high = low;
    for (int k = 1; k < 4; ++k)
    {
      low = low.cwiseMin(images.row(tetrahedra(t, k)).transpose());
      high = high.cwiseMax(images.row(tetrahedra(t, k)).transpose());
    }
    Cell first, last;
    for (int k = 0; k < 3; ++k)
    {
      first[k] = static_cast<int>(std::ceil(low(k) - 0.5 - Offset(k)));
      last[k] = static_cast<int>(std::floor(high(k) - 0.5 - Offset(k)));
    }
    for (int z = first[2]; z <= last[2]; ++z)
    {
      for (int y = first[1]; y <= last[1]; ++y)
      {
        for (int x = first[0]; x <= last[0]; ++x)
        {
          const Cell cell = { x, y, z };
          if (walk.Weights(t, Centre(cell)).minCoeff() > 0.0)
          {
            visits.push_back({ cell, t });
          }
        }
      }
    }
  }
  std::sort(visits.begin(), visits.end(),
    [](const Visit& a, const Visit& b)
    { return std::tie(a.Where, a.Tetrahedron) < std::tie(b.Where, b.Tetrahedron); });
  return visits;
}

/// Returns the cell next to `visit` along an axis, or -1 if the boundary is in between.
int CellBeside(
  const std::vector<Visit>& visits, const Visit& visit, int axis, const TetrahedralWalk& walk)
{
  Cell next = visit.Where;
  ++next[axis];
  const auto position = walk.Go(visit.Tetrahedron, Centre(visit.Where), Centre(next));
  if (!position.Arrived)
  {
    return -1;
  }
  const auto found =
    std::lower_bound(visits.begin(), visits.end(), Visit{ next, position.Tetrahedron },
      [](const Visit& a, const Visit& b)
      { return std::tie(a.Where, a.Tetrahedron) < std::tie(b.Where, b.Tetrahedron); });
  if (found != visits.end() && found->Where == next && found->Tetrahedron == position.Tetrahedron)
  {
    return static_cast<int>(found - visits.begin());
  }
  throw SolveFailure(
    "the cells of the polycube do not fit together, because its map is not accurate enough; give a "
    "Polycube made by Shape Polycube with another Compactness, or choose Method Grid");
}

} // namespace

// 1. FindCells: each visit of a cell's centre by a tetrahedron is one hexahedron.
// 2. Walks between the centres of adjacent cells find the neighbours of each hexahedron, and their
//    common corners are merged.
// 3. A walk from the centre to each corner finds the corner's tetrahedron and its barycentric
//    coordinates, by which it is mapped back.
IntegerMapHexesResult ExtractIntegerMapHexahedra(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& images, const Eigen::MatrixXi& tetrahedra)
{
  const TetrahedralWalk walk(images, tetrahedra);
  const std::vector<Visit> visits = FindCells(images, tetrahedra, walk);
  if (visits.empty())
  {
    throw SolveFailure("the polycube has no cell; use a smaller CellSize");
  }
  const int cells = static_cast<int>(visits.size());
  DisjointSets joined(8 * cells);
  for (int cell = 0; cell < cells; ++cell)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int other = CellBeside(visits, visits[cell], axis, walk);
      for (int corner = 0; other >= 0 && corner < 8; ++corner)
      {
        if (CornerPositions[corner][axis] == 1)
        {
          // The next cell has the same point at the corner with 0 instead of 1 along the axis.
          Cell opposite = { CornerPositions[corner][0], CornerPositions[corner][1],
            CornerPositions[corner][2] };
          opposite[axis] = 0;
          const int same = static_cast<int>(
            std::find_if(std::begin(CornerPositions), std::end(CornerPositions),
              [&](const int* at) { return std::equal(opposite.begin(), opposite.end(), at); }) -
            std::begin(CornerPositions));
          joined.Merge(8 * other + same, 8 * cell + corner);
        }
      }
    }
  }
  IntegerMapHexesResult result;
  result.Solid.Hexahedra.resize(cells, 8);
  std::vector<int> number(8 * cells, -1);
  std::vector<std::array<int, 2>> corners;
  for (int i = 0; i < 8 * cells; ++i)
  {
    int& point = number[joined.Find(i)];
    if (point < 0)
    {
      point = static_cast<int>(corners.size());
      corners.push_back({ i / 8, i % 8 });
    }
    result.Solid.Hexahedra(i / 8, i % 8) = point;
  }
  const Eigen::Index count = static_cast<Eigen::Index>(corners.size());
  result.Solid.Points.resize(count, 3);
  result.Positions.resize(count, 3);
  result.Tetrahedra.resize(count);
  result.Weights.resize(count, 4);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const auto [cell, corner] = corners[i];
    Eigen::Vector3d position;
    for (int k = 0; k < 3; ++k)
    {
      position(k) = visits[cell].Where[k] + CornerPositions[corner][k];
    }
    // A corner may lie on the boundary: a walk that rounding ends just before it is clamped to it.
    const auto there = walk.Go(visits[cell].Tetrahedron, Centre(visits[cell].Where), position);
    result.Positions.row(i) = position.transpose();
    result.Tetrahedra(i) = there.Tetrahedron;
    result.Weights.row(i) = there.Weights.transpose();
    result.Solid.Points.row(i).setZero();
    for (int k = 0; k < 4; ++k)
    {
      result.Solid.Points.row(i) += there.Weights(k) * points.row(tetrahedra(there.Tetrahedron, k));
    }
  }
  for (int i = 1; i < cells; ++i)
  {
    // Visits are sorted by cell: repeats of a cell are adjacent.
    result.Overlaps = result.Overlaps || visits[i].Where == visits[i - 1].Where;
  }
  return result;
}

} // namespace shape
