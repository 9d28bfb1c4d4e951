#include "CutPaste/Private/PointJoin.h"

#include "Search/ClosestPoint.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// The seam between the loop of a feature and the points around the hole.
class PointSeam
{
public:
  /// rest: the points that remain. loop, hole: those of the feature's loop, and around the hole.
  PointSeam(const Eigen::MatrixXd& rest, const Eigen::MatrixXd& loop, const Eigen::MatrixXd& hole)
    : Rest(rest)
    , Loop(loop)
    , Hole(hole)
    , OfRest(rest)
    , OfLoop(loop)
  {
  }

  /// Returns the largest distance of a point of either side from the other side. added: positions
  /// between both.
  double LargestGap(const std::vector<RowVector3d>& added) const
  {
    double largest = 0.0;
    for (const auto& point : this->Loop.rowwise())
    {
      largest = std::max(largest, DistanceFrom(added, point, this->NearestOfRest(point)));
    }
    for (const auto& point : this->Hole.rowwise())
    {
      largest =
        std::max(largest, DistanceFrom(added, point, this->Loop.row(this->NearestOfLoop(point))));
    }
    return largest;
  }

  /// Returns positions that divide gaps evenly, until none is wider than `spacing`. isSampled:
  /// points of the loop that replace a point of the target; the sampling there is the target's own.
  std::vector<RowVector3d> FindMiddles(double spacing, const std::vector<char>& isSampled) const
  {
    std::vector<RowVector3d> middles;
    const auto close = [&](const RowVector3d& point, const RowVector3d& other)
    {
      if (DistanceFrom(middles, point, other) > spacing)
      {
        // A little closer than needed, as the positions move onto the target.
        const double steps = std::ceil((point - other).norm() / (0.8 * spacing));
        for (double step = 1.0; step < steps; ++step)
        {
          middles.emplace_back(point + step / steps * (other - point));
        }
      }
    };
    for (Eigen::Index i = 0; i < this->Loop.rows(); ++i)
    {
      if (isSampled[i] == 0)
      {
        close(this->Loop.row(i), this->NearestOfRest(this->Loop.row(i)));
      }
    }
    for (const auto& point : this->Hole.rowwise())
    {
      const int nearest = this->NearestOfLoop(point);
      if (isSampled[nearest] == 0)
      {
        close(point, this->Loop.row(nearest));
      }
    }
    return middles;
  }

private:
  /// The distance of a point from another one or, if they are nearer, from the added positions.
  static double DistanceFrom(
    const std::vector<RowVector3d>& added, const RowVector3d& point, const RowVector3d& other)
  {
    double distance = (point - other).norm();
    for (const RowVector3d& position : added)
    {
      distance = std::min(distance, (point - position).norm());
    }
    return distance;
  }

  RowVector3d NearestOfRest(const RowVector3d& point) const
  {
    return this->Rest.row(this->OfRest.Nearest(point, 1).front());
  }
  int NearestOfLoop(const RowVector3d& point) const
  {
    return this->OfLoop.Nearest(point, 1).front();
  }

  const Eigen::MatrixXd& Rest;
  const Eigen::MatrixXd& Loop;
  const Eigen::MatrixXd& Hole;
  PointTree OfRest, OfLoop;
};

} // namespace

PastedFeature JoinFeatureAndPoints(const PointTarget& target, const FeatureFootprint& base,
  const LoopOnPoints& landing, const Eigen::MatrixXd& deformed, const Eigen::MatrixXd& normals)
{
  const Eigen::MatrixXd& given = target.Sampled().Surface.Points;
  std::vector<int> kept, atHole;
  for (int i = 0; i < static_cast<int>(given.rows()); ++i)
  {
    if (landing.IsRemoved[i] == 0)
    {
      kept.push_back(i);
    }
    if (landing.IsNearHole[i] != 0)
    {
      atHole.push_back(i);
    }
  }
  const Eigen::MatrixXd rest = given(kept, Eigen::all);
  const Eigen::MatrixXd loop = deformed(base.Loop, Eigen::all), hole = given(atHole, Eigen::all);
  PastedFeature result;
  result.IsOfPoints = true;
  result.Spacing = target.Spacing();
  std::vector<ClosestPoint> added;
  if (!kept.empty())
  {
    const PointSeam seam(rest, loop, hole);
    std::vector<RowVector3d> positions;
    for (const RowVector3d& middle : seam.FindMiddles(result.Spacing, landing.IsAtSample))
    {
      added.push_back(target.Closest().FindOne(middle));
      positions.push_back(added.back().Position);
    }
    result.LargestGap = seam.LargestGap(positions);
  }
  result.AddedPoints = static_cast<int>(added.size());
  const Eigen::Index first = rest.rows() + result.AddedPoints;
  result.Surface.Points.resize(first + deformed.rows(), 3);
  result.Surface.Points.topRows(rest.rows()) = rest;
  result.Surface.Points.bottomRows(deformed.rows()) = deformed;
  result.Surface.Triangles.resize(0, 3);
  const Eigen::MatrixXd& ofSamples = target.Sampled().Normals;
  result.Normals.resize(result.Surface.Points.rows(), 3);
  result.Normals.topRows(rest.rows()) = ofSamples(kept, Eigen::all);
  result.Normals.bottomRows(normals.rows()) = normals;
  ProvenanceWriter ofTarget(given.rows()), ofFeature(deformed.rows());
  for (const int point : kept)
  {
    ofTarget.AddCopy(point);
  }
  for (std::size_t i = 0; i < added.size(); ++i)
  {
    const Eigen::Index row = rest.rows() + static_cast<Eigen::Index>(i);
    const Eigen::RowVector3i corners = target.Surface().Triangles().row(added[i].Triangle);
    result.Surface.Points.row(row) = added[i].Position;
    result.Normals.row(row) =
      (added[i].Barycentric * ofSamples(corners, Eigen::all)).stableNormalized();
    ofTarget.AddOnTriangle(corners, added[i].Barycentric);
  }
  ofTarget.AddNone(deformed.rows());
  ofFeature.AddNone(first);
  ofFeature.AddCopies(deformed.rows());
  result.Target = ofTarget.Finish(Eigen::VectorXi(0));
  result.Feature = ofFeature.Finish(Eigen::VectorXi(0));
  result.Landings.resize(1);
  result.Landings.front().Cover.Triangles.resize(landing.Covered);
  return result;
}

} // namespace shape
