#include "Hex/Features/RegionMatch.h"

#include "Hex/Features/Private/CurveResampling.h"
#include "Hex/Features/Private/RegionJunctions.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

namespace shape
{
namespace
{

/// No two points are put at corners that are nearer than this; in cells.
constexpr double LeastShare = 0.5;

/// Assigns the curves and corners of hexahedra to those of surfaces.
class NetworkMatch
{
public:
  NetworkMatch(
    const HexMesh& mesh, const RegionTargets& targets, double cellSize, RegionMatch& match)
    : Grid(mesh)
    , Surfaces(targets.Surfaces.AsMesh())
    , CurvePoints(targets.CurvePoints)
    , Own(match.Chains)
    , Wanted(targets.Network)
    , Junctions(
        MatchJunctions(match.Chains, mesh.Points, targets.Network, this->Surfaces.Points, cellSize))
    , NearestCorners(LeastShare * cellSize)
    , Match(match)
  {
    match.Curves = static_cast<int>(this->Wanted.Curves.size());
    match.Junctions = static_cast<int>(this->Junctions.Wanted.Corners.size());
  }

  void MatchCorners()
  {
    for (const auto& [own, wanted] : this->Junctions.WantedOf)
    {
      this->PutCorners(this->Junctions.Own.Corners[own], this->Junctions.Wanted.Corners[wanted]);
      ++this->Match.JunctionsKept;
    }
  }

  void MatchCurves()
  {
    std::vector<char> taken(this->Wanted.Curves.size(), 0);
    std::vector<const RegionNetwork::Curve*> others;
    for (std::size_t i = 0; i < this->Own.Curves.size(); ++i)
    {
      const RegionNetwork::Curve& chain = this->Own.Curves[i];
      const int curve = this->FindCurve(chain, this->Junctions.Own.IsInside[i], taken);
      if (curve < 0)
      {
        others.push_back(&chain);
        continue;
      }
      taken[curve] = 1;
      this->Distribute(chain, this->Wanted.Curves[curve]);
    }
    for (const RegionNetwork::Curve* chain : others)
    {
      for (const int point : chain->Points)
      {
        this->PutOnClosest(point, chain->Labels);
      }
    }
    for (std::size_t i = 0; i < this->Wanted.Curves.size(); ++i)
    {
      // A curve inside a junction is part of its point.
      const bool isInside = this->Junctions.Wanted.IsInside[i] != 0;
      this->Match.Curves -= isInside ? 1 : 0;
      this->Match.CurvesKept += !isInside && taken[i] ? 1 : 0;
    }
  }

private:
  static Eigen::RowVector3d Middle(const Eigen::MatrixXd& points, const std::vector<int>& some)
  {
    return points(some, Eigen::all).colwise().mean();
  }

  void Put(int point, const Eigen::RowVector3d& position, const Eigen::MatrixXd& span)
  {
    this->Match.Boundary.Starts.emplace_back(point, position);
    this->Match.Boundary.Spans[point] = span;
  }

  /// Puts the corners of a junction at those of another, the closest first, while there are some
  /// that are not too near to each other. Others are put on the closest curve.
  void PutCorners(const std::vector<int>& corners, const std::vector<int>& wanted)
  {
    std::vector<std::tuple<double, int, int>> pairs;
    for (const int point : corners)
    {
      for (const int corner : wanted)
      {
        pairs.emplace_back(
          (this->Grid.Points.row(point) - this->Surfaces.Points.row(corner)).norm(), point, corner);
      }
    }
    std::sort(pairs.begin(), pairs.end());
    std::vector<int> taken;
    for (const auto& [distance, point, corner] : pairs)
    {
      const Eigen::RowVector3d position = this->Surfaces.Points.row(corner);
      const bool isNear = std::any_of(taken.begin(), taken.end(),
        [&](int other)
        { return (this->Surfaces.Points.row(other) - position).norm() < this->NearestCorners; });
      if (!isNear && !this->Match.Boundary.Spans.count(point))
      {
        taken.push_back(corner);
        this->Put(point, position, position);
      }
    }
    for (const int point : corners)
    {
      this->PutOnClosest(point, this->LabelsAt(point));
    }
  }

