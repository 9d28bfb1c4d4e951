#include "IO/PolyMesh.h"

#include "Base/Errors.h"
#include "Mesh/CellFaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

/// Corners of a face; the last is -1 in triangles.
using FaceCorners = std::array<int, 4>;

std::string Number(int cell)
{
  return std::to_string(cell);
}

void RequireSolidCells(const Eigen::VectorXi& kinds)
{
  const auto isFlat = [](int kind) { return GetDimension(kind) < 3; };
  const auto count = std::count_if(kinds.begin(), kinds.end(), isFlat);
  if (count > 0)
  {
    throw InvalidInput("the Input has " + std::to_string(count) +
      (count == 1 ? " cell" : " cells") + " without a volume (first cell " +
      std::to_string(std::find_if(kinds.begin(), kinds.end(), isFlat) - kinds.begin()) +
      "), but OpenFOAM has only solid cells; remove the others with Extract Cells By Type");
  }
}

/// Flat cells have relative volumes of any sign, up to this number. Their numbering is right.
constexpr double RoundingError = 1e-14;

/// The faces of the cells, counter-clockwise seen from outside.
class OutwardFaces
{
public:
  explicit OutwardFaces(const Cells& mesh)
    : Mesh(mesh)
    , IsTurned(mesh.Kinds.size())
  {
    for (int cell = 0; cell < static_cast<int>(mesh.Kinds.size()); ++cell)
    {
      this->IsTurned[cell] = this->ComputeRelativeVolume(cell) < -RoundingError;
    }
  }

  FaceCorners Get(int cell, int face) const
  {
    FaceCorners corners = this->GetNumbered(cell, face);
    if (this->IsTurned[cell])
    {
      std::reverse(corners.begin(), corners.begin() + Size(corners));
    }
    return corners;
  }

  static int Size(const FaceCorners& corners) { return corners[3] < 0 ? 3 : 4; }

private:
  /// Returns a face in the order of the cell's corners.
  FaceCorners GetNumbered(int cell, int face) const
  {
    FaceCorners corners = { -1, -1, -1, -1 };
    const std::vector<int>& local = GetFaces(this->Mesh.Kinds(cell))[face];
    std::transform(local.begin(), local.end(), corners.begin(),
      [&](int corner) { return this->Mesh.Corners(this->Mesh.Offsets(cell) + corner); });
    return corners;
  }

  /// Returns the volume divided by the cube of the largest distance from the first corner, by the
  /// divergence theorem. Faces have their area vectors and the means of their corners.
  double ComputeRelativeVolume(int cell) const
  {
    const Eigen::MatrixXd& points = this->Mesh.Points;
    const Eigen::RowVector3d origin = points.row(this->Mesh.Corners(this->Mesh.Offsets(cell)));
    double volume = 0.0, extent = 0.0;
    const auto count = static_cast<int>(GetFaces(this->Mesh.Kinds(cell)).size());
    for (int face = 0; face < count; ++face)
    {
      const FaceCorners corners = this->GetNumbered(cell, face);
      const int size = Size(corners);
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for (int k = 0; k < size; ++k)
      {
        sum += points.row(corners[k]) - origin;
        extent = std::max(extent, (points.row(corners[k]) - origin).norm());
      }
      // The area vector is half of this, also that of a triangle, where the last corner is 2.
      const Eigen::RowVector3d twiceArea =
        Eigen::RowVector3d(points.row(corners[2]) - points.row(corners[0]))
          .cross(Eigen::RowVector3d(points.row(corners[size - 1]) - points.row(corners[1])));
      volume += twiceArea.dot(sum) / (6.0 * size);
    }
    return volume / std::max(extent * extent * extent, std::numeric_limits<double>::min());
  }

  const Cells& Mesh;
  std::vector<bool> IsTurned;
};

/// Whether two faces with the same points have opposite normals.
bool AreOpposite(const FaceCorners& a, const FaceCorners& b)
{
  const int size = OutwardFaces::Size(a);
  const auto shift = static_cast<int>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  for (int k = 0; k < size; ++k)
  {
    if (a[k] != b[(shift - k + size) % size])
    {
      return false;
    }
  }
  return true;
}

/// A face between two cells.
struct InnerFace
{
  int Owner, Neighbour;
  int Face; ///< index of the face in the owner
};

void RequireDistinctPoints(const CellFace& face)
{
  const auto twice = std::adjacent_find(face.Points.begin(), face.Points.end());
  if (twice != face.Points.end())
  {
    throw InvalidInput("the Input's cell " + Number(face.Cell) + " has the point " +
      std::to_string(*twice) +
      " twice, which OpenFOAM does not allow; replace the cell by one "
      "with fewer corners");
  }
}

