#include "Untangle/Private/PointCluster.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace shape
{
namespace
{

/// Returns the simplices of the corners of a tetrahedron that are among some points.
std::vector<std::vector<int>> FindSimplicesAmong(
  const std::set<int>& points, const std::vector<int>& tetrahedron)
{
  std::vector<int> inside;
  std::copy_if(tetrahedron.begin(), tetrahedron.end(), std::back_inserter(inside),
    [&](int corner) { return points.count(corner) > 0; });
  std::sort(inside.begin(), inside.end());
  std::vector<std::vector<int>> simplices;
  for (unsigned int subset = 1; subset < (1U << inside.size()); ++subset)
  {
    std::vector<int> simplex;
    for (std::size_t k = 0; k < inside.size(); ++k)
    {
      if (subset >> k & 1U)
      {
        simplex.push_back(inside[k]);
      }
    }
    simplices.push_back(std::move(simplex));
  }
  return simplices;
}

} // namespace

PointCluster::PointCluster(
  SolidCells& solid, const ConeExpansionOptions& options, const Progress& progress)
  : Solid(solid)
  , MaySplit(options.SplitCells)
  , MaximumWork(options.MaximumWork)
  , Report(progress)
{
}

void PointCluster::Begin(const std::vector<int>& members)
{
  for (const int point : this->Joined)
  {
    this->Ids[point] = 0;
    this->Moves[point].reset();
  }
  this->Joined.clear();
  this->Members.clear();
  this->Id = 1;
  for (const int point : members)
  {
    this->Add(point);
  }
}

void PointCluster::Count(std::size_t cells) const
{
  constexpr double interval = 1000.0;
  this->Work += static_cast<double>(cells);
  if (this->Work > this->MaximumWork)
  {
    throw WorkSpent();
  }
  if (this->Work >= this->NextReport)
  {
    this->NextReport = this->Work + interval;
    this->Report(0.0);
  }
}

bool PointCluster::IsMovable(const SolidCells& solid, int point)
{
  const std::vector<int>& cells = solid.CellsOf(point);
  return !solid.OnBoundary(point) &&
    std::all_of(
      cells.begin(), cells.end(), [&](int cell) { return solid.PointsOf(cell).size() == 4; });
}

bool PointCluster::CanSplit(const std::vector<int>& simplex) const
{
  return this->MaySplit && this->Solid.CanSplit(simplex);
}

Eigen::RowVector3d PointCluster::ComputeCentroid() const
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const int point : this->Members)
  {
    sum += this->Solid.Points.row(point);
  }
  return sum / static_cast<double>(this->Members.size());
}

void PointCluster::MoveTo(const Eigen::RowVector3d& position)
{
  for (const int point : this->Members)
  {
    this->Solid.Points.row(point) = position;
    this->Moves[point].reset();
  }
}

void PointCluster::Add(int point)
{
  this->Ids.resize(this->Solid.PointCount(), 0);
  this->Moves.resize(this->Solid.PointCount());
  this->Ids[point] = this->Id;
  this->Members.push_back(point);
  this->Joined.push_back(point);
}

void PointCluster::Release(const std::vector<int>& part, int id)
{
  for (const int point : part)
  {
    this->Ids[point] = id;
  }
  this->Members.erase(std::remove_if(this->Members.begin(), this->Members.end(),
                        [&](int point) { return !this->IsIn(point); }),
    this->Members.end());
}

void PointCluster::Select(std::vector<int> part)
{
  this->Members = std::move(part);
  this->Id = this->Ids[this->Members.front()];
  for (const int point : this->Members)
  {
    this->Moves[point].reset();
  }
}

void PointCluster::ForgetMoves(int point)
{
  for (const int other : this->FindNeighbours(point))
  {
    this->Moves[other].reset();
  }
}

std::vector<int> PointCluster::FindNeighbours(int point) const
{
  this->Count(this->Solid.CellsOf(point).size());
  return this->Solid.NeighboursOf(point);
}

std::vector<int> PointCluster::FindPointsAround() const
{
  std::set<int> found(this->Members.begin(), this->Members.end());
  for (const int point : this->Members)
  {
    const std::vector<int> neighbours = this->FindNeighbours(point);
    found.insert(neighbours.begin(), neighbours.end());
  }
  return { found.begin(), found.end() };
}

bool PointCluster::IsSurrounded(int point) const
{
  const std::vector<int>& cells = this->Solid.CellsOf(point);
  this->Count(cells.size());
  return std::all_of(cells.begin(), cells.end(),
    [&](int cell)
    {
      const std::vector<int>& corners = this->Solid.PointsOf(cell);
      return std::all_of(
        corners.begin(), corners.end(), [&](int corner) { return this->IsIn(corner); });
    });
}

bool PointCluster::IsWide(const StarFace& face) const
{
  const int a = this->Ids[face[0]], b = this->Ids[face[1]], c = this->Ids[face[2]];
  return (a == 0 || (a != b && a != c)) && (b == 0 || b != c);
}

bool PointCluster::IsOutside(const StarFace& face) const
{
  return std::none_of(face.begin(), face.end(), [&](int point) { return this->IsIn(point); });
}

std::vector<StarFace> PointCluster::FindAllFacesAround(int point) const
{
  this->Count(this->Solid.CellsOf(point).size());
  return shape::FindFacesAround(this->Solid, point);
}

std::vector<StarFace> PointCluster::FindFacesAround(int point) const
{
  std::vector<StarFace> faces = this->FindAllFacesAround(point);
  faces.erase(std::remove_if(faces.begin(), faces.end(),
                [&](const StarFace& face) { return !this->IsWide(face); }),
    faces.end());
  return faces;
}