  const std::vector<int>& LabelsAt(int corner) const
  {
    const auto at = std::lower_bound(this->Own.Corners.begin(), this->Own.Corners.end(), corner);
    return this->Own.CornerLabels[at - this->Own.Corners.begin()];
  }

  /// The junction of the surfaces at a corner of the hexahedra, or -1.
  int JunctionAt(int point) const
  {
    const auto found = this->Junctions.WantedOf.find(this->Junctions.Own.Number.at(point));
    return found == this->Junctions.WantedOf.end() ? -1 : found->second;
  }

  /// Returns the closest free curve with the labels and ends of a chain, or -1. isInside: whether
  /// the chain is part of a junction.
  int FindCurve(
    const RegionNetwork::Curve& chain, char isInside, const std::vector<char>& taken) const
  {
    int best = -1;
    double minimum = std::numeric_limits<double>::infinity();
    const Eigen::RowVector3d middle = Middle(this->Grid.Points, chain.Points);
    for (std::size_t i = 0; i < this->Wanted.Curves.size(); ++i)
    {
      const RegionNetwork::Curve& curve = this->Wanted.Curves[i];
      if (taken[i] || curve.Labels != chain.Labels || curve.Closed != chain.Closed ||
        this->Junctions.Wanted.IsInside[i] != isInside)
      {
        continue;
      }
      if (!chain.Closed)
      {
        const int begin = this->JunctionAt(chain.Points.front()),
                  end = this->JunctionAt(chain.Points.back());
        const int front = this->Junctions.Wanted.Number.at(curve.Points.front()),
                  back = this->Junctions.Wanted.Number.at(curve.Points.back());
        if (!(begin == front && end == back) && !(begin == back && end == front))
        {
          continue;
        }
      }
      const double distance = (this->CurvePoints[i].colwise().mean() - middle).norm();
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
      DistributeAlongCurve(this->Grid.Points(chain.Points, Eigen::all), this->Surfaces, along,
        ComputeCreaseTolerance(this->Surfaces));
    for (std::size_t i = 0; i < chain.Points.size(); ++i)
    {
      if (!this->Match.Boundary.Spans.count(chain.Points[i]))
      {
        this->Put(chain.Points[i], positions.Positions.row(static_cast<Eigen::Index>(i)),
          positions.Spans[i]);
      }
    }
  }

  /// Puts a point on the closest part of a curve that has only these labels, unless it has a place.
  void PutOnClosest(int point, const std::vector<int>& around)
  {
    if (!this->Match.Boundary.Spans.count(point))
    {
      const Eigen::RowVector3d position = this->Grid.Points.row(point);
      const Eigen::MatrixXd* best = nullptr;
      Eigen::Index at = 0;
      double minimum = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < this->Wanted.Curves.size(); ++i)
      {
        const std::vector<int>& labels = this->Wanted.Curves[i].Labels;
        if (!std::includes(around.begin(), around.end(), labels.begin(), labels.end()))
        {
          continue;
        }
        Eigen::Index nearest = 0;
        const double distance =
          (this->CurvePoints[i].rowwise() - position).rowwise().squaredNorm().minCoeff(&nearest);
        if (distance < minimum)
        {
          minimum = distance;
          best = &this->CurvePoints[i];
          at = nearest;
        }
      }
      if (best)
      {
        constexpr Eigen::Index reach = 3; // edges of the curve to either side
        const Eigen::Index first = std::max<Eigen::Index>(at - reach, 0),
                           last = std::min(at + reach, best->rows() - 1);
        this->Put(point, best->row(at), best->middleRows(first, last - first + 1));
      }
    }
  }

