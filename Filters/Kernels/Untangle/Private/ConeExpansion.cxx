#include "Untangle/Private/ConeExpansion.h"

#include "Geometry/Orientation.h"
#include "Untangle/Private/CellSplits.h"
#include "Untangle/Private/InscribedBall.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace shape
{
namespace
{

/// Points p, q, r of a tetrahedron around a point v, such that (q - p) x (r - p) . (v - p) is its
/// determinant.
using StarFace = std::array<int, 3>;

StarFace FaceOpposite(const std::vector<int>& tetrahedron, int point)
{
  static constexpr int opposite[4][3] = { { 1, 3, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 2 } };
  const auto at = std::find(tetrahedron.begin(), tetrahedron.end(), point) - tetrahedron.begin();
  return { tetrahedron[opposite[at][0]], tetrahedron[opposite[at][1]],
    tetrahedron[opposite[at][2]] };
}

/// Where a point or a cluster may be, relative to half-spaces.
struct Placement
{
  bool IsValid = false;
  Eigen::RowVector3d Position = Eigen::RowVector3d::Zero();
  double Clearance = 0.0; ///< distance from the planes, relative to the size of the star
};

/// A cluster of inner points at one position, which is expanded.
class Cluster
{
public:
  Cluster(SolidCells& solid, const std::vector<int>& members)
    : Solid(solid)
    , In(solid.PointCount(), 0)
  {
    for (const int point : members)
    {
      this->Add(point);
    }
    this->StartCount = static_cast<int>(members.size());
  }

  bool Contains(int point) const { return this->In[point]; }
  const std::vector<int>& Points() const { return this->Members; }

  /// Enlarges the cluster until one position sees all faces opposite to a single point. Returns
  /// false if there is none.
  bool Place(const Progress& progress)
  {
    for (;;)
    {
      progress(0.0);
      std::vector<StarFace> faces = this->OuterFaces();
      const Placement found = this->FindPlacement(faces, this->Centroid());
      if (found.IsValid)
      {
        this->MoveTo(found.Position);
        return true;
      }
      if (!this->Grow(faces, found.Position))
      {
        return false;
      }
    }
  }

  void AddRing()
  {
    const std::vector<int> members = this->Members;
    for (const int point : members)
    {
      for (const int other : this->Neighbours(point))
      {
        if (!this->In[other] && this->IsMovable(other))
        {
          this->Add(other);
        }
      }
    }
    this->StartCount = static_cast<int>(this->Members.size());
  }

  /// Moves all points out of the cluster. Returns false if that takes too many splits.
  bool Expand(const ConeExpansionOptions& options, ConeExpansionResult& result,
    const Progress& progress)
  {
    const auto start = static_cast<double>(this->Members.size());
    const double allowed = 100.0 + options.MaximumSplits * start;
    double most = start;
    int splits = 0;
    bool isRelaxed = false;
    while (!this->Members.empty())
    {
      const auto left = static_cast<double>(this->Members.size());
      most = std::max(most, left);
      progress(1.0 - left / most);
      int best = this->FindClearest(progress);
      if (best >= 0 && (this->Known[best].Clearance > Comfortable || isRelaxed))
      {
        this->Release(best);
        ++result.Expansions;
        isRelaxed = false;
        continue;
      }
      if (!isRelaxed)
      {
        this->RelaxAll(progress);
        isRelaxed = true;
        continue;
      }
      std::vector<int> spokes;
      best = this->FindCut(spokes, progress);
      if (best < 0 || splits + spokes.size() > allowed)
      {
        return false;
      }
      for (const int end : spokes)
      {
        this->SplitSpoke(best, end);
      }
      splits += static_cast<int>(spokes.size());
      result.Splits += static_cast<int>(spokes.size());
      this->Known[best] = this->FindPlacement(best);
      if (!this->Known[best].IsValid)
      {
        return false;
      }
      this->Release(best);
      ++result.Expansions;
      isRelaxed = false;
    }
    return true;
  }

private:
  /// Points with this clearance leave the cluster before others are moved to make space.
  static constexpr double Comfortable = 0.02;

  void Add(int point)
  {
    this->In.resize(this->Solid.PointCount(), 0);
    this->Known.resize(this->Solid.PointCount());
    this->IsKnown.resize(this->Solid.PointCount(), 0);
    this->In[point] = 1;
    this->Members.push_back(point);
  }

  bool IsMovable(int point) const
  {
    const std::vector<int>& cells = this->Solid.CellsOf(point);
    return !this->Solid.OnBoundary(point) &&
      std::all_of(cells.begin(), cells.end(),
        [&](int cell) { return this->Solid.PointsOf(cell).size() == 4; });
  }

  Eigen::RowVector3d PositionOf(int point) const
  {
    return this->In[point] ? this->Position : Eigen::RowVector3d(this->Solid.Points.row(point));
  }

  Eigen::RowVector3d Centroid() const
  {
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    for (const int point : this->Members)
    {
      sum += this->Solid.Points.row(point);
    }
    return sum / static_cast<double>(this->Members.size());
  }

  void MoveTo(const Eigen::RowVector3d& position)
  {
    this->Position = position;
    for (const int point : this->Members)
    {
      this->Solid.Points.row(point) = position;
      this->IsKnown[point] = 0;
    }
  }

  int CountIn(const StarFace& face) const
  {
    return this->In[face[0]] + this->In[face[1]] + this->In[face[2]];
  }

  std::set<int> Neighbours(int point) const
  {
    std::set<int> found;
    for (const int cell : this->Solid.CellsOf(point))
    {
      found.insert(this->Solid.PointsOf(cell).begin(), this->Solid.PointsOf(cell).end());
    }
    found.erase(point);
    return found;
  }

  /// Returns the faces opposite to a point whose tetrahedra have volume: at most one corner of such
  /// a face is in the cluster, or none if the point is in it and `isOuter`.
  std::vector<StarFace> FacesAround(int point, int maximum) const
  {
    std::vector<StarFace> faces;
    for (const int cell : this->Solid.CellsOf(point))
    {
      const StarFace face = FaceOpposite(this->Solid.PointsOf(cell), point);
      if (this->CountIn(face) <= maximum)
      {
        faces.push_back(face);
      }
    }
    return faces;
  }

  /// Returns the faces that the cluster has to see.
  std::vector<StarFace> OuterFaces() const
  {
    std::vector<StarFace> faces;
    for (const int point : this->Members)
    {
      const std::vector<StarFace> around = this->FacesAround(point, 0);
      faces.insert(faces.end(), around.begin(), around.end());
    }
    return faces;
  }

  /// The Chebyshev centre of the positions that see all faces, checked exactly.
  Placement FindPlacement(
    const std::vector<StarFace>& faces, const Eigen::RowVector3d& origin) const
  {
    Placement placement;
    placement.Position = origin;
    double size = 0.0;
    for (const StarFace& face : faces)
    {
      for (const int point : face)
      {
        size = std::max(size, (this->PositionOf(point) - origin).norm());
      }
    }
    std::vector<HalfSpace> halfSpaces;
    halfSpaces.reserve(faces.size());
    for (const StarFace& face : faces)
    {
      const Eigen::Vector3d p = (this->PositionOf(face[0]) - origin).transpose() / size,
                            q = (this->PositionOf(face[1]) - origin).transpose() / size,
                            r = (this->PositionOf(face[2]) - origin).transpose() / size;
      const Eigen::Vector3d normal = (q - p).cross(r - p);
      const double length = normal.norm();
      if (!(length > 0.0))
      {
        return placement;
      }
      halfSpaces.push_back({ normal / length, -normal.dot(p) / length });
    }
    const InscribedBall ball = FindInscribedBall(halfSpaces, 1.0);
    placement.Clearance = ball.Radius;
    placement.Position = origin + size * ball.Centre.transpose();
    placement.IsValid = ball.Radius > 0.0 && this->Sees(placement.Position, faces);
    return placement;
  }

  Placement FindPlacement(int point) const
  {
    return this->FindPlacement(this->FacesAround(point, 1), this->PositionOf(point));
  }

  bool Sees(const Eigen::RowVector3d& position, const std::vector<StarFace>& faces) const
  {
    return std::all_of(faces.begin(), faces.end(),
      [&](const StarFace& face)
      {
        return EvaluateOrientation(this->PositionOf(face[0]), this->PositionOf(face[1]),
                 this->PositionOf(face[2]), position) > 0;
      });
  }

  /// Adds points of the faces that a position does not see. Returns false if there is none to add.
  bool Grow(const std::vector<StarFace>& faces, const Eigen::RowVector3d& position)
  {
    bool isGrown = false;
    for (const StarFace& face : faces)
    {
      if (this->CountIn(face) > 0 ||
        EvaluateOrientation(this->Solid.Points.row(face[0]), this->Solid.Points.row(face[1]),
          this->Solid.Points.row(face[2]), position) > 0)
      {
        continue;
      }
      bool isMovable = false;
      for (const int point : face)
      {
        if (this->IsMovable(point))
        {
          this->Add(point);
          isMovable = true;
        }
      }
      isGrown = isGrown || isMovable || this->SplitFixed(face);
      isGrown = isGrown || isMovable;
    }
    return isGrown;
  }

  /// Inserts a point of the cluster into a face or one of its edges, if it is not on the boundary.
  bool SplitFixed(const StarFace& face)
  {
    std::vector<int> simplex;
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const std::vector<int> edge = { face[k], face[(k + 1) % 3] };
      const double length =
        (this->Solid.Points.row(edge[0]) - this->Solid.Points.row(edge[1])).norm();
      if (length > longest && this->Solid.CanSplit(edge))
      {
        longest = length;
        simplex = edge;
      }
    }
    if (simplex.empty() && this->Solid.CanSplit({ face[0], face[1], face[2] }))
    {
      simplex = { face[0], face[1], face[2] };
    }
    if (simplex.empty())
    {
      return false;
    }
    this->Add(this->Solid.Split(simplex));
    return true;
  }

  /// Whether the points around a point that are in the cluster are connected, and the others, too.
  /// The cluster then keeps its topology without the point.
  bool IsPeelable(int point) const
  {
    std::map<int, int> parents;
    const auto find = [&](int p)
    {
      while (parents.at(p) != p)
      {
        p = parents.at(p);
      }
      return p;
    };
    const std::vector<StarFace> faces = this->FacesAround(point, 3);
    for (const StarFace& face : faces)
    {
      for (const int p : face)
      {
        parents.emplace(p, p);
      }
    }
    for (const StarFace& face : faces)
    {
      for (int k = 0; k < 3; ++k)
      {
        if (this->In[face[k]] == this->In[face[(k + 1) % 3]])
        {
          parents[find(face[k])] = find(face[(k + 1) % 3]);
        }
      }
    }
    int inside = 0, outside = 0;
    for (const auto& [p, parent] : parents)
    {
      if (p == parent)
      {
        ++(this->In[p] ? inside : outside);
      }
    }
    return inside <= 1 && outside == 1;
  }

  /// Returns the point that can leave the cluster with the greatest clearance, or -1.
  int FindClearest(const Progress& progress)
  {
    int best = -1;
    for (const int point : this->Members)
    {
      if (!this->IsKnown[point])
      {
        progress(0.0);
        this->IsKnown[point] = 1;
        this->Known[point] = {};
        if (this->IsPeelable(point))
        {
          this->Known[point] = this->FindPlacement(point);
        }
      }
      const Placement& known = this->Known[point];
      if (known.IsValid && (best < 0 || known.Clearance > this->Known[best].Clearance))
      {
        best = point;
      }
    }
    return best;
  }

  void Forget(int point)
  {
    for (const int other : this->Neighbours(point))
    {
      this->IsKnown[other] = 0;
    }
  }

  /// Moves a point from the cluster to its known placement, and those around it to their centres.
  void Release(int point)
  {
    this->Solid.Points.row(point) = this->Known[point].Position;
    this->In[point] = 0;
    this->Members.erase(std::find(this->Members.begin(), this->Members.end(), point));
    this->Forget(point);
    for (const int other : this->Neighbours(point))
    {
      this->Relax(other);
    }
    this->Relax(point);
  }

  /// Moves a point that has left the cluster to the centre of its kernel. Returns whether it moved.
  bool Relax(int point)
  {
    if (this->In[point] || !this->IsMovable(point))
    {
      return false;
    }
    const std::vector<StarFace> faces = this->FacesAround(point, 1);
    const Eigen::RowVector3d before = this->Solid.Points.row(point);
    const Placement found = this->FindPlacement(faces, before);
    if (!found.IsValid || (found.Position - before).norm() < 1e-3 * this->SizeOf(faces, before))
    {
      return false;
    }
    this->Solid.Points.row(point) = found.Position;
    this->Forget(point);
    return true;
  }

  double SizeOf(const std::vector<StarFace>& faces, const Eigen::RowVector3d& origin) const
  {
    double size = 0.0;
    for (const StarFace& face : faces)
    {
      size = std::max(size, (this->PositionOf(face[0]) - origin).norm());
    }
    return size;
  }

  /// Moves the points around the cluster, and the cluster itself, to the centres of their kernels.
  void RelaxAll(const Progress& progress)
  {
    std::set<int> around;
    for (const int point : this->Members)
    {
      const std::set<int> neighbours = this->Neighbours(point);
      around.insert(neighbours.begin(), neighbours.end());
    }
    constexpr int sweeps = 3;
    for (int sweep = 0; sweep < sweeps; ++sweep)
    {
      for (const int point : around)
      {
        progress(0.0);
        this->Relax(point);
      }
      const Placement found = this->FindPlacement(this->OuterFaces(), this->Position);
      if (found.IsValid && found.Position != this->Position)
      {
        this->MoveTo(found.Position);
      }
    }
  }

  /// Finds the point that can leave the cluster after the fewest splits. ends: the other ends of the
  /// edges to split. Returns -1 if there is none.
  int FindCut(std::vector<int>& ends, const Progress& progress)
  {
    int best = -1;
    double clearance = 0.0;
    for (const int point : this->Members)
    {
      progress(0.0);
      std::vector<StarFace> faces = this->FacesAround(point, 0);
      for (std::size_t seed = 0; seed < faces.size(); ++seed)
      {
        for (const bool isGrown : { true, false })
        {
          std::vector<int> spokes = this->HiddenFrom(point, faces, seed, isGrown);
          if (best >= 0 && spokes.size() > ends.size())
          {
            continue;
          }
          if (!std::all_of(spokes.begin(), spokes.end(),
                [&](int end) { return this->Solid.CanSplit({ point, end }); }))
          {
            continue;
          }
          // As if these points were in the cluster.
          for (const int end : spokes)
          {
            this->In[end] = 1;
          }
          const Placement placement = this->FindPlacement(point);
          for (const int end : spokes)
          {
            this->In[end] = 0;
          }
          if (placement.IsValid &&
            (best < 0 || spokes.size() < ends.size() || placement.Clearance > clearance))
          {
            best = point;
            clearance = placement.Clearance;
            ends = std::move(spokes);
            break;
          }
        }
      }
    }
    return best;
  }

  /// Returns the points around `point` outside the cluster that are not in the part of `faces` which
  /// is star-shaped as seen from the centre of face `seed`; or in that face alone, unless isGrown.
  std::vector<int> HiddenFrom(
    int point, const std::vector<StarFace>& faces, std::size_t seed, bool isGrown) const
  {
    const auto direction = [&](int p) -> Eigen::Vector3d
    { return (this->Solid.Points.row(p) - this->Position).normalized().transpose(); };
    const StarFace& first = faces[seed];
    const Eigen::Vector3d view = direction(first[0]) + direction(first[1]) + direction(first[2]);
    std::set<int> seen(first.begin(), first.end());
    // Edges in the order in which a face has them.
    std::map<std::pair<int, int>, std::size_t> faceAt;
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        faceAt[{ faces[i][k], faces[i][(k + 1) % 3] }] = i;
      }
    }
    std::vector<char> taken(faces.size(), 0);
    taken[seed] = 1;
    const double sign = view.dot(direction(first[0]).cross(direction(first[1]))) > 0.0 ? 1.0 : -1.0;
    std::vector<std::size_t> front = { seed };
    while (isGrown && !front.empty())
    {
      const StarFace face = faces[front.back()];
      front.pop_back();
      for (int k = 0; k < 3; ++k)
      {
        const auto next = faceAt.find({ face[(k + 1) % 3], face[k] });
        if (next == faceAt.end() || taken[next->second])
        {
          continue;
        }
        const StarFace& other = faces[next->second];
        bool isSeen = true;
        for (int e = 0; e < 3; ++e)
        {
          const int a = other[e], b = other[(e + 1) % 3];
          const bool isShared = a == face[(k + 1) % 3] && b == face[k];
          isSeen = isSeen &&
            (isShared || sign * view.dot(direction(a).cross(direction(b))) > 0.0);
        }
        if (isSeen)
        {
          taken[next->second] = 1;
          seen.insert(other.begin(), other.end());
          front.push_back(next->second);
        }
      }
    }
    std::vector<int> hidden;
    for (const int other : this->Neighbours(point))
    {
      if (!this->In[other] && !seen.count(other))
      {
        hidden.push_back(other);
      }
    }
    return hidden;
  }

  void SplitSpoke(int point, int end)
  {
    const int middle = this->Solid.Split({ point, end });
    this->Add(middle);
    this->Solid.Points.row(middle) = this->Position;
    this->Forget(middle);
  }

  SolidCells& Solid;
  std::vector<char> In;
  std::vector<int> Members;
  std::vector<Placement> Known; ///< for each member: where it can move
  std::vector<char> IsKnown;
  Eigen::RowVector3d Position = Eigen::RowVector3d::Zero();
  int StartCount = 0;
};