std::vector<StarFace> PointCluster::FindOuterFacesAround(int point) const
{
  std::vector<StarFace> faces = this->FindFacesAround(point);
  faces.erase(std::remove_if(faces.begin(), faces.end(),
                [&](const StarFace& face) { return !this->IsOutside(face); }),
    faces.end());
  return faces;
}

std::vector<StarFace> PointCluster::FindOuterFaces(const std::vector<int>& points) const
{
  std::vector<StarFace> faces;
  for (const int point : points)
  {
    const std::vector<StarFace> around = this->FindOuterFacesAround(point);
    faces.insert(faces.end(), around.begin(), around.end());
  }
  return faces;
}

std::vector<StarFace> PointCluster::FindFacesAroundPart(const std::vector<int>& part)
{
  // For a moment the part is a cluster of its own.
  constexpr int temporary = -1;
  const auto isInPart = [&](int point) { return this->Ids[point] == temporary; };
  for (const int point : part)
  {
    this->Ids[point] = temporary;
  }
  std::vector<StarFace> faces;
  for (const int point : part)
  {
    const std::vector<StarFace> around = this->FindFacesAround(point);
    std::copy_if(around.begin(), around.end(), std::back_inserter(faces),
      [&](const StarFace& face) { return std::none_of(face.begin(), face.end(), isInPart); });
  }
  for (const int point : part)
  {
    this->Ids[point] = this->Id;
  }
  return faces;
}

StarPlacement PointCluster::FindPlacement(
  const std::vector<StarFace>& faces, const Eigen::RowVector3d& origin) const
{
  this->Count(faces.size());
  return FindKernelCentre(this->Solid.Points, faces, origin);
}

StarPlacement PointCluster::FindPlacement(int point) const
{
  return this->FindPlacement(this->FindFacesAround(point), this->Solid.Points.row(point));
}

StarPlacement PointCluster::FindPlacementIfJoined(int point, const std::vector<int>& joined)
{
  std::vector<int> kept;
  for (const int other : joined)
  {
    kept.push_back(this->Ids[other]);
    this->Ids[other] = this->Id;
  }
  StarPlacement placement = this->FindPlacement(point);
  for (std::size_t k = 0; k < joined.size(); ++k)
  {
    this->Ids[joined[k]] = kept[k];
  }
  return placement;
}

bool PointCluster::IsPeelable(int point) const
{
  const std::vector<StarFace> faces = this->FindAllFacesAround(point);
  std::vector<int> points;
  for (const StarFace& face : faces)
  {
    points.insert(points.end(), face.begin(), face.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto indexOf = [&](int corner)
  {
    return static_cast<int>(
      std::lower_bound(points.begin(), points.end(), corner) - points.begin());
  };
  DisjointSets sets(static_cast<int>(points.size()));
  for (const StarFace& face : faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = face[k], b = face[(k + 1) % 3];
      if (this->IsIn(a) == this->IsIn(b))
      {
        sets.Merge(indexOf(a), indexOf(b));
      }
    }
  }
  int inside = 0, outside = 0;
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
  {
    if (sets.Find(i) == i)
    {
      ++(this->IsIn(points[i]) ? inside : outside);
    }
  }
  return inside <= 1 && outside == 1;
}

bool PointCluster::IsCollapsible()
{
  std::vector<int> left = this->Members;
  for (std::size_t before = left.size() + 1; left.size() < before && left.size() > 1;)
  {
    before = left.size();
    left.erase(std::remove_if(left.begin(), left.end(),
                 [&](int point)
                 {
                   const bool isGone = this->IsPeelable(point);
                   this->Pretend(point, !isGone);
                   return isGone;
                 }),
      left.end());
  }
  for (const int point : this->Members)
  {
    this->Pretend(point, true);
  }
  return left.size() <= 1;
}

bool PointCluster::IsDivision(const std::vector<int>& part) const
{
  const std::set<int> chosen(part.begin(), part.end());
  std::set<int> rest(this->Members.begin(), this->Members.end());
  for (const int point : part)
  {
    rest.erase(point);
  }
  return !rest.empty() && this->IsConnected(chosen) && this->IsConnected(rest) &&
    this->IsContractible(part) && this->IsContractible({ rest.begin(), rest.end() });
}

/// Whether cells connect some points.
bool PointCluster::IsConnected(const std::set<int>& points) const
{
  std::set<int> left = points;
  std::vector<int> front = { *left.begin() };
  left.erase(left.begin());
  while (!front.empty())
  {
    const int point = front.back();
    front.pop_back();
    for (const int other : this->FindNeighbours(point))
    {
      if (left.erase(other) > 0)
      {
        front.push_back(other);
      }
    }
  }
  return left.empty();
}

/// Whether the simplices of some points have the Euler characteristic of a ball.
bool PointCluster::IsContractible(const std::vector<int>& part) const
{
  const std::set<int> points(part.begin(), part.end());
  std::set<std::vector<int>> simplices;
  for (const int point : part)
  {
    for (const int cell : this->Solid.CellsOf(point))
    {
      std::vector<std::vector<int>> among = FindSimplicesAmong(points, this->Solid.PointsOf(cell));
      this->Count(among.size());
      for (std::vector<int>& simplex : among)
      {
        simplices.insert(std::move(simplex));
      }
    }
  }
  int characteristic = 0;
  for (const std::vector<int>& simplex : simplices)
  {
    characteristic += simplex.size() % 2 == 1 ? 1 : -1;
  }
  return characteristic == 1;
}

} // namespace shape
