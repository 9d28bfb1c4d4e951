#include "Untangle/Private/ClusterExpansion.h"

#include "Untangle/Private/ClusterDivision.h"

#include <algorithm>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

/// By how much the rank of a point is random; the share of its faces that are outside counts 1.
constexpr double Disorder = 0.2;

/// Smaller moves, relative to the size of the star, are not worth the work.
constexpr double MinimumMove = 1e-3;

/// Estimates the size of a star by one corner of each face.
double EstimateReach(const Eigen::MatrixXd& points, const std::vector<StarFace>& faces,
  const Eigen::RowVector3d& origin)
{
  double size = 0.0;
  for (const StarFace& face : faces)
  {
    size = std::max(size, (points.row(face[0]) - origin).norm());
  }
  return size;
}

} // namespace

ClusterExpansion::ClusterExpansion(PointCluster& cluster, unsigned int seed)
  : Cluster(cluster)
  , Splits(cluster)
  , Random(seed)
{
}

bool ClusterExpansion::Expand(
  const ConeExpansionOptions& options, ConeExpansionResult& result, const Progress& progress)
{
  const auto start = static_cast<double>(this->Cluster.Points().size());
  const int given = this->Cluster.Solid.PointCount();
  for (;;)
  {
    const int inserted = this->Cluster.Solid.PointCount() - given;
    if (this->Cluster.Points().size() <= 1)
    {
      if (!this->SelectNext())
      {
        return true;
      }
      continue;
    }
    progress(std::min(1.0, result.Expansions / (start + inserted)));
    if (this->ReleaseClearest())
    {
      ++result.Expansions;
    }
    else if (!this->IsRelaxed)
    {
      this->RelaxAll();
    }
    else if (!this->Divide())
    {
      if (inserted > options.MaximumSplits * start || !this->ReleaseAfterSplits())
      {
        return false;
      }
      ++result.Expansions;
    }
  }
}

/// Goes on with a part that was divided off. Returns whether there is any.
bool ClusterExpansion::SelectNext()
{
  if (!this->Cluster.Points().empty())
  {
    this->Cluster.Release({ this->Cluster.Points().front() }, 0);
  }
  if (this->Waiting.empty())
  {
    return false;
  }
  this->Cluster.Select(std::move(this->Waiting.back()));
  this->Waiting.pop_back();
  this->IsRelaxed = false;
  return true;
}

/// Releases the point that can leave the cluster best. Returns false if there is none, or if there
/// is little space and other points may still move to make more.
bool ClusterExpansion::ReleaseClearest()
{
  const int best = this->FindClearest();
  if (best < 0 || !(this->Cluster.Moves[best]->IsComfortable() || this->IsRelaxed))
  {
    return false;
  }
  const Eigen::RowVector3d position = this->Cluster.Moves[best]->Position;
  this->Release({ best }, position, 0);
  return true;
}

/// Moves a part of the cluster as one. Returns whether there is any.
bool ClusterExpansion::Divide()
{
  ClusterDivision division = FindDivision(this->Cluster);
  if (!division.Placement.IsValid)
  {
    return false;
  }
  this->Release(division.Part, division.Placement.Position, ++this->LastId);
  this->Waiting.push_back(std::move(division.Part));
  return true;
}

/// Splits edges until a point can leave. Returns whether one does.
bool ClusterExpansion::ReleaseAfterSplits()
{
  std::optional<PointExit> exit = this->Splits.FindExitByPulling();
  if (!exit)
  {
    exit = this->Splits.FindExitByParts();
  }
  if (!exit)
  {
    return false;
  }
  this->Release({ exit->Point }, exit->Position, 0);
  return true;
}

/// Returns the point that can leave the cluster best, or -1. Points that most of their faces are
/// outside for come first, so that the cluster stays round.
int ClusterExpansion::FindClearest()
{
  const auto rank = [](const StarPlacement& placement)
  { return std::make_tuple(placement.IsComfortable(), placement.Rank, placement.Clearance); };
  int best = -1;
  for (const int point : this->Cluster.Points())
  {
    std::optional<StarPlacement>& move = this->Cluster.Moves[point];
    if (!move)
    {
      move = this->FindMove(point);
    }
    if (move->IsValid && (best < 0 || rank(*move) > rank(*this->Cluster.Moves[best])))
    {
      best = point;
    }
  }
  return best;
}

/// Returns where a point can leave to; not valid if the cluster would lose its topology.
StarPlacement ClusterExpansion::FindMove(int point)
{
  if (!this->Cluster.IsPeelable(point))
  {
    return {};
  }
  StarPlacement move = this->Cluster.FindPlacement(point);
  move.Rank = static_cast<double>(this->Cluster.FindOuterFacesAround(point).size()) /
      static_cast<double>(this->Cluster.Solid.CellsOf(point).size()) +
    Disorder * std::generate_canonical<double, 32>(this->Random);
  return move;
}

/// Moves points of the cluster to a position, as another cluster or (id 0) by themselves, and those
/// around them to their centres.
void ClusterExpansion::Release(
  const std::vector<int>& part, const Eigen::RowVector3d& position, int id)
{
  this->IsRelaxed = false;
  this->Cluster.Release(part, id);
  for (const int point : part)
  {
    this->Cluster.Solid.Points.row(point) = position;
    this->Cluster.ForgetMoves(point);
  }
  for (const int point : part)
  {
    for (const int other : this->Cluster.FindNeighbours(point))
    {
      this->Relax(other);
    }
    this->Relax(point);
  }
}

/// Moves a point that has left the cluster to the centre of its kernel. Returns whether it moved.
bool ClusterExpansion::Relax(int point)
{
  if (!this->Cluster.IsAlone(point) || !this->Cluster.IsMovable(point))
  {
    return false;
  }
  Eigen::MatrixXd& x = this->Cluster.Solid.Points;
  const std::vector<StarFace> faces = this->Cluster.FindFacesAround(point);
  const Eigen::RowVector3d before = x.row(point);
  const StarPlacement found = this->Cluster.FindPlacement(faces, before);
  if (!found.IsValid ||
    (found.Position - before).norm() < MinimumMove * EstimateReach(x, faces, before))
  {
    return false;
  }
  x.row(point) = found.Position;
  this->Cluster.ForgetMoves(point);
  return true;
}

/// Moves the points around the cluster, and the cluster itself, to the centres of their kernels.
void ClusterExpansion::RelaxAll()
{
  constexpr int sweeps = 3;
  std::set<int> around;
  for (const int point : this->Cluster.Points())
  {
    const std::vector<int> neighbours = this->Cluster.FindNeighbours(point);
    around.insert(neighbours.begin(), neighbours.end());
  }
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (const int point : around)
    {
      this->Relax(point);
    }
    const Eigen::RowVector3d position = this->Cluster.GetPosition();
    const StarPlacement found =
      this->Cluster.FindPlacement(this->Cluster.FindOuterFaces(), position);
    if (found.IsValid && found.Position != position)
    {
      this->Cluster.MoveTo(found.Position);
    }
  }
  this->IsRelaxed = true;
}

} // namespace shape
