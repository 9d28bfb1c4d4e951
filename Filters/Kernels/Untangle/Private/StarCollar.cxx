#include "Untangle/Private/StarCollar.h"

#include "Untangle/Private/CellPatches.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using Edge = std::pair<int, int>;

/// How clearly a fan has to be in order (IsInOrder): before, and after its faces were split.
constexpr double MinimumOrder = 1e-3, MinimumOrderOfSplit = 1e-10;

/// The new points near the boundary, and where they are. The order of calls: SplitFacesOutOfOrder,
/// SplitSpokes, then Place and Shrink in turn.
class Collar
{
public:
  Collar(SolidCells& solid, const Eigen::RowVector3d& centre)
    : Solid(solid)
    , Centre(centre)
    , Sphere(solid.Points.topRows(solid.PointCount()))
  {
  }

  void SplitFacesOutOfOrder(const Progress& progress);
  void SplitSpokes(const Progress& progress);
  void Place();
  bool Shrink(const std::vector<int>& inverted, bool alsoFaces);

private:
  /// A new point on an inner edge from a boundary point.
  struct Spoke
  {
    int Middle, From, To;
  };

  /// A new point in an inner face at a boundary edge.
  struct FacePoint
  {
    int Middle;
    Edge Ends;
    Eigen::RowVector3d Offset; ///< from the edge's midpoint, for depth 1
  };

  Eigen::RowVector3d FindOutward(int point) const
  {
    return (this->Sphere.row(point) - this->Centre).normalized();
  }
  double FindDepthBelow(int boundary, int inner) const
  {
    return this->FindOutward(boundary).dot(
      this->Sphere.row(boundary) - this->Solid.Points.row(inner));
  }
  bool IsInOrder(int point, const StarFace& face, double sine) const;
  bool IsInOrder(int cell, double sine) const;
  std::vector<int> FindBoundaryPoints(int cell) const;
  std::vector<int> FindFan(const Edge& edge) const;
  std::set<Edge> FindEdgesOutOfOrder(const Progress& progress) const;
  void SplitAtTriangles(const std::set<Edge>& outOfOrder, const Progress& progress);
  void SplitFaces(const Edge& edge);

  SolidCells& Solid;
  Eigen::RowVector3d Centre;
  Eigen::MatrixXd Sphere;        ///< positions before boundary points move outward
  std::set<int> TriangleMiddles; ///< new points in tetrahedra, near boundary triangles
  std::vector<Spoke> Spokes;
  std::vector<FacePoint> FacePoints;
  std::map<int, double> PointDepths; ///< of the planes of spokes, by boundary points
  std::map<Edge, double> EdgeDepths; ///< the sizes of parabolas, by boundary edges
};

/// Whether a tetrahedron's inner points are in order around one of its two boundary points, as seen
/// along the ray. face: the face opposite to `point` whose first corner is the other boundary
/// point.
bool Collar::IsInOrder(int point, const StarFace& face, double sine) const
{
  const Eigen::RowVector3d position = this->Sphere.row(point);
  const Eigen::RowVector3d outward = this->FindOutward(point);
  const auto project = [&](int inner) -> Eigen::RowVector3d
  { return (this->Solid.Points.row(inner) - position) / this->FindDepthBelow(point, inner); };
  Eigen::RowVector3d edge = this->Sphere.row(face[0]) - position;
  edge -= edge.dot(outward) * outward;
  const Eigen::RowVector3d step = project(face[1]) - project(face[2]);
  return edge.cross(step).dot(outward) > sine * edge.norm() * step.norm();
}

/// Whether a tetrahedron with two boundary points is in order at both.
bool Collar::IsInOrder(int cell, double sine) const
{
  std::vector<int> ends = this->FindBoundaryPoints(cell);
  for (int k = 0; k < 2; ++k)
  {
    StarFace face = FindFaceOpposite(this->Solid.PointsOf(cell), ends[k]);
    std::rotate(face.begin(), std::find(face.begin(), face.end(), ends[1 - k]), face.end());
    if (!this->IsInOrder(ends[k], face, sine))
    {
      return false;
    }
  }
  return true;
}

std::vector<int> Collar::FindBoundaryPoints(int cell) const
{
  std::vector<int> found;
  for (const int point : this->Solid.PointsOf(cell))
  {
    if (this->Solid.OnBoundary(point))
    {
      found.push_back(point);
    }
  }
  return found;
}

