#include "Hex/Fit/Snapping.h"

#include "Distance/HausdorffDistance.h"
#include "Hex/Features/FeatureConstraint.h"
#include "Hex/Optimize/HexOptimization.h"
#include "Quality/ScaledJacobian.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The largest improvement of the minimum that raising the worst hexahedra was seen to give.
constexpr double MaximumRaised = 0.15;

/// A position at which the surfaces are far from each other.
struct FarPosition
{
  Eigen::RowVector3d OnSurface, OnBoundary;
  double Distance = 0.0;
};

/// The boundary on its way to the surface. Order of calls: Round, until it gains nothing or
/// Distance is as wanted.
class Snapper
{
public:
  Snapper(HexMesh& mesh, const Eigen::MatrixXi& quads, const Surface& surface,
    const PointConstraint& constraint, double wanted)
    : Solid(mesh)
    , Quads(quads)
    , Triangles(SplitQuads(quads))
    , Target(surface)
    , Given(constraint)
    , Constraint(constraint, mesh.Points.rows())
    , Share(mesh.Points.rows(), 1.0)
    , Wanted(wanted)
    , QuadsAround(mesh.Points.rows())
  {
    for (Eigen::Index q = 0; q < quads.rows(); ++q)
    {
      const auto points = quads.row(q);
      std::for_each(points.begin(), points.end(),
        [&](int point) { this->QuadsAround[point].push_back(static_cast<int>(q)); });
    }
    // Points on creases stay.
    std::vector<char>& freedoms = this->Constraint.Freedoms;
    std::replace(freedoms.begin(), freedoms.end(), char(1), char(0));
    this->Compare({});
  }

  double Distance() const { return this->Reached; }

  /// Moves points to positions that are far. If this makes hexahedra too bad, it is undone, and the
  /// points responsible move less far the next time. Returns false if another round is useless.
  /// 1. Snap moves boundary points to far positions and holds them.
  /// 2. OptimizeHexahedra moves the points around them.
  /// 3. Points next to hexahedra that became too bad move half as far the next time.
  /// 4. The round is undone if hexahedra are too bad or the distance did not fall.
  bool Round(const SnappingOptions& options, const Progress& progress)
  {
    const Eigen::MatrixXd before = this->Solid.Points;
    const std::vector<char> freedoms = this->Constraint.Freedoms;
    const std::vector<FarPosition> far = this->Far;
    const double reached = this->Reached;
    const double minimum = Floor(options, ComputeScaledJacobians(this->Solid).minCoeff());
    std::vector<char> marked = this->Snap();
    if (marked.empty())
    {
      return false;
    }
    // The neighbourhood that may follow the points that were moved.
    constexpr int rings = 3;
    GrowRings(this->Solid.Hexahedra, rings, marked);
    HexOptimizationOptions optimization;
    optimization.Marked = std::move(marked);
    // Worse hexahedra could not be raised to the minimum, and the round will be undone.
    optimization.RaiseFrom = minimum - MaximumRaised;
    const HexOptimizationResult result =
      OptimizeHexahedra(this->Solid, this->Constraint, optimization, progress.Part(0.0, 0.8));
    const bool isBad = result.MinimumAfter < minimum;
    const bool hasCulprits = isBad && this->HalveCulprits(freedoms, minimum);
    if (!isBad)
    {
      this->Compare(progress.Part(0.8, 1.0));
    }
    if (isBad || this->Reached >= reached)
    {
      this->Solid.Points = before;
      this->Constraint.Freedoms = freedoms;
      this->Far = far;
      this->Reached = reached;
      return hasCulprits;
    }
    return true;
  }

private:
  static double Floor(const SnappingOptions& options, double minimum)
  {
    const auto found = std::find_if(options.ScaledJacobians.begin(), options.ScaledJacobians.end(),
      [&](double value) { return value <= minimum; });
    return found == options.ScaledJacobians.end() ? minimum : *found;
  }

  void Compare(const Progress& progress)
  {
    const SurfaceLocator boundary({ this->Solid.Points, this->Triangles });
    const Surface& target = this->Target.GetSurface();
    this->Far.clear();
    this->Add(ComputeDistancesToSurface(target, boundary, progress.Part(0.0, 0.5), this->Wanted),
      &SampledDistances::Positions, &SampledDistances::Nearest);
    this->Add(ComputeDistancesToSurface(
                boundary.GetSurface(), this->Target, progress.Part(0.5, 0.9), this->Wanted),
      &SampledDistances::Nearest, &SampledDistances::Positions);
    std::stable_sort(this->Far.begin(), this->Far.end(),
      [](const FarPosition& a, const FarPosition& b) { return a.Distance > b.Distance; });
    this->Reached = this->Far.empty()
      ? ComputeHausdorffDistance(target, boundary.GetSurface(), progress.Part(0.9, 1.0)).Larger()
      : this->Far.front().Distance;
  }

