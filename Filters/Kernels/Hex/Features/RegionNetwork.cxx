#include "Hex/Features/RegionNetwork.h"

#include "Mesh/RegionSurfaces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

void SortUnique(std::vector<int>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

/// A face of a hexahedron. Both hexahedra of a face have the same key.
struct HexFace
{
  std::array<int, 4> Key;
  int Hexahedron, Side;
};

std::vector<HexFace> SortFaces(const Eigen::MatrixXi& hexahedra)
{
  std::vector<HexFace> faces;
  faces.reserve(static_cast<std::size_t>(hexahedra.rows()) * 6);
  for (int hex = 0; hex < static_cast<int>(hexahedra.rows()); ++hex)
  {
    for (int side = 0; side < 6; ++side)
    {
      HexFace face{ {}, hex, side };
      for (int k = 0; k < 4; ++k)
      {
        face.Key[k] = hexahedra(hex, HexFaces[side][k]);
      }
      std::sort(face.Key.begin(), face.Key.end());
      faces.push_back(face);
    }
  }
  std::sort(faces.begin(), faces.end(),
    [](const HexFace& one, const HexFace& other)
    {
      return std::tie(one.Key, one.Hexahedron, one.Side) <
        std::tie(other.Key, other.Hexahedron, other.Side);
    });
  return faces;
}

} // namespace

RegionFaces FindRegionFaces(const HexMesh& mesh, const Eigen::VectorXi& regionOf)
{
  constexpr int outside = RegionSurfaces::Outside;
  const std::vector<HexFace> faces = SortFaces(mesh.Hexahedra);
  // Whether it is an interface, the labels, and the face, which faces out of the first label.
  std::vector<std::tuple<bool, int, int, const HexFace*>> found;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const HexFace* own = &faces[i];
    const bool isShared = i + 1 < faces.size() && faces[i + 1].Key == own->Key;
    int first = regionOf(own->Hexahedron), second = outside;
    if (isShared)
    {
      const HexFace* other = &faces[++i];
      second = regionOf(other->Hexahedron);
      if (second > first)
      {
        std::swap(first, second);
        own = other;
      }
    }
    if (first != second)
    {
      found.emplace_back(isShared, first, second, own);
    }
  }
  std::stable_sort(found.begin(), found.end(),
    [](const auto& one, const auto& other)
    {
      return std::tie(std::get<0>(one), std::get<1>(one), std::get<2>(one)) <
        std::tie(std::get<0>(other), std::get<1>(other), std::get<2>(other));
    });
  RegionFaces result;
  const auto count = static_cast<Eigen::Index>(found.size());
  result.Quads.resize(count, 4);
  result.Labels.resize(count, 2);
  for (Eigen::Index q = 0; q < count; ++q)
  {
    const auto& [isShared, first, second, face] = found[q];
    result.Outer += isShared ? 0 : 1;
    result.Labels.row(q) << first, second;
    for (int k = 0; k < 4; ++k)
    {
      result.Quads(q, k) = mesh.Hexahedra(face->Hexahedron, HexFaces[face->Side][k]);
    }
  }
  return result;
}

namespace
{

/// Follows the edges of a network from corner to corner.
class NetworkWalk
{
public:
  explicit NetworkWalk(const std::map<std::pair<int, int>, std::vector<int>>& labelsOf)
    : LabelsOf(labelsOf)
  {
    for (const auto& [edge, labels] : labelsOf)
    {
      this->Beside[edge.first].push_back(edge.second);
      this->Beside[edge.second].push_back(edge.first);
    }
  }

  bool IsCorner(int point) const
  {
    const std::vector<int>& others = this->Beside.at(point);
    return others.size() != 2 || this->At(point, others[0]) != this->At(point, others[1]);
  }