std::set<Edge> Collar::FindEdgesOutOfOrder(const Progress& progress) const
{
  std::set<Edge> found;
  for (int cell = 0; cell < this->Solid.CellCount(); ++cell)
  {
    if (cell % ReportInterval == 0)
    {
      progress(0.0);
    }
    const std::vector<int> ends = this->FindBoundaryPoints(cell);
    if (ends.size() == 2 && !this->IsInOrder(cell, MinimumOrder))
    {
      found.insert(std::minmax(ends[0], ends[1]));
    }
  }
  return found;
}

/// Returns the cells around a boundary edge that have no other boundary point.
std::vector<int> Collar::FindFan(const Edge& edge) const
{
  std::vector<int> fan;
  for (const int cell : this->Solid.CellsOf(edge.first))
  {
    const std::vector<int> ends = this->FindBoundaryPoints(cell);
    if (ends.size() == 2 && Edge(std::minmax(ends[0], ends[1])) == edge)
    {
      fan.push_back(cell);
    }
  }
  return fan;
}

/// Splits the tetrahedra at boundary triangles with an edge out of order, so that no inner face of
/// one edge belongs to the fan of another.
void Collar::SplitAtTriangles(const std::set<Edge>& outOfOrder, const Progress& progress)
{
  const int count = this->Solid.CellCount();
  for (int cell = 0; cell < count; ++cell)
  {
    if (cell % ReportInterval == 0)
    {
      progress(0.0);
    }
    const std::vector<int> corners = this->FindBoundaryPoints(cell);
    bool isOutOfOrder = false;
    for (std::size_t k = 0; k < corners.size(); ++k)
    {
      isOutOfOrder = isOutOfOrder ||
        outOfOrder.count(std::minmax(corners[k], corners[(k + 1) % corners.size()])) > 0;
    }
    if (corners.size() != 3 || !isOutOfOrder)
    {
      continue;
    }
    const std::vector<int> tetrahedron = this->Solid.PointsOf(cell);
    const int inner = *std::find_if(tetrahedron.begin(), tetrahedron.end(),
      [&](int point) { return !this->Solid.OnBoundary(point); });
    if (this->TriangleMiddles.count(inner) > 0)
    {
      continue;
    }
    const Eigen::RowVector3d centroid = this->Solid.Points(corners, Eigen::all).colwise().mean();
    double dip = std::numeric_limits<double>::max(), depth = 0.0;
    for (const int corner : corners)
    {
      const Eigen::RowVector3d outward = this->FindOutward(corner);
      dip = std::min(dip, outward.dot(this->Sphere.row(corner) - centroid));
      depth = std::max(depth, this->FindDepthBelow(corner, inner));
    }
    // So close to the triangle that the edges see the new point before all others.
    const double share = 0.1 * std::min(1.0, dip / depth);
    const Eigen::RowVector3d position =
      centroid + share * (this->Solid.Points.row(inner) - centroid);
    const int middle = this->Solid.Split(tetrahedron);
    this->Solid.Points.row(middle) = position;
    this->TriangleMiddles.insert(middle);
  }
}

/// Splits the inner faces at boundary edges out of order.
void Collar::SplitFacesOutOfOrder(const Progress& progress)
{
  std::set<Edge> edges;
  for (std::set<Edge> found = this->FindEdgesOutOfOrder(progress);
       !std::includes(edges.begin(), edges.end(), found.begin(), found.end());
       found = this->FindEdgesOutOfOrder(progress))
  {
    edges.insert(found.begin(), found.end());
    this->SplitAtTriangles(edges, progress);
  }
  double done = 0.0;
  for (const Edge& edge : edges)
  {
    progress(done / static_cast<double>(edges.size()));
    this->SplitFaces(edge);
    done += 1.0;
  }
}