  void Add(const SampledDistances& positions, Eigen::MatrixXd SampledDistances::*onSurface,
    Eigen::MatrixXd SampledDistances::*onBoundary)
  {
    for (Eigen::Index i = 0; i < positions.Distances.size(); ++i)
    {
      if (positions.Distances(i) > this->Wanted)
      {
        this->Far.push_back({ (positions.*onSurface).row(i), (positions.*onBoundary).row(i),
          positions.Distances(i) });
      }
    }
  }

  /// Halves the share of the way for points of bad hexahedra, or next to such, that were held in
  /// this round. Returns false if there are none.
  bool HalveCulprits(const std::vector<char>& freedoms, double minimum)
  {
    std::vector<char> near = MarkPointsOfBadHexahedra(this->Solid, minimum);
    GrowRings(this->Solid.Hexahedra, 1, near);
    bool found = false;
    for (std::size_t point = 0; point < freedoms.size(); ++point)
    {
      if (near[point] && this->Constraint.Freedoms[point] < freedoms[point])
      {
        this->Share[point] *= 0.5;
        found = true;
      }
    }
    return found;
  }

  /// Returns, for each position that is far, the nearest point of the quad there.
  std::vector<int> NearestPoints() const
  {
    Eigen::MatrixXd positions(this->Far.size(), 3);
    for (std::size_t i = 0; i < this->Far.size(); ++i)
    {
      positions.row(static_cast<Eigen::Index>(i)) = this->Far[i].OnBoundary;
    }
    const Eigen::VectorXi triangles =
      SurfaceLocator({ this->Solid.Points, this->Triangles }).Find(positions).Triangles;
    std::vector<int> nearest;
    for (std::size_t i = 0; i < this->Far.size(); ++i)
    {
      const auto quad = this->Quads.row(triangles(static_cast<Eigen::Index>(i)) / 2);
      const auto distance = [&](int point)
      { return (this->Solid.Points.row(point) - this->Far[i].OnSurface).squaredNorm(); };
      nearest.push_back(*std::min_element(
        quad.begin(), quad.end(), [&](int a, int b) { return distance(a) < distance(b); }));
    }
    return nearest;
  }

  /// Moves the nearest boundary point to each position that is far, the farthest first, and holds
  /// it. Points next to one that was moved are skipped. Returns marks of the points that were
  /// moved, or nothing if there are none.
  std::vector<char> Snap()
  {
    // A point whose share was halved three times is given up.
    constexpr double minimumShare = 0.2;
    const std::vector<int> nearest = this->NearestPoints();
    std::vector<char> marked, taken(this->Solid.Points.rows(), 0);
    for (std::size_t i = 0; i < nearest.size(); ++i)
    {
      const int point = nearest[i];
      const Eigen::RowVector3d& there = this->Far[i].OnSurface;
      // The last condition: the position must lie on the part of the surface that the point is
      // kept on. Otherwise the projection would bring the point back.
      if (taken[point] || this->Given.Freedom(point) != 2 || this->Share[point] < minimumShare ||
        (this->Constraint.Nearest(point, there) - there).norm() > 0.5 * this->Far[i].Distance)
      {
        continue;
      }
      const Eigen::RowVector3d here = this->Solid.Points.row(point);
      this->Solid.Points.row(point) =
        this->Constraint.Nearest(point, here + this->Share[point] * (there - here));
      this->Constraint.Freedoms[point] = 0;
      marked.resize(taken.size(), 0);
      marked[point] = 1;
      for (const int q : this->QuadsAround[point])
      {
        const auto around = this->Quads.row(q);
        std::for_each(around.begin(), around.end(), [&](int other) { taken[other] = 1; });
      }
    }
    return marked;
  }

  HexMesh& Solid;
  const Eigen::MatrixXi& Quads;
  const Eigen::MatrixXi Triangles;
  const SurfaceLocator Target;
  const PointConstraint& Given;
  OverridableConstraint Constraint;
  std::vector<double> Share; ///< fraction of the way that each point is moved
  const double Wanted;
  std::vector<std::vector<int>> QuadsAround; ///< the quads around each point
  double Reached = 0.0;
  std::vector<FarPosition> Far;
};

} // namespace

double SnapToFarPositions(HexMesh& mesh, const Eigen::MatrixXi& quads, const Surface& surface,
  const PointConstraint& constraint, const SnappingOptions& options, const Progress& progress)
{
  Snapper snapper(mesh, quads, surface, constraint, options.WantedDistance);
  for (int round = 0; round < options.Rounds && snapper.Distance() > options.WantedDistance;
       ++round)
  {
    const Progress part =
      progress.Part(static_cast<double>(round) / options.Rounds, (round + 1.0) / options.Rounds);
    if (!snapper.Round(options, part))
    {
      break;
    }
  }
  progress(1.0);
  return snapper.Distance();
}

} // namespace shape
