#include "Solidify/Private/ContactSplit.h"

#include "Planar/TriangleSplit.h"
#include "Solidify/Private/TriangleContacts.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;
using Edge = std::array<int, 2>; // ascending

/// Shares are multiples of this, so that they and their complements are exact.
constexpr double Step = 0x1p-50;

double RoundShare(double share)
{
  return std::clamp(std::round(share / Step) * Step, Step, 1.0 - Step);
}

/// The contacts on an edge from its first to its second point, as (share, point).
using EdgePoints = std::vector<std::pair<double, int>>;

class Splitter
{
public:
  Splitter(const Mesh& surface, TriangleContacts contacts)
    : Surface(surface)
    , Contacts(std::move(contacts))
    , Sources(this->Contacts.Points.size() - surface.Points.rows(), { -1, {} })
  {
    for (std::size_t point = 0; point < this->Contacts.Points.size(); ++point)
    {
      this->First.push_back(static_cast<int>(point));
    }
    for (const auto& [edge, points] : this->Contacts.OnEdge)
    {
      this->OnEdge[edge] = this->Order(edge, points);
    }
  }

  void Add(int triangle)
  {
    const Eigen::RowVector3i corners = this->Surface.Triangles.row(triangle);
    this->Numbers.clear();
    this->Barycentric.clear();
    for (int k = 0; k < 3; ++k)
    {
      this->AddPoint(corners(k), RowVector3d::Unit(k));
      this->AddEdge(corners, k);
    }
    const auto outline = static_cast<int>(this->Numbers.size());
    if (const auto inside = this->Contacts.Inside.find(triangle);
        inside != this->Contacts.Inside.end())
    {
      for (const int point : inside->second)
      {
        this->AddInside(triangle, this->First[point]);
      }
    }
    const std::vector<std::array<int, 2>> chords = this->ChordsOf(triangle);
    if (this->Numbers.size() == 3)
    {
      this->AddTriangle(corners, triangle);
      return;
    }
    Eigen::MatrixXd points(static_cast<Eigen::Index>(this->Numbers.size()), 3);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      points.row(i) = this->Barycentric[i];
      this->Trace(this->Numbers[i], triangle, points.row(i));
    }
    const Eigen::Matrix3d positions = GetCorners(this->Surface, triangle);
    const TriangleSplit split = SplitTriangle(positions, points, outline, chords);
    for (const auto& added : split.Added.rowwise())
    {
      this->Numbers.push_back(static_cast<int>(this->Contacts.Points.size()));
      this->First.push_back(this->Numbers.back());
      this->Contacts.Points.emplace_back(added * positions);
      this->Sources.emplace_back(triangle, added);
    }
    for (const auto& part : split.Triangles.rowwise())
    {
      this->AddTriangle(part.unaryExpr([&](int point) { return this->Numbers[point]; }), triangle);
    }
  }

  SplitContacts Finish() const
  {
    const Eigen::Index before = this->Surface.Points.rows();
    SplitContacts split;
    split.Surface = { Eigen::MatrixXd(static_cast<Eigen::Index>(this->Contacts.Points.size()), 3),
      Eigen::MatrixXi(static_cast<Eigen::Index>(this->Triangles.size()), 3) };
    for (Eigen::Index i = 0; i < split.Surface.Points.rows(); ++i)
    {
      split.Surface.Points.row(i) = this->Contacts.Points[i];
    }
    for (Eigen::Index t = 0; t < split.Surface.Triangles.rows(); ++t)
    {
      split.Surface.Triangles.row(t) = this->Triangles[t];
    }
    ProvenanceWriter writer(before);
    writer.AddCopies(before);
    for (const auto& [triangle, barycentric] : this->Sources)
    {
      triangle < 0 ? writer.AddNone(1)
                   : writer.AddOnTriangle(this->Surface.Triangles.row(triangle), barycentric);
    }
    split.Provenance = writer.Finish(
      Eigen::Map<const Eigen::VectorXi>(this->Parents.data(), split.Surface.Triangles.rows()));
    return split;
  }