/// Splits the inner faces at a boundary edge.
void Collar::SplitFaces(const Edge& edge)
{
  const auto [a, b] = edge;
  const Eigen::RowVector3d middle = (this->Sphere.row(a) + this->Sphere.row(b)) / 2.0;
  const Eigen::RowVector3d along = (this->Sphere.row(b) - this->Sphere.row(a)).normalized();
  const double half = (this->Sphere.row(b) - middle).norm();
  const Eigen::RowVector3d outward = (middle - this->Centre).normalized();
  std::set<int> around;
  for (const int cell : this->Solid.CellsOf(a))
  {
    const std::vector<int>& corners = this->Solid.PointsOf(cell);
    if (std::find(corners.begin(), corners.end(), b) != corners.end())
    {
      around.insert(corners.begin(), corners.end());
    }
  }
  const std::size_t first = this->FacePoints.size();
  double depth = std::numeric_limits<double>::max();
  for (const int third : around)
  {
    if (this->Solid.OnBoundary(third) || this->TriangleMiddles.count(third) > 0 ||
      !this->Solid.CanSplit({ a, b, third }))
    {
      continue;
    }
    Eigen::RowVector3d across = this->Solid.Points.row(third) - middle;
    const double shift = across.dot(along);
    across -= shift * along;
    const double height = across.norm();
    across /= height;
    // The parabola around the edge that opens outward: from infinity its points are in order.
    const double distance = 1.0 / std::max(1e-3, 1.0 - across.dot(outward));
    // Well inside the face.
    const double highest = height * half / (std::abs(shift) + half);
    depth = std::min(depth, 0.25 * highest / distance);
    this->FacePoints.push_back({ this->Solid.Split({ a, b, third }), edge, distance * across });
  }
  // Near the edge, the parabola is in order from the edge's ends, too.
  const std::vector<int> fan = this->FindFan(edge);
  for (int halving = 0; halving < 40; ++halving, depth *= 0.5)
  {
    this->EdgeDepths[edge] = depth;
    for (std::size_t i = first; i < this->FacePoints.size(); ++i)
    {
      this->Solid.Points.row(this->FacePoints[i].Middle) =
        middle + depth * this->FacePoints[i].Offset;
    }
    if (std::all_of(fan.begin(), fan.end(),
          [&](int cell) { return this->IsInOrder(cell, MinimumOrderOfSplit); }))
    {
      break;
    }
  }
}

/// Splits the inner edges from boundary points.
void Collar::SplitSpokes(const Progress& progress)
{
  this->Place();
  std::vector<Edge> edges;
  for (int point = 0; point < this->Solid.PointCount(); ++point)
  {
    if (!this->Solid.OnBoundary(point))
    {
      continue;
    }
    progress(0.0);
    double least = std::numeric_limits<double>::max();
    for (const int other : this->Solid.NeighboursOf(point))
    {
      if (!this->Solid.OnBoundary(other) && this->Solid.CanSplit({ point, other }))
      {
        edges.emplace_back(point, other);
        least = std::min(least, this->FindDepthBelow(point, other));
      }
    }
    this->PointDepths[point] = 0.25 * least;
  }
  for (const auto& [from, to] : edges)
  {
    if (this->Spokes.size() % ReportInterval == 0)
    {
      progress(static_cast<double>(this->Spokes.size()) / static_cast<double>(edges.size()));
    }
    this->Spokes.push_back({ this->Solid.Split({ from, to }), from, to });
  }
}

/// Puts the new points where the depths say.
void Collar::Place()
{
  for (const FacePoint& point : this->FacePoints)
  {
    const auto [a, b] = point.Ends;
    this->Solid.Points.row(point.Middle) = (this->Sphere.row(a) + this->Sphere.row(b)) / 2.0 +
      this->EdgeDepths[point.Ends] * point.Offset;
  }
  for (const Spoke& spoke : this->Spokes)
  {
    double& depth = this->PointDepths[spoke.From];
    depth = std::min(depth, 0.5 * this->FindDepthBelow(spoke.From, spoke.To));
  }
  for (const Spoke& spoke : this->Spokes)
  {
    const double share = this->PointDepths[spoke.From] / this->FindDepthBelow(spoke.From, spoke.To);
    const Eigen::RowVector3d from = this->Sphere.row(spoke.From);
    this->Solid.Points.row(spoke.Middle) = from + share * (this->Solid.Points.row(spoke.To) - from);
  }
}