  std::vector<RegionNetwork::Curve> Curves()
  {
    std::vector<RegionNetwork::Curve> curves;
    // Closed curves, which have no corner, come last.
    for (const bool fromCorners : { true, false })
    {
      for (const auto& [point, others] : this->Beside)
      {
        for (const int next : others)
        {
          if (this->IsCorner(point) == fromCorners && !this->Seen.count(Sorted(point, next)))
          {
            curves.push_back(this->Follow(point, next));
          }
        }
      }
    }
    return curves;
  }

private:
  static std::pair<int, int> Sorted(int a, int b) { return { std::min(a, b), std::max(a, b) }; }
  const std::vector<int>& At(int a, int b) const { return this->LabelsOf.at(Sorted(a, b)); }

  RegionNetwork::Curve Follow(int point, int next)
  {
    RegionNetwork::Curve curve{ { point }, false, this->At(point, next) };
    const int start = point;
    this->Seen.insert(Sorted(point, next));
    while (next != start && !this->IsCorner(next))
    {
      curve.Points.push_back(next);
      const std::vector<int>& others = this->Beside.at(next);
      const int after = others[0] == point ? others[1] : others[0];
      point = next;
      next = after;
      this->Seen.insert(Sorted(point, next));
    }
    curve.Closed = next == start && !this->IsCorner(start);
    if (!curve.Closed)
    {
      curve.Points.push_back(next);
    }
    return curve;
  }

  const std::map<std::pair<int, int>, std::vector<int>>& LabelsOf;
  std::map<int, std::vector<int>> Beside;
  std::set<std::pair<int, int>> Seen;
};

} // namespace

RegionNetwork FindRegionNetwork(const Eigen::MatrixXi& polygons, const Eigen::MatrixXi& labels)
{
  // Edges of a network run between points with at least three labels: few of all.
  std::map<int, std::vector<int>> labelsAt;
  const Eigen::Index count = polygons.size() > 0 ? polygons.maxCoeff() + 1 : 0;
  Eigen::MatrixXi pairAt = Eigen::MatrixXi::Zero(count, 2);
  std::vector<char> seen(count, 0), isJunction(count, 0);
  for (Eigen::Index f = 0; f < polygons.rows(); ++f)
  {
    const Eigen::RowVector2i pair(labels.row(f).minCoeff(), labels.row(f).maxCoeff());
    for (const int point : polygons.row(f))
    {
      isJunction[point] |= seen[point] && pairAt.row(point) != pair;
      pairAt.row(point) = pair;
      seen[point] = 1;
    }
  }
  const auto k = static_cast<int>(polygons.cols());
  std::map<std::pair<int, int>, std::vector<int>> around;
  for (Eigen::Index f = 0; f < polygons.rows(); ++f)
  {
    for (int i = 0; i < k; ++i)
    {
      const int a = polygons(f, i), b = polygons(f, (i + 1) % k);
      if (isJunction[a])
      {
        labelsAt[a].insert(labelsAt[a].end(), { labels(f, 0), labels(f, 1) });
      }
      if (isJunction[a] && isJunction[b])
      {
        std::vector<int>& own = around[{ std::min(a, b), std::max(a, b) }];
        own.insert(own.end(), { labels(f, 0), labels(f, 1) });
      }
    }
  }
  for (auto edge = around.begin(); edge != around.end();)
  {
    const bool isShared = edge->second.size() > 4; // two labels of each polygon
    SortUnique(edge->second);
    edge = isShared ? std::next(edge) : around.erase(edge);
  }
  RegionNetwork network;
  NetworkWalk walk(around);
  network.Curves = walk.Curves();
  std::set<int> corners;
  for (const auto& [edge, own] : around)
  {
    for (const int point : { edge.first, edge.second })
    {
      if (walk.IsCorner(point))
      {
        corners.insert(point);
      }
    }
  }
  for (const int corner : corners)
  {
    network.Corners.push_back(corner);
    network.CornerLabels.push_back(labelsAt.at(corner));
    SortUnique(network.CornerLabels.back());
  }
  return network;
}

} // namespace shape
