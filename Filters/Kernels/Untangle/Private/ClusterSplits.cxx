#include "Untangle/Private/ClusterSplits.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

/// Faces around a position, as seen from there.
class FaceView
{
public:
  FaceView(const Eigen::MatrixXd& points, const Eigen::RowVector3d& eye,
    const std::vector<StarFace>& faces)
    : Points(points)
    , Eye(eye)
    , Faces(faces)
  {
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->FaceAt[{ faces[i][k], faces[i][(k + 1) % 3] }] = i;
      }
    }
  }

  /// Returns the points of a star-shaped set of faces, as seen towards the centre of the face
  /// `seed`, from which it grows over common edges.
  std::set<int> FindSeen(std::size_t seed) const
  {
    const StarFace& first = this->Faces[seed];
    const Eigen::Vector3d a = this->FindDirection(first[0]), b = this->FindDirection(first[1]),
                          c = this->FindDirection(first[2]);
    // Signed so that the edges of the seed run around it counterclockwise.
    const Eigen::Vector3d view = ((a + b + c).dot(a.cross(b)) > 0.0 ? 1.0 : -1.0) * (a + b + c);
    std::set<int> seen(first.begin(), first.end());
    std::vector<char> taken(this->Faces.size(), 0);
    taken[seed] = 1;
    std::vector<std::size_t> front = { seed };
    while (!front.empty())
    {
      const StarFace& face = this->Faces[front.back()];
      front.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        const std::pair<int, int> edge(face[(k + 1) % 3], face[k]);
        const auto next = this->FaceAt.find(edge);
        if (next == this->FaceAt.end() || taken[next->second] ||
          !this->IsTurnedTo(view, next->second, edge))
        {
          continue;
        }
        taken[next->second] = 1;
        seen.insert(this->Faces[next->second].begin(), this->Faces[next->second].end());
        front.push_back(next->second);
      }
    }
    return seen;
  }

private:
  Eigen::Vector3d FindDirection(int point) const
  {
    return (this->Points.row(point) - this->Eye).normalized().transpose();
  }

  /// Whether the edges of a face, except the given one, run counterclockwise around the view.
  bool IsTurnedTo(
    const Eigen::Vector3d& view, std::size_t index, const std::pair<int, int>& except) const
  {
    const StarFace& face = this->Faces[index];
    for (int k = 0; k < 3; ++k)
    {
      const int a = face[k], b = face[(k + 1) % 3];
      if (std::pair<int, int>(a, b) != except &&
        !(view.dot(this->FindDirection(a).cross(this->FindDirection(b))) > 0.0))
      {
        return false;
      }
    }
    return true;
  }

  const Eigen::MatrixXd& Points;
  Eigen::RowVector3d Eye;
  const std::vector<StarFace>& Faces;
  std::map<std::pair<int, int>, std::size_t> FaceAt; ///< by edges, in the order of a face
};

/// Returns the points that are not among those seen.
std::vector<int> FindHidden(const std::vector<int>& points, const std::set<int>& seen)
{
  std::vector<int> hidden;
  std::copy_if(points.begin(), points.end(), std::back_inserter(hidden),
    [&](int point) { return seen.count(point) == 0; });
  return hidden;
}

} // namespace

bool ClusterSplits::Cut::operator<(const Cut& other) const
{
  // Given points first: if new points were split again and again, there would be no end.
  return std::tie(this->Generation, this->Hidden, this->Point) <
    std::tie(other.Generation, other.Hidden, other.Point);
}

std::optional<PointExit> ClusterSplits::FindExitByPulling()
{
  constexpr std::size_t maximumTrials = 8;
  std::vector<Cut> cuts = this->FindCuts(true);
  cuts.resize(std::min(cuts.size(), maximumTrials));
  for (const Cut& cut : cuts)
  {
    if (const std::optional<PointExit> exit = this->TryPulling(cut))
    {
      return exit;
    }
  }
  return std::nullopt;
}

std::optional<PointExit> ClusterSplits::FindExitByParts()
{
  for (const Cut& cut : this->FindCuts(false))
  {
    if (const std::optional<PointExit> exit = this->TryParts(cut))
    {
      return exit;
    }
  }
  return std::nullopt;
}

ClusterSplits::Cut ClusterSplits::FindCut(int point) const
{
  const std::vector<StarFace> faces = this->Cluster.FindOuterFacesAround(point);
  const std::vector<int> outside = this->FindOutside(point);
  const FaceView view(this->Cluster.Solid.Points, this->Cluster.GetPosition(), faces);
  Cut best;
  for (std::size_t seed = 0; seed < faces.size(); ++seed)
  {
    const std::set<int> seen = view.FindSeen(seed);
    this->Cluster.Count(seen.size()); // the square of the faces of a star, which may be thousands
    const std::size_t hidden = FindHidden(outside, seen).size();
    if (best.Point < 0 || hidden < best.Hidden)
    {
      best = { this->GetGeneration(point), hidden, point, seed };
    }
  }
  return best;
}