/// Halves the depths at inverted tetrahedra, of edges only if alsoFaces. Returns whether any.
bool Collar::Shrink(const std::vector<int>& inverted, bool alsoFaces)
{
  std::set<int> bad;
  for (const int cell : inverted)
  {
    bad.insert(this->Solid.PointsOf(cell).begin(), this->Solid.PointsOf(cell).end());
  }
  std::set<int> points;
  std::set<Edge> edges;
  for (const Spoke& spoke : this->Spokes)
  {
    if (bad.count(spoke.Middle))
    {
      points.insert(spoke.From);
    }
  }
  for (const FacePoint& point : this->FacePoints)
  {
    if (alsoFaces && bad.count(point.Middle))
    {
      edges.insert(point.Ends);
    }
  }
  for (const int point : points)
  {
    this->PointDepths[point] *= 0.5;
  }
  for (const Edge& edge : edges)
  {
    this->EdgeDepths[edge] *= 0.5;
  }
  return !points.empty() || !edges.empty();
}

} // namespace

std::vector<StarFace> FindStarFaces(const SolidCells& solid)
{
  std::vector<StarFace> faces;
  for (const std::array<int, 3>& triangle : solid.BoundaryTriangles())
  {
    faces.push_back({ triangle[0], triangle[2], triangle[1] });
  }
  return faces;
}

StarPlacement FindStarCentre(const SolidCells& solid, const std::vector<StarFace>& faces)
{
  Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
  for (const StarFace& face : faces)
  {
    mean += solid.Points.row(face[0]) / static_cast<double>(faces.size());
  }
  return FindKernelCentre(solid.Points, faces, mean);
}

void SeparateBoundary(SolidCells& solid, const Progress& progress)
{
  for (const std::size_t size : { 2U, 3U })
  {
    std::set<std::vector<int>> simplices;
    for (int cell = 0; cell < solid.CellCount(); ++cell)
    {
      if (cell % ReportInterval == 0)
      {
        progress(0.0);
      }
      for (unsigned int subset = 1; subset < 16U; ++subset)
      {
        std::vector<int> simplex;
        for (unsigned int k = 0; k < 4U; ++k)
        {
          if ((subset >> k & 1U) && solid.OnBoundary(solid.PointsOf(cell)[k]))
          {
            simplex.push_back(solid.PointsOf(cell)[k]);
          }
        }
        if (simplex.size() == size && solid.CanSplit(simplex))
        {
          std::sort(simplex.begin(), simplex.end());
          simplices.insert(std::move(simplex));
        }
      }
    }
    int splits = 0;
    for (const std::vector<int>& simplex : simplices)
    {
      if (splits++ % ReportInterval == 0)
      {
        progress(0.0);
      }
      solid.Split(simplex);
    }
  }
}

void ProjectToSphere(SolidCells& solid, const Eigen::RowVector3d& centre)
{
  double least = std::numeric_limits<double>::max();
  for (int point = 0; point < solid.PointCount(); ++point)
  {
    if (solid.OnBoundary(point))
    {
      least = std::min(least, (solid.Points.row(point) - centre).norm());
    }
  }
  for (int point = 0; point < solid.PointCount(); ++point)
  {
    if (solid.OnBoundary(point))
    {
      const Eigen::RowVector3d ray = solid.Points.row(point) - centre;
      solid.Points.row(point) = centre + 0.5 * least * ray.normalized();
    }
  }
}

void MoveBoundary(SolidCells& solid, const Eigen::MatrixXd& targets)
{
  for (int point = 0; point < targets.rows(); ++point)
  {
    if (solid.OnBoundary(point))
    {
      solid.Points.row(point) = targets.row(point);
    }
  }
}

int MoveOutward(SolidCells& solid, const Eigen::RowVector3d& centre, const Eigen::MatrixXd& targets,
  const Progress& progress)
{
  constexpr int rounds = 60, patience = 12;
  Collar collar(solid, centre);
  collar.SplitFacesOutOfOrder(progress.Part(0.0, 0.2));
  collar.SplitSpokes(progress.Part(0.2, 0.3));
  MoveBoundary(solid, targets);
  std::vector<int> inverted;
  Eigen::MatrixXd best;
  std::size_t minimum = std::numeric_limits<std::size_t>::max();
  for (int round = 0, last = 0; round < rounds && round <= last + patience; ++round)
  {
    const double share = 0.3 + 0.7 * round / rounds;
    collar.Place();
    inverted = FindInverted(solid, progress.Part(share, share));
    if (inverted.size() < minimum)
    {
      minimum = inverted.size();
      best = solid.Points;
      last = round;
    }
    // Depths of points are small compared with those of edges.
    if (inverted.empty() || !collar.Shrink(inverted, round % 4 == 3))
    {
      break;
    }
  }
  solid.Points = best;
  return static_cast<int>(minimum);
}

} // namespace shape