/// Returns the faces between two cells in upper-triangular order.
std::vector<InnerFace> FindInnerFaces(const Cells& mesh, const OutwardFaces& outward)
{
  const std::vector<CellFace> all = SortFaces(mesh);
  std::vector<InnerFace> inner;
  std::vector<InnerFace> crossed; // both cells are on the same side
  for (std::size_t first = 0, end = 0; first < all.size(); first = end)
  {
    RequireDistinctPoints(all[first]);
    for (end = first + 1; end < all.size() && all[end].Points == all[first].Points; ++end)
    {
    }
    if (end - first == 1)
    {
      continue;
    }
    const CellFace &a = all[first], &b = all[first + 1];
    if (end - first > 2)
    {
      throw InvalidInput(std::to_string(end - first) + " cells of the Input have the same face (" +
        Number(a.Cell) + ", " + Number(b.Cell) + " and " + Number(all[first + 2].Cell) +
        "); remove cells that are there twice, or overlap");
    }
    inner.push_back({ a.Cell, b.Cell, a.Face });
    if (!AreOpposite(outward.Get(a.Cell, a.Face), outward.Get(b.Cell, b.Face)))
    {
      crossed.push_back(inner.back());
    }
  }
  if (!crossed.empty())
  {
    throw InvalidInput("both cells of " + std::to_string(crossed.size()) +
      (crossed.size() == 1 ? " face" : " faces") + " are on the same side of it (first cells " +
      Number(crossed[0].Owner) + " and " + Number(crossed[0].Neighbour) +
      "); repair inverted cells with Shape Untangle, and remove cells that overlap");
  }
  std::sort(inner.begin(), inner.end(),
    [](const InnerFace& a, const InnerFace& b)
    { return std::tie(a.Owner, a.Neighbour) < std::tie(b.Owner, b.Neighbour); });
  return inner;
}

/// Appends a face to those that are already there.
void AddFace(PolyMesh& mesh, Eigen::Index& next, const FaceCorners& corners, int owner)
{
  mesh.Faces.row(next) = Eigen::Map<const Eigen::RowVector4i>(corners.data());
  mesh.Owners(next++) = owner;
}

void AddFaces(PolyMesh& mesh, const MeshSets& sets)
{
  const OutwardFaces outward(sets.Mesh);
  const std::vector<InnerFace> inner = FindInnerFaces(sets.Mesh, outward);
  const SolidFaces& boundary = sets.Boundary;
  const auto innerCount = static_cast<Eigen::Index>(inner.size());
  mesh.Faces.resize(innerCount + boundary.Cell.size(), 4);
  mesh.Owners.resize(mesh.Faces.rows());
  mesh.Neighbours.resize(innerCount);
  Eigen::Index next = 0;
  for (const InnerFace& face : inner)
  {
    mesh.Neighbours(next) = face.Neighbour;
    AddFace(mesh, next, outward.Get(face.Owner, face.Face), face.Owner);
  }
  const std::vector<std::vector<int>> patches = GroupFacesByPatch(sets);
  for (std::size_t patch = 0; patch < patches.size(); ++patch)
  {
    const auto first = static_cast<int>(next), count = static_cast<int>(patches[patch].size());
    for (const int face : patches[patch])
    {
      const int cell = boundary.Cell(face);
      AddFace(mesh, next, outward.Get(cell, boundary.Face(face)), cell);
    }
    if (count > 0)
    {
      mesh.Patches.push_back({ "Patch" + std::to_string(patch), first, count });
    }
  }
}

/// Removes points without a face: OpenFOAM's checkMesh calls them an error.
void RemoveUnusedPoints(PolyMesh& mesh)
{
  std::vector<int> faces(mesh.Faces.rows());
  std::iota(faces.begin(), faces.end(), 0);
  const std::vector<int> used = PointsOf(mesh.Faces, faces);
  Eigen::VectorXi numbers = Eigen::VectorXi::Constant(mesh.Points.rows(), -1);
  numbers(used) = Eigen::VectorXi::LinSpaced(
    static_cast<Eigen::Index>(used.size()), 0, static_cast<int>(used.size()) - 1);
  for (int& corner : mesh.Faces.reshaped())
  {
    corner = corner < 0 ? corner : numbers(corner);
  }
  mesh.Points = mesh.Points(used, Eigen::all).eval();
}

void AddZones(PolyMesh& mesh, const Eigen::VectorXi& regions)
{
  std::map<int, CellZone> cells;
  for (int cell = 0; cell < mesh.CellCount; ++cell)
  {
    cells[regions(cell)].Cells.push_back(cell);
  }
  for (auto& [region, zone] : cells)
  {
    zone.Name = "Region" + std::to_string(region);
    mesh.CellZones.push_back(std::move(zone));
  }
  std::map<std::pair<int, int>, FaceZone> interfaces;
  for (int face = 0; face < static_cast<int>(mesh.Neighbours.size()); ++face)
  {
    const int inside = regions(mesh.Owners(face)), outside = regions(mesh.Neighbours(face));
    if (inside != outside)
    {
      FaceZone& zone = interfaces[std::minmax(inside, outside)];
      zone.Faces.push_back(face);
      zone.Flips.push_back(inside > outside);
    }
  }
  for (auto& [pair, zone] : interfaces)
  {
    zone.Name = "Interface" + std::to_string(pair.first) + "_" + std::to_string(pair.second);
    mesh.FaceZones.push_back(std::move(zone));
  }
}

} // namespace

PolyMesh MakePolyMesh(const MeshSets& sets, const Progress& progress)
{
  RequireSolidCells(sets.Mesh.Kinds);
  PolyMesh mesh;
  mesh.CellCount = static_cast<int>(sets.Mesh.Kinds.size());
  mesh.Points = sets.Mesh.Points;
  AddFaces(mesh, sets);
  progress(0.8);
  RemoveUnusedPoints(mesh);
  AddZones(mesh, sets.Regions);
  progress(1.0);
  return mesh;
}

} // namespace shape