/// Returns the inner points of an inverted tetrahedron and of those connected to it by such points,
/// or none if no tetrahedron is inverted that has not been tried.
std::vector<int> NextCluster(SolidCells& solid, std::vector<char>& tried)
{
  tried.resize(solid.CellCount(), 0);
  for (int first = 0; first < solid.CellCount(); ++first)
  {
    if (tried[first] || solid.PointsOf(first).size() != 4 || !solid.Inverted(first))
    {
      continue;
    }
    std::vector<int> points, cells = { first };
    std::vector<char> taken(solid.PointCount(), 0);
    tried[first] = 1;
    while (!cells.empty())
    {
      const int cell = cells.back();
      cells.pop_back();
      for (const int point : solid.PointsOf(cell))
      {
        const std::vector<int>& around = solid.CellsOf(point);
        if (taken[point] || solid.OnBoundary(point) ||
          std::any_of(around.begin(), around.end(),
            [&](int other) { return solid.PointsOf(other).size() != 4; }))
        {
          continue;
        }
        taken[point] = 1;
        points.push_back(point);
        for (const int other : around)
        {
          if (!tried[other] && solid.Inverted(other))
          {
            tried[other] = 1;
            cells.push_back(other);
          }
        }
      }
    }
    if (!points.empty())
    {
      return points;
    }
  }
  return {};
}

} // namespace

