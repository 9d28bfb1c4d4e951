#include "Solidify/SurfaceDefects.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/Surface.h"
#include "Mesh/TouchingSheets.h"
#include "Mesh/UsedPoints.h"
#include "Solidify/Private/EdgeGroups.h"
#include "Solidify/Private/JoinedSoup.h"
#include "Solids/Nesting.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

constexpr int MostIntersections = 1000000;

/// Collects the defects of one surface; the functions are called in the order of DefectKind.
class DefectList
{
public:
  void Add(DefectKind kind, const RowVector3d& position)
  {
    this->Found.Defects.push_back({ kind, position });
    ++this->Found.Counts[static_cast<std::size_t>(kind)];
  }

  void AddPoints(DefectKind kind, const std::vector<int>& points, const Eigen::MatrixXd& positions)
  {
    for (const int point : points)
    {
      this->Add(
        kind, positions.row(point).unaryExpr([](double x) { return std::isfinite(x) ? x : 0.0; }));
    }
  }

  void AddTriangles(DefectKind kind, const std::vector<int>& triangles, const Mesh& mesh)
  {
    for (const int triangle : triangles)
    {
      this->Add(kind, GetCorners(mesh, triangle).colwise().mean());
    }
  }

  /// Edges, points and loops that are defects.
  void AddTopology(const Surface& surface)
  {
    const Eigen::MatrixXd& points = surface.Points();
    std::vector<RowVector3d> tangled, misoriented;
    DisjointSets loops(static_cast<int>(points.rows()));
    std::vector<char> isOpen(points.rows(), 0);
    ForEachEdge(surface.HalfEdges(),
      [&](const HalfEdge* begin, const HalfEdge* end)
      {
        const RowVector3d middle = 0.5 * (points.row(begin->Begin) + points.row(begin->End));
        if (end - begin == 1)
        {
          loops.Merge(begin->Begin, begin->End);
          isOpen[begin->Begin] = isOpen[begin->End] = 1;
        }
        else if (end - begin > 2)
        {
          tangled.push_back(middle);
        }
        else if (begin->Begin == begin[1].Begin)
        {
          misoriented.push_back(middle);
        }
      });
    this->AddAll(DefectKind::NonManifoldEdge, tangled);
    this->AddPoints(DefectKind::NonManifoldPoint, this->FindPinched(surface), points);
    this->AddAll(DefectKind::MisorientedEdge, misoriented);
    this->AddInverted(surface);
    std::vector<char> isListed(points.rows(), 0);
    for (int point = 0; point < static_cast<int>(points.rows()); ++point)
    {
      if (isOpen[point] && !std::exchange(isListed[loops.Find(point)], 1))
      {
        this->Add(DefectKind::OpenLoop, points.row(point));
      }
    }
  }

  void AddSmallPieces(const Surface& surface, double smallest)
  {
    for (const Mesh& piece : SplitComponents(surface))
    {
      if (ComputeLongestBoxEdge(piece.Points) < smallest)
      {
        this->Add(DefectKind::SmallPiece, piece.Points.row(0));
      }
    }
  }

  SurfaceDefects Found;

private:
  void AddAll(DefectKind kind, const std::vector<RowVector3d>& positions)
  {
    for (const RowVector3d& position : positions)
    {
      this->Add(kind, position);
    }
  }

  /// Points with several fans of triangles.
  static std::vector<int> FindPinched(const Surface& surface)
  {
    const std::vector<int> fans = FindFans(surface, surface.HalfEdges());
    std::vector<int> fanAt(surface.Points().rows(), -1), pinched;
    for (std::size_t corner = 0; corner < fans.size(); ++corner)
    {
      const int point = surface.Triangles()(
        static_cast<Eigen::Index>(corner / 3), static_cast<Eigen::Index>(corner % 3));
      if (fanAt[point] >= 0 && fanAt[point] != fans[corner])
      {
        pinched.push_back(point);
      }
      fanAt[point] = fans[corner];
    }
    std::sort(pinched.begin(), pinched.end());
    pinched.erase(std::unique(pinched.begin(), pinched.end()), pinched.end());
    return pinched;
  }

