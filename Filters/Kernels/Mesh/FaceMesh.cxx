#include "Mesh/FaceMesh.h"

#include "Base/Errors.h"
#include "Mesh/CellFaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace shape
{

namespace
{

/// The faces of all cells, each from its own side.
struct CellPolygons
{
  std::vector<int> Offsets = { 0 }, Corners, Cells;

  template <typename Range>
  void Add(const Range& corners, int cell)
  {
    this->Corners.insert(this->Corners.end(), std::begin(corners), std::end(corners));
    this->Offsets.push_back(static_cast<int>(this->Corners.size()));
    this->Cells.push_back(cell);
  }
  int Count() const { return static_cast<int>(this->Cells.size()); }
  int Begin(int face) const { return this->Offsets[face]; }
  int End(int face) const { return this->Offsets[face + 1]; }
};

/// Returns the area vector of a polygon, twice as long as its area, and its mean corner.
std::pair<Eigen::RowVector3d, Eigen::RowVector3d> AreaAndMean(
  const CellPolygons& polygons, int face, const Eigen::MatrixXd& points)
{
  Eigen::RowVector3d mean = Eigen::RowVector3d::Zero(), area = Eigen::RowVector3d::Zero();
  const int begin = polygons.Begin(face), end = polygons.End(face);
  for (int k = begin; k < end; ++k)
  {
    mean += points.row(polygons.Corners[k]);
  }
  mean /= end - begin;
  for (int k = begin; k < end; ++k)
  {
    const Eigen::RowVector3d a = points.row(polygons.Corners[k]) - mean;
    const Eigen::RowVector3d b = points.row(polygons.Corners[k + 1 == end ? begin : k + 1]) - mean;
    area += a.cross(b);
  }
  return { area, mean };
}

/// Turns the faces of polyhedra that face the centre of their cell, and those of wedges with a
/// negative volume. Returns 1 for each such wedge.
std::vector<char> TurnOutwards(CellPolygons& polygons, const Cells& cells)
{
  std::vector<char> turned(cells.Kinds.size(), 0);
  const auto turn = [&](int face)
  {
    std::reverse(polygons.Corners.begin() + polygons.Begin(face),
      polygons.Corners.begin() + polygons.End(face));
  };
  int next = 0;
  for (int cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    const int first = next;
    while (next < polygons.Count() && polygons.Cells[next] == cell)
    {
      ++next;
    }
    const bool isPolyhedron = cells.Kinds(cell) == PolyhedronKind;
    if (!isPolyhedron && cells.Kinds(cell) != cell_kind::Wedge)
    {
      continue;
    }
    Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
    for (int face = first; face < next; ++face)
    {
      centre += AreaAndMean(polygons, face, cells.Points).second / (next - first);
    }
    double volume = 0.0;
    for (int face = first; face < next; ++face)
    {
      const auto [area, mean] = AreaAndMean(polygons, face, cells.Points);
      const double share = area.dot(mean - centre);
      volume += share;
      if (isPolyhedron && share < 0.0)
      {
        turn(face);
      }
    }
    turned[cell] = !isPolyhedron && volume < 0.0 ? 1 : 0;
    for (int face = first; face < next && turned[cell] != 0; ++face)
    {
      turn(face);
    }
  }
  return turned;
}

CellPolygons CollectPolygons(const Cells& cells, const std::vector<std::vector<int>>& polyhedra)
{
  CellPolygons polygons;
  std::size_t polyhedron = 0;
  std::vector<int> corners;
  for (int cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    if (cells.Kinds(cell) == PolyhedronKind && polyhedron < polyhedra.size())
    {
      const std::vector<int>& stream = polyhedra[polyhedron++];
      for (std::size_t k = 0; k < stream.size(); k += stream[k] + 1)
      {
        if (stream[k] < 0 || k + stream[k] + 1 > stream.size())
        {
          throw InvalidInput("the list of faces of cell " + std::to_string(cell) +
            " is not complete; repair the mesh with Clean to Grid");
        }
        corners.assign(stream.begin() + static_cast<std::ptrdiff_t>(k) + 1,
          stream.begin() + static_cast<std::ptrdiff_t>(k) + 1 + stream[k]);
        polygons.Add(corners, cell);
      }
      continue;
    }
    const auto& faces = GetFaces(cells.Kinds(cell));
    if (faces.empty())
    {
      throw InvalidInput("cell " + std::to_string(cell) +
        " is not a tetrahedron, pyramid, wedge, hexahedron or polyhedron; remove such cells with "
        "Extract Cells By Type");
    }
    for (const std::vector<int>& face : faces)
    {
      corners.clear();
      for (const int corner : face)
      {
        corners.push_back(cells.Corners(cells.Offsets(cell) + corner));
      }
      polygons.Add(corners, cell);
    }
  }
  return polygons;
}

void RequirePolygons(const CellPolygons& polygons, Eigen::Index points)
{
  if (polygons.Cells.empty())
  {
    throw InvalidInput("there is no solid cell; fill a surface with Shape Tetrahedralize");
  }
  for (int face = 0; face < polygons.Count(); ++face)
  {
    const int count = polygons.End(face) - polygons.Begin(face);
    const auto first = polygons.Corners.begin() + polygons.Begin(face);
    if (count < 3 ||
      std::any_of(first, first + count, [&](int corner) { return corner < 0 || corner >= points; }))
    {
      throw InvalidInput("cell " + std::to_string(polygons.Cells[face]) +
        " has a face without three corners, or a corner that is not a point; repair the mesh with "
        "Clean to Grid");
    }
  }
}

} // namespace

FaceMesh BuildFaceMesh(const Cells& cells, const std::vector<std::vector<int>>& polyhedra)
{
  CellPolygons polygons = CollectPolygons(cells, polyhedra);
  RequirePolygons(polygons, cells.Points.rows());
  FaceMesh mesh;
  mesh.CellCount = static_cast<int>(cells.Kinds.size());
  mesh.Turned = TurnOutwards(polygons, cells);
  // Faces with the same lowest corner are compared by their sorted corners.
  std::vector<int> counts(cells.Points.rows() + 1, 0), lowest(polygons.Count());
  for (int face = 0; face < polygons.Count(); ++face)
  {
    lowest[face] = *std::min_element(polygons.Corners.begin() + polygons.Begin(face),
      polygons.Corners.begin() + polygons.End(face));
    ++counts[lowest[face] + 1];
  }
  for (std::size_t i = 1; i < counts.size(); ++i)
  {
    counts[i] += counts[i - 1];
  }
  std::vector<int> order(polygons.Count()), filled(counts.begin(), counts.end() - 1);
  for (int face = 0; face < polygons.Count(); ++face)
  {
    order[filled[lowest[face]]++] = face;
  }
  std::vector<std::pair<std::vector<int>, int>> bucket;
  for (std::size_t i = 0; i + 1 < counts.size(); ++i)
  {
    bucket.clear();
    for (int k = counts[i]; k < counts[i + 1]; ++k)
    {
      const int face = order[k];
      bucket.emplace_back(std::vector<int>(polygons.Corners.begin() + polygons.Begin(face),
                            polygons.Corners.begin() + polygons.End(face)),
        face);
      std::sort(bucket.back().first.begin(), bucket.back().first.end());
    }
    // Equal faces are ordered by cell, so the first is the owner's.
    std::sort(bucket.begin(), bucket.end());
    for (std::size_t k = 0; k < bucket.size();)
    {
      std::size_t end = k + 1;
      while (end < bucket.size() && bucket[end].first == bucket[k].first)
      {
        ++end;
      }
      if (end - k > 2)
      {
        throw InvalidInput("the cells " + std::to_string(polygons.Cells[bucket[k].second]) + ", " +
          std::to_string(polygons.Cells[bucket[k + 1].second]) + " and " +
          std::to_string(polygons.Cells[bucket[k + 2].second]) +
          " have one face; a face has two cells at most: remove copies of cells");
      }
      const int face = bucket[k].second;
      mesh.Corners.insert(mesh.Corners.end(), polygons.Corners.begin() + polygons.Begin(face),
        polygons.Corners.begin() + polygons.End(face));
      mesh.Offsets.push_back(static_cast<int>(mesh.Corners.size()));
      mesh.Owners.push_back(polygons.Cells[face]);
      mesh.Neighbours.push_back(end - k == 2 ? polygons.Cells[bucket[k + 1].second] : -1);
      k = end;
    }
  }
  return mesh;
}

Eigen::MatrixXi TriangulateBoundary(const FaceMesh& faces)
{
  std::vector<Eigen::RowVector3i> triangles;
  for (int face = 0; face < faces.FaceCount(); ++face)
  {
    if (faces.Neighbours[face] >= 0)
    {
      continue;
    }
    const int begin = faces.Offsets[face], count = faces.Offsets[face + 1] - begin;
    const auto first = faces.Corners.begin() + begin;
    const auto lowest = static_cast<int>(std::min_element(first, first + count) - first);
    const auto corner = [&](int k) { return faces.Corners[begin + (lowest + k) % count]; };
    for (int k = 1; k + 1 < count; ++k)
    {
      triangles.emplace_back(corner(0), corner(k), corner(k + 1));
    }
  }
  Eigen::MatrixXi rows(triangles.size(), 3);
  for (Eigen::Index t = 0; t < rows.rows(); ++t)
  {
    rows.row(t) = triangles[t];
  }
  return rows;
}

} // namespace shape
