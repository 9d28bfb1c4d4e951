#include "Hex/Features/RegionNetwork.h"

#include "Hex/Features/Private/CurveResampling.h"
#include "Mesh/RegionSurfaces.h"
#include "Mesh/UsedPoints.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
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

namespace
{

/// Assigns the curves and corners of hexahedra to those of surfaces.
class NetworkMatch
{
public:
  NetworkMatch(const HexMesh& mesh, const Mesh& surfaces, const RegionNetwork& own,
    const RegionNetwork& wanted, RegionMatch& match)
    : Grid(mesh)
    , Surfaces(surfaces)
    , Own(own)
    , Wanted(wanted)
    , Match(match)
  {
    match.Curves = static_cast<int>(wanted.Curves.size());
    match.Corners = static_cast<int>(wanted.Corners.size());
  }

  void MatchCorners()
  {
    // The closest pairs first.
    std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
    for (std::size_t i = 0; i < this->Own.Corners.size(); ++i)
    {
      for (std::size_t j = 0; j < this->Wanted.Corners.size(); ++j)
      {
        if (this->Own.CornerLabels[i] == this->Wanted.CornerLabels[j])
        {
          pairs.emplace_back((this->Grid.Points.row(this->Own.Corners[i]) -
                               this->Surfaces.Points.row(this->Wanted.Corners[j]))
                               .norm(),
            i, j);
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    std::set<int> taken;
    for (const auto& [distance, i, j] : pairs)
    {
      const int point = this->Own.Corners[i], corner = this->Wanted.Corners[j];
      if (!this->CornerOf.count(point) && taken.insert(corner).second)
      {
        this->CornerOf[point] = corner;
        this->Put(point, this->Surfaces.Points.row(corner), this->Surfaces.Points.row(corner));
        ++this->Match.CornersKept;
      }
    }
  }

  void MatchCurves()
  {
    std::vector<char> taken(this->Wanted.Curves.size(), 0);
    std::vector<const RegionNetwork::Curve*> others;
    for (const RegionNetwork::Curve& chain : this->Own.Curves)
    {
      const int curve = this->FindCurve(chain, taken);
      if (curve < 0)
      {
        others.push_back(&chain);
        continue;
      }
      taken[curve] = 1;
      ++this->Match.CurvesKept;
      this->Distribute(chain, this->Wanted.Curves[curve]);
    }
    for (const RegionNetwork::Curve* chain : others)
    {
      this->PutOnClosest(*chain);
    }
  }

private:
  void Put(int point, const Eigen::RowVector3d& position, const Eigen::MatrixXd& span)
  {
    this->Match.Boundary.Starts.emplace_back(point, position);
    this->Match.Boundary.Spans[point] = span;
  }

  int CornerAt(int point) const
  {
    const auto found = this->CornerOf.find(point);
    return found == this->CornerOf.end() ? -1 : found->second;
  }

  /// Returns the closest free curve with the labels and ends of a chain, or -1.
  int FindCurve(const RegionNetwork::Curve& chain, const std::vector<char>& taken) const
  {
    int best = -1;
    double minimum = std::numeric_limits<double>::infinity();
    const Eigen::RowVector3d middle = this->Grid.Points(chain.Points, Eigen::all).colwise().mean();
    for (std::size_t i = 0; i < this->Wanted.Curves.size(); ++i)
    {
      const RegionNetwork::Curve& curve = this->Wanted.Curves[i];
      if (taken[i] || curve.Labels != chain.Labels || curve.Closed != chain.Closed)
      {
        continue;
      }
      if (!chain.Closed)
      {
        const int begin = this->CornerAt(chain.Points.front()),
                  end = this->CornerAt(chain.Points.back());
        const int front = curve.Points.front(), back = curve.Points.back();
        if (!(begin == front && end == back) && !(begin == back && end == front))
        {
          continue;
        }
      }
      const double distance =
        (this->Surfaces.Points(curve.Points, Eigen::all).colwise().mean() - middle).norm();
      if (distance < minimum)
      {
        minimum = distance;
        best = static_cast<int>(i);
      }
    }
    return best;
  }

  void Distribute(const RegionNetwork::Curve& chain, const RegionNetwork::Curve& curve)
  {
    FeatureCurve along;
    along.Points = curve.Points;
    along.Closed = curve.Closed;
    const CurvePositions positions =
      DistributeAlongCurve(this->Grid.Points(chain.Points, Eigen::all), this->Surfaces, along);
    for (std::size_t i = 0; i < chain.Points.size(); ++i)
    {
      if (!this->CornerOf.count(chain.Points[i]))
      {
        this->Put(chain.Points[i], positions.Positions.row(static_cast<Eigen::Index>(i)),
          positions.Spans[i]);
      }
    }
  }

  /// Puts the points of a chain, but not corners, on the closest part of a curve with its labels.
  void PutOnClosest(const RegionNetwork::Curve& chain)
  {
    for (const int point : chain.Points)
    {
      if (this->Match.Boundary.Spans.count(point) ||
        std::binary_search(this->Own.Corners.begin(), this->Own.Corners.end(), point))
      {
        continue;
      }
      const Eigen::RowVector3d position = this->Grid.Points.row(point);
      const RegionNetwork::Curve* best = nullptr;
      Eigen::Index at = 0;
      double minimum = std::numeric_limits<double>::infinity();
      for (const RegionNetwork::Curve& curve : this->Wanted.Curves)
      {
        Eigen::Index nearest = 0;
        const double distance = curve.Labels != chain.Labels
          ? minimum
          : (this->Surfaces.Points(curve.Points, Eigen::all).rowwise() - position)
              .rowwise()
              .squaredNorm()
              .minCoeff(&nearest);
        if (distance < minimum)
        {
          minimum = distance;
          best = &curve;
          at = nearest;
        }
      }
      if (best)
      {
        constexpr Eigen::Index reach = 3; // edges of the curve to either side
        const Eigen::Index last = static_cast<Eigen::Index>(best->Points.size()) - 1;
        std::vector<int> span;
        for (Eigen::Index i = std::max<Eigen::Index>(at - reach, 0);
             i <= std::min(at + reach, last); ++i)
        {
          span.push_back(best->Points[i]);
        }
        this->Put(point, this->Surfaces.Points.row(best->Points[at]),
          this->Surfaces.Points(span, Eigen::all));
      }
    }
  }

  const HexMesh& Grid;
  const Mesh& Surfaces;
  const RegionNetwork& Own;
  const RegionNetwork& Wanted;
  RegionMatch& Match;
  std::map<int, int> CornerOf; ///< the corner of the surfaces at each matched point
};

/// Adds a patch for each pair of labels, and the quads that lie on it.
void AddPatches(const RegionFaces& faces, const Mesh& surfaces, const Eigen::MatrixXi& labels,
  PatchedBoundary& boundary)
{
  std::map<std::pair<int, int>, std::vector<int>> trianglesOf;
  for (int t = 0; t < static_cast<int>(labels.rows()); ++t)
  {
    trianglesOf[{ labels.row(t).minCoeff(), labels.row(t).maxCoeff() }].push_back(t);
  }
  std::map<std::pair<int, int>, int> patchOf;
  for (const auto& [pair, triangles] : trianglesOf)
  {
    patchOf[pair] = static_cast<int>(boundary.Patches.size());
    Mesh patch{ surfaces.Points, surfaces.Triangles(triangles, Eigen::all) };
    const std::vector<int> used = FindUsedPoints(patch.Triangles, patch.Points.rows());
    patch.Triangles = RenumberPoints(patch.Triangles, used, surfaces.Points.rows());
    patch.Points = surfaces.Points(used, Eigen::all);
    boundary.Patches.emplace_back(std::move(patch));
  }
  std::vector<int> own, patches;
  for (int q = 0; q < static_cast<int>(faces.Quads.rows()); ++q)
  {
    const auto found =
      patchOf.find({ faces.Labels.row(q).minCoeff(), faces.Labels.row(q).maxCoeff() });
    if (found != patchOf.end())
    {
      own.push_back(q);
      patches.push_back(found->second);
    }
  }
  boundary.Quads = faces.Quads(own, Eigen::all);
  boundary.PatchOf =
    Eigen::Map<Eigen::VectorXi>(patches.data(), static_cast<Eigen::Index>(patches.size()));
}

} // namespace

RegionMatch MatchRegions(const HexMesh& mesh, const RegionFaces& faces, const Mesh& surfaces,
  const Eigen::MatrixXi& labels)
{
  RegionMatch match;
  AddPatches(faces, surfaces, labels, match.Boundary);
  const RegionNetwork own = FindRegionNetwork(faces.Quads, faces.Labels),
                      wanted = FindRegionNetwork(surfaces.Triangles, labels);
  NetworkMatch networks(mesh, surfaces, own, wanted, match);
  networks.MatchCorners();
  networks.MatchCurves();
  return match;
}

} // namespace shape