  /// Only closed, consistently oriented pieces can be inverted as a whole.
  void AddInverted(const Surface& surface)
  {
    std::vector<Mesh> closed;
    for (Mesh& piece : SplitComponents(surface))
    {
      const Topology topology = ComputeTopology(piece);
      if (topology.BoundaryLoops + topology.NonManifoldEdges + topology.MisorientedEdges == 0)
      {
        closed.push_back(std::move(piece));
      }
    }
    if (closed.empty())
    {
      return;
    }
    const Surface all = JoinMeshes(closed);
    Eigen::Index first = 0;
    try
    {
      const Surface oriented = OrientByNesting(all, "the surface");
      for (const Mesh& piece : closed)
      {
        if (oriented.Triangles().row(first) != all.Triangles().row(first))
        {
          this->Add(DefectKind::InvertedPiece, piece.Points.row(0));
        }
        first += piece.Triangles.rows();
      }
    }
    catch (const InvalidInput&) // pieces cross or touch
    {
      for (const Mesh& piece : closed)
      {
        if (ComputeEnclosedVolume(piece) < 0.0)
        {
          this->Add(DefectKind::InvertedPiece, piece.Points.row(0));
        }
      }
    }
  }
};

/// Returns the triangles that are not among the first of the same, and the degenerate ones.
struct TriangleKinds
{
  std::vector<int> Unique, Repeated;
};

TriangleKinds FindRepeated(const Eigen::MatrixXi& triangles)
{
  TriangleKinds kinds;
  const std::vector<int> same = FindSameTriangles(triangles);
  for (int t = 0; t < static_cast<int>(same.size()); ++t)
  {
    (same[t] == t ? kinds.Unique : kinds.Repeated).push_back(t);
  }
  return kinds;
}

/// The triangles without those in `removed` (ascending).
Eigen::MatrixXi Without(const Eigen::MatrixXi& triangles, const std::vector<int>& removed)
{
  std::vector<int> kept;
  for (int t = 0; t < static_cast<int>(triangles.rows()); ++t)
  {
    if (!std::binary_search(removed.begin(), removed.end(), t))
    {
      kept.push_back(t);
    }
  }
  return triangles(kept, Eigen::all);
}

} // namespace

SurfaceDefects FindSurfaceDefects(
  const Mesh& surface, const SurfaceDefectOptions& options, const Progress& progress)
{
  RequireOption(options.Tolerance >= 0.0 && std::isfinite(options.Tolerance), "Tolerance",
    options.Tolerance, "a finite number of at least 0");
  RequireOption(options.SmallestPiece >= 0.0 && std::isfinite(options.SmallestPiece),
    "SmallestPiece", options.SmallestPiece, "a finite number of at least 0");
  const JoinedSoup soup = JoinSoup(surface, options.Tolerance, progress.Part(0.0, 0.1));
  const TriangleKinds kinds = FindRepeated(soup.Surface.Triangles);
  const Surface joined(soup.Surface.Points, soup.Surface.Triangles(kinds.Unique, Eigen::all));
  const std::vector<int> collinear = FindDegenerateTriangles(joined);

  DefectList list;
  list.AddPoints(DefectKind::NotFinite, soup.NotFinite, surface.Points);
  list.AddPoints(DefectKind::LoosePoint, soup.Loose, surface.Points);
  list.AddPoints(DefectKind::DuplicatePoint, soup.Joined, surface.Points);
  list.AddTriangles(DefectKind::DegenerateTriangle, soup.Collapsed, surface);
  list.AddTriangles(DefectKind::DegenerateTriangle, collinear, joined);
  list.AddTriangles(DefectKind::DuplicateTriangle, kinds.Repeated, soup.Surface);
  list.AddTopology(joined);
  if (joined.Triangles().rows() > 0)
  {
    const Surface solid(joined.Points(), Without(joined.Triangles(), collinear));
    for (const Crossing& crossing :
      FindSelfIntersectionsFrom(solid, 0, MostIntersections, progress.Part(0.3, 1.0)))
    {
      list.Add(DefectKind::SelfIntersection, crossing.Position);
    }
    if (options.SmallestPiece > 0.0)
    {
      list.AddSmallPieces(joined, options.SmallestPiece);
    }
  }
  list.Found.Pieces = joined.Topology().Components;
  list.Found.EulerNumber = joined.Topology().EulerNumber;
  progress(1.0);
  return std::move(list.Found);
}

} // namespace shape