private:
  /// Sorts contacts along an edge. Of contacts with the same share, only the first remains.
  EdgePoints Order(const Edge& edge, const std::vector<int>& points)
  {
    const RowVector3d begin = this->Surface.Points.row(edge[0]);
    const RowVector3d along = this->Surface.Points.row(edge[1]) - begin;
    EdgePoints ordered;
    for (const int point : points)
    {
      const double share = (this->Contacts.Points[point] - begin).dot(along) / along.squaredNorm();
      ordered.emplace_back(RoundShare(share), point);
    }
    std::sort(ordered.begin(), ordered.end());
    EdgePoints different;
    for (const auto& [share, point] : ordered)
    {
      if (!different.empty() && different.back().first == share)
      {
        this->First[point] = different.back().second;
        continue;
      }
      different.emplace_back(share, point);
    }
    return different;
  }

  void AddPoint(int point, const RowVector3d& barycentric)
  {
    this->Numbers.push_back(point);
    this->Barycentric.push_back(barycentric);
  }

  /// Adds the contacts on the edge from corner k.
  void AddEdge(const Eigen::RowVector3i& corners, int k)
  {
    const int begin = corners(k), end = corners((k + 1) % 3);
    const auto found = this->OnEdge.find({ std::min(begin, end), std::max(begin, end) });
    if (found == this->OnEdge.end())
    {
      return;
    }
    const EdgePoints& points = found->second;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const auto& [share, point] = points[begin < end ? i : points.size() - 1 - i];
      RowVector3d barycentric = RowVector3d::Zero();
      barycentric(k) = begin < end ? 1.0 - share : share;
      barycentric((k + 1) % 3) = 1.0 - barycentric(k);
      this->AddPoint(point, barycentric);
    }
  }

  void AddInside(int triangle, int point)
  {
    if (std::find(this->Numbers.begin(), this->Numbers.end(), point) != this->Numbers.end())
    {
      return;
    }
    const Eigen::Matrix3d corners = GetCorners(this->Surface, triangle);
    Eigen::Matrix<double, 3, 2> edges;
    edges << (corners.row(1) - corners.row(0)).transpose(),
      (corners.row(2) - corners.row(0)).transpose();
    const Eigen::Vector2d shares = edges.colPivHouseholderQr().solve(
      (this->Contacts.Points[point] - corners.row(0)).transpose());
    const double first = std::min(RoundShare(shares(0)), 1.0 - 2.0 * Step);
    const double second = std::min(RoundShare(shares(1)), 1.0 - first - Step);
    this->AddPoint(point, { 1.0 - first - second, first, second });
  }

  /// The segments of a triangle that do not lie on its edges, as pairs of its points.
  std::vector<std::array<int, 2>> ChordsOf(int triangle) const
  {
    std::vector<std::array<int, 2>> chords;
    const auto found = this->Contacts.Segments.find(triangle);
    if (found == this->Contacts.Segments.end())
    {
      return chords;
    }
    for (const auto& segment : found->second)
    {
      std::array<int, 2> ends{};
      for (const int i : { 0, 1 })
      {
        ends[i] = static_cast<int>(
          std::find(this->Numbers.begin(), this->Numbers.end(), this->First[segment[i]]) -
          this->Numbers.begin());
      }
      std::sort(ends.begin(), ends.end());
      const bool isKnown = ends[1] < static_cast<int>(this->Numbers.size());
      if (!isKnown || ends[0] == ends[1] ||
        (this->Barycentric[ends[0]].array() == 0.0 && this->Barycentric[ends[1]].array() == 0.0)
          .any())
      {
        continue;
      }
      chords.push_back(ends);
    }
    std::sort(chords.begin(), chords.end());
    chords.erase(std::unique(chords.begin(), chords.end()), chords.end());
    return chords;
  }

  void Trace(int point, int triangle, const RowVector3d& barycentric)
  {
    const Eigen::Index index = point - this->Surface.Points.rows();
    if (index >= 0 && this->Sources[index].first < 0)
    {
      this->Sources[index] = { triangle, barycentric };
    }
  }

  void AddTriangle(const Eigen::RowVector3i& corners, int parent)
  {
    this->Triangles.push_back(corners);
    this->Parents.push_back(parent);
  }

  const Mesh& Surface;
  TriangleContacts Contacts;
  /// For each point after those of the surface, a triangle and barycentric coordinates.
  std::vector<std::pair<int, RowVector3d>> Sources;
  std::vector<int> First; ///< for each point, the one that replaces it, or itself
  std::map<Edge, EdgePoints> OnEdge;
  std::vector<Eigen::RowVector3i> Triangles;
  std::vector<int> Parents;
  ///@{
  /// The points of the triangle that is split.
  std::vector<int> Numbers;
  std::vector<RowVector3d> Barycentric;
  ///@}
};

} // namespace

SplitContacts SplitAtContacts(
  const Mesh& surface, const std::vector<Crossing>& pairs, const Progress& progress)
{
  Splitter splitter(surface, FindTriangleContacts(surface, pairs, progress.Part(0.0, 0.3)));
  const auto count = static_cast<int>(surface.Triangles.rows());
  for (int triangle = 0; triangle < count; ++triangle)
  {
    progress(0.3 + 0.7 * triangle / count);
    splitter.Add(triangle);
  }
  return splitter.Finish();
}

} // namespace shape