  const HexMesh& Grid;
  const Mesh& Surfaces;
  const std::vector<Eigen::MatrixXd>& CurvePoints; ///< of the surfaces' curves
  const RegionNetwork& Own;
  const RegionNetwork& Wanted;
  const JunctionMatch Junctions;
  const double NearestCorners; ///< see LeastShare
  RegionMatch& Match;
};

/// Finds the patch of each quad whose pair of labels the surfaces have.
void AssignQuads(const RegionFaces& faces, const RegionTargets& targets, PatchedBoundary& boundary)
{
  boundary.Patches = targets.Patches;
  std::vector<int> own, patches;
  for (int q = 0; q < static_cast<int>(faces.Quads.rows()); ++q)
  {
    const auto found =
      targets.PatchOf.find({ faces.Labels.row(q).minCoeff(), faces.Labels.row(q).maxCoeff() });
    if (found != targets.PatchOf.end())
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

RegionMatch MatchRegions(
  const HexMesh& mesh, const RegionFaces& faces, const RegionTargets& targets, double cellSize)
{
  RegionMatch match;
  AssignQuads(faces, targets, match.Boundary);
  match.Chains = FindRegionNetwork(faces.Quads, faces.Labels);
  NetworkMatch networks(mesh, targets, cellSize, match);
  networks.MatchCorners();
  networks.MatchCurves();
  return match;
}

namespace
{

/// The points of a curve, in order; a closed curve repeats its first point.
std::vector<int> PointsAlong(const RegionNetwork::Curve& curve)
{
  std::vector<int> points = curve.Points;
  if (curve.Closed)
  {
    points.push_back(curve.Points.front());
  }
  return points;
}

/// Curves with at least some labels, or all if there are none, as triangles without area.
Mesh CurvesWith(
  const std::vector<int>& labels, const RegionNetwork& network, const Eigen::MatrixXd& points)
{
  std::vector<Eigen::RowVector3i> with, all;
  for (const RegionNetwork::Curve& curve : network.Curves)
  {
    const bool hasLabels =
      std::includes(curve.Labels.begin(), curve.Labels.end(), labels.begin(), labels.end());
    const std::vector<int> along = PointsAlong(curve);
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
    {
      all.emplace_back(along[i], along[i + 1], along[i + 1]);
      if (hasLabels)
      {
        with.push_back(all.back());
      }
    }
  }
  const std::vector<Eigen::RowVector3i>& edges = with.empty() ? all : with;
  Mesh mesh{ points, Eigen::MatrixXi(static_cast<Eigen::Index>(edges.size()), 3) };
  for (Eigen::Index i = 0; i < mesh.Triangles.rows(); ++i)
  {
    mesh.Triangles.row(i) = edges[i];
  }
  return mesh;
}

/// The largest distance of the points of a network, and of the middles of its edges, from the
/// curves of another.
double FindLargestDistance(const RegionNetwork& from, const Eigen::MatrixXd& points,
  const RegionNetwork& to, const Eigen::MatrixXd& others)
{
  double largest = 0.0;
  std::map<std::vector<int>, std::vector<Eigen::RowVector3d>> positionsOf; // by labels
  for (const RegionNetwork::Curve& curve : from.Curves)
  {
    std::vector<Eigen::RowVector3d>& positions = positionsOf[curve.Labels];
    const std::vector<int> along = PointsAlong(curve);
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
    {
      const Eigen::RowVector3d a = points.row(along[i]), b = points.row(along[i + 1]);
      positions.insert(positions.end(), { a, 0.5 * (a + b), b });
    }
  }
  for (const auto& [labels, positions] : positionsOf)
  {
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(positions.size()), 3);
    for (Eigen::Index i = 0; i < rows.rows(); ++i)
    {
      rows.row(i) = positions[i];
    }
    const SurfaceLocator curves(CurvesWith(labels, to, others));
    largest = std::max(largest, curves.Find(rows).Distances.maxCoeff());
  }
  return largest;
}

} // namespace

double ComputeCurveDistance(
  const Eigen::MatrixXd& points, const RegionTargets& targets, const RegionMatch& match)
{
  const RegionNetwork &own = match.Chains, &wanted = targets.Network;
  if (own.Curves.empty() || wanted.Curves.empty())
  {
    return 0.0;
  }
  return std::max(FindLargestDistance(own, points, wanted, targets.Surfaces.Points()),
    FindLargestDistance(wanted, targets.Surfaces.Points(), own, points));
}

} // namespace shape