std::vector<ClusterSplits::Cut> ClusterSplits::FindCuts(bool onlyPeelable) const
{
  std::vector<Cut> cuts;
  for (const int point : this->Cluster.Points())
  {
    if (onlyPeelable && !this->Cluster.IsPeelable(point))
    {
      continue;
    }
    const Cut cut = this->FindCut(point);
    if (cut.Point >= 0)
    {
      cuts.push_back(cut);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/// Returns the points around `point` outside the cluster.
std::vector<int> ClusterSplits::FindOutside(int point) const
{
  std::vector<int> outside;
  for (const int other : this->Cluster.FindNeighbours(point))
  {
    if (!this->Cluster.IsIn(other))
    {
      outside.push_back(other);
    }
  }
  return outside;
}

/// Inserts a point of the cluster into an edge from one of its points.
int ClusterSplits::SplitSpoke(int point, int end)
{
  const int middle = this->Cluster.Solid.Split({ point, end });
  this->Cluster.Add(middle);
  this->Generations.resize(this->Cluster.Solid.PointCount(), 0);
  this->Generations[middle] = this->Generations[point] + 1;
  this->Cluster.Solid.Points.row(middle) = this->Cluster.GetPosition();
  this->Cluster.ForgetMoves(middle);
  return middle;
}

std::optional<PointExit> ClusterSplits::TryPulling(const Cut& cut)
{
  constexpr int rounds = 3;
  const Eigen::MatrixXd& x = this->Cluster.Solid.Points;
  const StarFace face = this->Cluster.FindOuterFacesAround(cut.Point)[cut.Seed];
  const Eigen::RowVector3d to =
    (x.row(face[0]) + x.row(face[1]) + x.row(face[2])) / 3.0 - this->Cluster.GetPosition();
  std::vector<int> pulled;
  for (int round = 0; round < rounds; ++round)
  {
    const Cut best = this->FindCut(cut.Point);
    if (best.Point < 0)
    {
      break;
    }
    this->PullIntoSpokes(cut.Point, best.Seed, pulled);
    this->PullAway(cut.Point, to, pulled);
    const StarPlacement placement = this->Cluster.FindPlacement(cut.Point);
    if (placement.IsValid)
    {
      return PointExit{ cut.Point, placement.Position };
    }
  }
  return std::nullopt;
}

/// Splits the edges to the points that are hidden from face `seed`. New points that can leave the
/// cluster do so, and are appended.
void ClusterSplits::PullIntoSpokes(int point, std::size_t seed, std::vector<int>& pulled)
{
  const std::vector<StarFace> faces = this->Cluster.FindOuterFacesAround(point);
  const FaceView view(this->Cluster.Solid.Points, this->Cluster.GetPosition(), faces);
  for (const int end : FindHidden(this->FindOutside(point), view.FindSeen(seed)))
  {
    if (!this->Cluster.CanSplit({ point, end }))
    {
      continue;
    }
    const int middle = this->SplitSpoke(point, end);
    const StarPlacement placement = this->Cluster.FindPlacement(middle);
    if (placement.IsValid)
    {
      this->Cluster.Release({ middle }, 0);
      this->Cluster.Solid.Points.row(middle) = placement.Position;
      pulled.push_back(middle);
    }
  }
}

/// Moves the pulled points to the centres of their kernels, as if the point had left in direction
/// `to`.
void ClusterSplits::PullAway(
  int point, const Eigen::RowVector3d& to, const std::vector<int>& pulled)
{
  constexpr int sweeps = 5;
  Eigen::MatrixXd& x = this->Cluster.Solid.Points;
  const Eigen::RowVector3d position = this->Cluster.GetPosition();
  this->Cluster.Pretend(point, false);
  x.row(point) = position + 0.1 * to;
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (const int middle : pulled)
    {
      const StarPlacement placement = this->Cluster.FindPlacement(middle);
      if (placement.IsValid)
      {
        x.row(middle) = placement.Position;
      }
    }
  }
  this->Cluster.Pretend(point, true);
  x.row(point) = position;
  this->Cluster.ForgetMoves(point);
  for (const int middle : pulled)
  {
    this->Cluster.ForgetMoves(middle);
  }
}

std::optional<PointExit> ClusterSplits::TryParts(const Cut& cut)
{
  const int point = cut.Point;
  const std::vector<StarFace> faces = this->Cluster.FindOuterFacesAround(point);
  const StarFace seed = faces[cut.Seed];
  const FaceView view(this->Cluster.Solid.Points, this->Cluster.GetPosition(), faces);
  // What is seen is the star-shaped part around the seed, or the seed alone.
  for (const std::set<int>& seen :
    { view.FindSeen(cut.Seed), std::set<int>(seed.begin(), seed.end()) })
  {
    const std::vector<int> hidden = FindHidden(this->FindOutside(point), seen);
    const bool canSplit = std::all_of(hidden.begin(), hidden.end(),
      [&](int end) {
        return this->Cluster.CanSplit({ point, end });
      });
    if (!canSplit || !this->Cluster.FindPlacementIfJoined(point, hidden).IsValid)
    {
      continue;
    }
    for (const int end : hidden)
    {
      this->SplitSpoke(point, end);
    }
    const StarPlacement placement = this->Cluster.FindPlacement(point);
    if (placement.IsValid)
    {
      return PointExit{ point, placement.Position };
    }
  }
  return std::nullopt;
}

} // namespace shape