ConeExpansionResult ExpandInverted(
  SolidCells& solid, const ConeExpansionOptions& options, const Progress& progress)
{
  ConeExpansionResult result;
  CellSplits splits(solid, [&](int point) { return !solid.OnBoundary(point); });
  std::vector<int> inverted;
  for (int cell = 0; cell < solid.CellCount(); ++cell)
  {
    if (solid.Inverted(cell))
    {
      inverted.push_back(cell);
    }
  }
  splits.Impossible(inverted);
  std::vector<char> tried;
  for (;;)
  {
    progress(0.0);
    const std::vector<int> members = NextCluster(solid, tried);
    if (members.empty())
    {
      break;
    }
    const SolidCells kept = solid;
    std::vector<int> enlarged = members;
    for (int attempt = 0; attempt < options.MaximumAttempts; ++attempt)
    {
      Cluster cluster(solid, enlarged);
      if (attempt > 0)
      {
        cluster.AddRing();
      }
      const bool isPlaced = cluster.Place(progress);
      enlarged = cluster.Points();
      enlarged.erase(std::remove_if(enlarged.begin(), enlarged.end(),
                       [&](int point) { return point >= kept.PointCount(); }),
        enlarged.end());
      ConeExpansionResult expanded = result;
      if (isPlaced && cluster.Expand(options, expanded, progress))
      {
        result = expanded;
        break;
      }
      solid = kept;
      if (!isPlaced)
      {
        break;
      }
    }
  }
  return result;
}

} // namespace shape
