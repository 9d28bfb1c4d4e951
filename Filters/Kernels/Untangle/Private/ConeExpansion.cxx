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
#include <random>
#include <set>
#include <tuple>
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
  double Rank = 0.0;      ///< points with a greater rank leave a cluster first
};

/// A cluster of inner points at one position, which is expanded.
class Cluster
{
public:
  /// seed: of the order in which points leave, for another attempt.
  Cluster(SolidCells& solid, const std::vector<int>& members, unsigned int seed, bool canSplit,
    double& work)
    : Solid(solid)
    , MaySplit(canSplit)
    , Work(work)
    , Random(seed)
    , Entity(solid.PointCount(), 0)
  {
    for (const int point : members)
    {
      this->Add(point);
    }
  }

  const std::vector<int>& Points() const { return this->Members; }

  /// Enlarges the cluster until one position sees all faces opposite to a single point. Returns
  /// false if there is none.
  bool Place(const Progress& progress)
  {
    constexpr int slowSteps = 12;
    for (int step = 0;; ++step)
    {
      progress(0.0);
      if (step > slowSteps)
      {
        this->AddRing();
      }
      std::vector<StarFace> faces = this->OuterFaces();
      const Placement found = this->FindPlacement(faces, this->Centroid());
      if (found.IsValid)
      {
        if (this->IsCollapsible(progress) || !(this->Fill() || this->AddRing()))
        {
          this->MoveTo(found.Position);
          return true;
        }
        continue;
      }
      if (!this->Grow(faces, found.Position))
      {
        return false;
      }
    }
  }

  /// Adds the movable points around the cluster. Returns whether there are any.
  bool AddRing()
  {
    const std::vector<int> members = this->Members;
    for (const int point : members)
    {
      for (const int other : this->Neighbours(point))
      {
        if (!this->IsIn(other) && this->IsMovable(other))
        {
          this->Add(other);
        }
      }
    }
    return this->Members.size() > members.size();
  }

  /// Divides the cluster until each point is by itself. Returns false if that takes too many
  /// splits.
  bool Expand(
    const ConeExpansionOptions& options, ConeExpansionResult& result, const Progress& progress)
  {
    const auto start = static_cast<double>(this->Members.size());
    const int given = this->Solid.PointCount();
    const double allowed = options.MaximumSplits * start;
    std::vector<std::vector<int>> waiting;
    int last = 1;
    bool isRelaxed = false;
    while (this->Work < options.MaximumWork)
    {
      if (this->Members.size() <= 1)
      {
        if (!this->Members.empty())
        {
          this->Entity[this->Members.front()] = 0;
        }
        if (waiting.empty())
        {
          result.Splits += this->Solid.PointCount() - given;
          return true;
        }
        this->Members = std::move(waiting.back());
        waiting.pop_back();
        this->Id = this->Entity[this->Members.front()];
        for (const int point : this->Members)
        {
          this->IsKnown[point] = 0;
        }
        isRelaxed = false;
        continue;
      }
      progress(std::min(1.0, result.Expansions / (start + this->Solid.PointCount() - given)));
      const int best = this->FindClearest(progress);
      if (best >= 0 && (this->Known[best].Clearance > Comfortable || isRelaxed))
      {
        this->Release({ best }, this->Known[best].Position, 0);
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
      isRelaxed = false;
      std::vector<int> part;
      const Placement placement = this->FindDivision(part, progress);
      if (placement.IsValid)
      {
        this->Release(part, placement.Position, ++last);
        waiting.push_back(std::move(part));
        continue;
      }
      if (this->Solid.PointCount() - given > allowed ||
        !(this->ReleaseAfterSplits(progress) || this->ReleasePart(progress)))
      {
        return false;
      }
      ++result.Expansions;
    }
    return false;
  }

private:
  /// Points with this clearance leave the cluster before others are moved to make space.
  static constexpr double Comfortable = 0.02;

  /// By how much the rank of a point is random; the share of its faces that are outside counts 1.
  static constexpr double Disorder = 0.2;

  void Add(int point)
  {
    this->Entity.resize(this->Solid.PointCount(), 0);
    this->Generations.resize(this->Solid.PointCount(), 0);
    this->Known.resize(this->Solid.PointCount());
    this->IsKnown.resize(this->Solid.PointCount(), 0);
    this->Entity[point] = this->Id;
    this->Members.push_back(point);
  }

  bool CanSplit(const std::vector<int>& simplex) const
  {
    return this->MaySplit && this->Solid.CanSplit(simplex);
  }

  bool IsIn(int point) const { return this->Entity[point] == this->Id; }

  bool IsMovable(int point) const
  {
    const std::vector<int>& cells = this->Solid.CellsOf(point);
    return !this->Solid.OnBoundary(point) &&
      std::all_of(cells.begin(), cells.end(),
        [&](int cell) { return this->Solid.PointsOf(cell).size() == 4; });
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

  Eigen::RowVector3d Position() const { return this->Solid.Points.row(this->Members.front()); }

  void MoveTo(const Eigen::RowVector3d& position)
  {
    for (const int point : this->Members)
    {
      this->Solid.Points.row(point) = position;
      this->IsKnown[point] = 0;
    }
  }

  /// Whether the corners of a face are at different positions.
  bool IsWide(const StarFace& face) const
  {
    const int a = this->Entity[face[0]], b = this->Entity[face[1]], c = this->Entity[face[2]];
    return (a == 0 || (a != b && a != c)) && (b == 0 || b != c);
  }

  bool IsOutside(const StarFace& face) const
  {
    return !this->IsIn(face[0]) && !this->IsIn(face[1]) && !this->IsIn(face[2]);
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

  std::vector<StarFace> AllFacesAround(int point) const
  {
    std::vector<StarFace> faces;
    for (const int cell : this->Solid.CellsOf(point))
    {
      faces.push_back(FaceOpposite(this->Solid.PointsOf(cell), point));
    }
    return faces;
  }

  /// Returns the faces opposite to a point that it sees if it moves alone.
  std::vector<StarFace> FacesAround(int point) const
  {
    std::vector<StarFace> faces = this->AllFacesAround(point);
    faces.erase(std::remove_if(faces.begin(), faces.end(),
                  [&](const StarFace& face) { return !this->IsWide(face); }),
      faces.end());
    return faces;
  }

  /// Returns those of them outside the cluster.
  std::vector<StarFace> OuterFacesAround(int point) const
  {
    std::vector<StarFace> faces = this->FacesAround(point);
    faces.erase(std::remove_if(faces.begin(), faces.end(),
                  [&](const StarFace& face) { return !this->IsOutside(face); }),
      faces.end());
    return faces;
  }

  /// Returns the faces that the cluster has to see.
  std::vector<StarFace> OuterFaces() const
  {
    std::vector<StarFace> faces;
    for (const int point : this->Members)
    {
      const std::vector<StarFace> around = this->OuterFacesAround(point);
      faces.insert(faces.end(), around.begin(), around.end());
    }
    return faces;
  }

  /// The Chebyshev centre of the positions that see all faces, checked exactly.
  Placement FindPlacement(
    const std::vector<StarFace>& faces, const Eigen::RowVector3d& origin) const
  {
    this->Work += static_cast<double>(faces.size());
    Placement placement;
    placement.Position = origin;
    double size = 0.0;
    for (const StarFace& face : faces)
    {
      for (const int point : face)
      {
        size = std::max(size, (this->Solid.Points.row(point) - origin).norm());
      }
    }
    std::vector<HalfSpace> halfSpaces;
    halfSpaces.reserve(faces.size());
    for (const StarFace& face : faces)
    {
      const Eigen::Vector3d p = (this->Solid.Points.row(face[0]) - origin).transpose() / size,
                            q = (this->Solid.Points.row(face[1]) - origin).transpose() / size,
                            r = (this->Solid.Points.row(face[2]) - origin).transpose() / size;
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
    return this->FindPlacement(this->FacesAround(point), this->Solid.Points.row(point));
  }

  bool Sees(const Eigen::RowVector3d& position, const std::vector<StarFace>& faces) const
  {
    return std::all_of(faces.begin(), faces.end(),
      [&](const StarFace& face)
      {
        return EvaluateOrientation(this->Solid.Points.row(face[0]), this->Solid.Points.row(face[1]),
                 this->Solid.Points.row(face[2]), position) > 0;
      });
  }

  /// Adds points of the faces that a position does not see. Returns false if there is none to add.
  bool Grow(const std::vector<StarFace>& faces, const Eigen::RowVector3d& position)
  {
    bool isGrown = false;
    for (const StarFace& face : faces)
    {
      if (!this->IsOutside(face) ||
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
      if (length > longest && this->CanSplit(edge))
      {
        longest = length;
        simplex = edge;
      }
    }
    if (simplex.empty() && this->CanSplit({ face[0], face[1], face[2] }))
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

  /// Whether the simplices of some points have the Euler characteristic of a ball.
  bool IsContractible(const std::vector<int>& part) const
  {
    const std::set<int> points(part.begin(), part.end());
    std::set<std::vector<int>> simplices;
    for (const int point : part)
    {
      for (const int cell : this->Solid.CellsOf(point))
      {
        std::vector<int> inside;
        for (const int corner : this->Solid.PointsOf(cell))
        {
          if (points.count(corner))
          {
            inside.push_back(corner);
          }
        }
        std::sort(inside.begin(), inside.end());
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

  /// Closes holes of the cluster that run around a single edge: one of its ends, or a new point in
  /// it, joins the cluster. Returns whether there are any.
  bool Fill()
  {
    std::map<std::pair<int, int>, bool> edges; // whether the cluster runs around it
    for (const int point : this->Members)
    {
      for (const StarFace& face : this->FacesAround(point))
      {
        for (int k = 0; k < 3; ++k)
        {
          const int a = face[k], b = face[(k + 1) % 3], c = face[(k + 2) % 3];
          if (!this->IsIn(a) && !this->IsIn(b))
          {
            const auto edge = edges.emplace(std::minmax(a, b), true).first;
            edge->second = edge->second && this->IsIn(c);
          }
        }
      }
    }
    bool isFilled = false;
    for (const auto& [edge, isAround] : edges)
    {
      if (!isAround || this->IsIn(edge.first) || this->IsIn(edge.second))
      {
        continue;
      }
      const bool first = this->IsMovable(edge.first), second = this->IsMovable(edge.second);
      if (first || second)
      {
        this->Add(first ? edge.first : edge.second);
        isFilled = true;
      }
      else if (this->CanSplit({ edge.first, edge.second }))
      {
        this->Add(this->Solid.Split({ edge.first, edge.second }));
        isFilled = true;
      }
    }
    return isFilled;
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
    const std::vector<StarFace> faces = this->AllFacesAround(point);
    this->Work += static_cast<double>(faces.size());
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
        if (this->IsIn(face[k]) == this->IsIn(face[(k + 1) % 3]))
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
        ++(this->IsIn(p) ? inside : outside);
      }
    }
    return inside <= 1 && outside == 1;
  }

  /// Whether all points can leave the cluster one by one, wherever they are. It then is a ball.
  bool IsCollapsible(const Progress& progress)
  {
    const std::vector<int> kept = this->Entity;
    std::vector<int> left = this->Members;
    for (std::size_t before = left.size() + 1; left.size() < before && left.size() > 1;)
    {
      before = left.size();
      left.erase(std::remove_if(left.begin(), left.end(),
                   [&](int point)
                   {
                     progress(0.0);
                     const bool isGone = this->IsPeelable(point);
                     this->Entity[point] = isGone ? 0 : this->Id;
                     return isGone;
                   }),
        left.end());
    }
    this->Entity = kept;
    return left.size() <= 1;
  }

  /// Returns the point that can leave the cluster best, or -1. Points that most of their faces
  /// are outside for come first, so that the cluster stays round.
  int FindClearest(const Progress& progress)
  {
    const auto rank = [](const Placement& placement) {
      return std::make_tuple(
        placement.Clearance > Comfortable, placement.Rank, placement.Clearance);
    };
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
          this->Known[point].Rank = static_cast<double>(this->OuterFacesAround(point).size()) /
              static_cast<double>(this->Solid.CellsOf(point).size()) +
            Disorder * std::generate_canonical<double, 32>(this->Random);
        }
      }
      const Placement& known = this->Known[point];
      if (known.IsValid && (best < 0 || rank(known) > rank(this->Known[best])))
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

  /// Moves points of the cluster to a position, as another cluster or (entity 0) by themselves, and
  /// those around them to their centres.
  void Release(const std::vector<int>& part, const Eigen::RowVector3d& position, int entity)
  {
    for (const int point : part)
    {
      this->Solid.Points.row(point) = position;
      this->Entity[point] = entity;
      this->Forget(point);
    }
    this->Members.erase(std::remove_if(this->Members.begin(), this->Members.end(),
                          [&](int point) { return !this->IsIn(point); }),
      this->Members.end());
    for (const int point : part)
    {
      for (const int other : this->Neighbours(point))
      {
        this->Relax(other);
      }
      this->Relax(point);
    }
  }

  /// Moves a point that has left the cluster to the centre of its kernel. Returns whether it moved.
  bool Relax(int point)
  {
    if (this->Entity[point] != 0 || !this->IsMovable(point))
    {
      return false;
    }
    const std::vector<StarFace> faces = this->FacesAround(point);
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
      size = std::max(size, (this->Solid.Points.row(face[0]) - origin).norm());
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
      const Placement found = this->FindPlacement(this->OuterFaces(), this->Position());
      if (found.IsValid && found.Position != this->Position())
      {
        this->MoveTo(found.Position);
      }
    }
  }

  /// Returns the connected parts of some points of the cluster, the largest first.
  std::vector<std::vector<int>> PartsOf(const std::set<int>& points) const
  {
    std::vector<std::vector<int>> parts;
    std::set<int> left = points;
    while (!left.empty())
    {
      std::vector<int> part = { *left.begin() };
      left.erase(left.begin());
      for (std::size_t i = 0; i < part.size(); ++i)
      {
        for (const int other : this->Neighbours(part[i]))
        {
          if (left.erase(other) > 0)
          {
            part.push_back(other);
          }
        }
      }
      parts.push_back(std::move(part));
    }
    std::stable_sort(
      parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return parts;
  }

  /// Where a part of the cluster can move, and the faces that it sees there.
  Placement FindPartPlacement(const std::vector<int>& part, std::vector<StarFace>& faces)
  {
    constexpr int temporary = -1;
    for (const int point : part)
    {
      this->Entity[point] = temporary;
    }
    for (const int point : part)
    {
      for (const StarFace& face : this->FacesAround(point))
      {
        if (this->Entity[face[0]] != temporary && this->Entity[face[1]] != temporary &&
          this->Entity[face[2]] != temporary)
        {
          faces.push_back(face);
        }
      }
    }
    for (const int point : part)
    {
      this->Entity[point] = this->Id;
    }
    return this->FindPlacement(faces, this->Position());
  }

  /// Finds a part of the cluster that can move as one. It grows from each point by points beyond
  /// the faces that it does not see.
  Placement FindDivision(std::vector<int>& part, const Progress& progress)
  {
    Placement best;
    for (const int first : this->Members)
    {
      progress(0.0);
      if (this->OuterFacesAround(first).empty())
      {
        continue;
      }
      std::vector<int> grown = { first };
      while (2 * grown.size() <= this->Members.size())
      {
        std::vector<StarFace> faces;
        const Placement placement = this->FindPartPlacement(grown, faces);
        if (placement.IsValid)
        {
          if (placement.Clearance > best.Clearance && this->IsDivision(grown))
          {
            best = placement;
            part = grown;
          }
          break;
        }
        const int next = this->FindHinderer(faces, placement.Position);
        if (next < 0)
        {
          break;
        }
        grown.push_back(next);
      }
      if (best.Clearance > Comfortable)
      {
        break;
      }
    }
    return best;
  }

  /// Returns the point of the cluster with the most faces that a position does not see, or -1.
  int FindHinderer(const std::vector<StarFace>& faces, const Eigen::RowVector3d& position) const
  {
    std::map<int, int> counts;
    for (const StarFace& face : faces)
    {
      if (EvaluateOrientation(this->Solid.Points.row(face[0]), this->Solid.Points.row(face[1]),
            this->Solid.Points.row(face[2]), position) <= 0)
      {
        for (const int point : face)
        {
          counts[point] += this->IsIn(point);
        }
      }
    }
    int best = -1, most = 0;
    for (const auto& [point, count] : counts)
    {
      if (count > most)
      {
        best = point;
        most = count;
      }
    }
    return best;
  }

  /// Whether a part of the cluster and the rest of it are connected, without holes.
  bool IsDivision(const std::vector<int>& part) const
  {
    std::set<int> rest(this->Members.begin(), this->Members.end());
    for (const int point : part)
    {
      rest.erase(point);
    }
    const std::set<int> chosen(part.begin(), part.end());
    return !rest.empty() && this->PartsOf(chosen).size() == 1 && this->PartsOf(rest).size() == 1 &&
      this->IsContractible(part) && this->IsContractible({ rest.begin(), rest.end() });
  }

  /// A point of the cluster and the face from whose centre the fewest points are hidden.
  struct Cut
  {
    int Generation = 0; ///< of the point
    std::size_t Hidden = 0;
    int Point = -1;
    std::size_t Seed = 0;
    bool operator<(const Cut& other) const
    {
      // Given points first: if new points were split again and again, there would be no end.
      return std::tie(this->Generation, this->Hidden, this->Point) <
        std::tie(other.Generation, other.Hidden, other.Point);
    }
  };

  std::vector<Cut> FindCuts(bool onlyPeelable, const Progress& progress) const
  {
    std::vector<Cut> cuts;
    for (const int point : this->Members)
    {
      progress(0.0);
      if (onlyPeelable && !this->IsPeelable(point))
      {
        continue;
      }
      const std::vector<StarFace> faces = this->OuterFacesAround(point);
      Cut best;
      for (std::size_t seed = 0; seed < faces.size(); ++seed)
      {
        const std::size_t hidden = this->HiddenFrom(point, faces, seed, true).size();
        if (best.Point < 0 || hidden < best.Hidden)
        {
          best = { this->Generations[point], hidden, point, seed };
        }
      }
      if (best.Point >= 0)
      {
        cuts.push_back(best);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
  }

  /// Splits the edges from a point of the cluster to the points that are hidden from it, and pulls
  /// the new points to where they are not. Then the point leaves the cluster. Returns false if that
  /// succeeds for no point.
  bool ReleaseAfterSplits(const Progress& progress)
  {
    constexpr std::size_t maximumTrials = 8;
    constexpr int rounds = 3, sweeps = 5;
    std::vector<Cut> cuts = this->FindCuts(true, progress);
    cuts.resize(std::min(cuts.size(), maximumTrials));
    for (const Cut& cut : cuts)
    {
      const int point = cut.Point;
      const StarFace seed = this->OuterFacesAround(point)[cut.Seed];
      const Eigen::RowVector3d to =
        (this->Solid.Points.row(seed[0]) + this->Solid.Points.row(seed[1]) +
          this->Solid.Points.row(seed[2])) /
          3.0 -
        this->Position();
      std::vector<int> pulled;
      for (int round = 0; round < rounds; ++round)
      {
        progress(0.0);
        const std::vector<StarFace> faces = this->OuterFacesAround(point);
        std::size_t best = 0, fewest = faces.size() + 1000;
        for (std::size_t i = 0; i < faces.size(); ++i)
        {
          const std::size_t hidden = this->HiddenFrom(point, faces, i, true).size();
          if (hidden < fewest)
          {
            fewest = hidden;
            best = i;
          }
        }
        if (faces.empty())
        {
          break;
        }
        for (const int end : this->HiddenFrom(point, faces, best, true))
        {
          if (!this->CanSplit({ point, end }))
          {
            continue;
          }
          const int middle = this->SplitSpoke(point, end);
          const Placement placement = this->FindPlacement(middle);
          if (placement.IsValid)
          {
            this->Members.pop_back();
            this->Entity[middle] = 0;
            this->Solid.Points.row(middle) = placement.Position;
            pulled.push_back(middle);
          }
        }
        // As if the point had left towards the face.
        this->Entity[point] = 0;
        this->Solid.Points.row(point) = this->Position() + 0.1 * to;
        for (int sweep = 0; sweep < sweeps; ++sweep)
        {
          for (const int middle : pulled)
          {
            const Placement placement = this->FindPlacement(middle);
            if (placement.IsValid)
            {
              this->Solid.Points.row(middle) = placement.Position;
            }
          }
        }
        this->Entity[point] = this->Id;
        this->Solid.Points.row(point) = this->Position();
        this->Forget(point);
        for (const int middle : pulled)
        {
          this->Forget(middle);
        }
        this->Known[point] = this->FindPlacement(point);
        if (this->Known[point].IsValid)
        {
          this->Release({ point }, this->Known[point].Position, 0);
          return true;
        }
      }
    }
    return false;
  }

  /// Releases a point into the part of its star that is star-shaped. New points of the cluster, in
  /// the edges to the points that are hidden, take its other part.
  bool ReleasePart(const Progress& progress)
  {
    for (const Cut& cut : this->FindCuts(false, progress))
    {
      const int point = cut.Point;
      const std::vector<StarFace> faces = this->OuterFacesAround(point);
      for (const bool isGrown : { true, false })
      {
        const std::vector<int> hidden = this->HiddenFrom(point, faces, cut.Seed, isGrown);
        if (!std::all_of(hidden.begin(), hidden.end(),
              [&](int end) {
                return this->CanSplit({ point, end });
              }))
        {
          continue;
        }
        // As if these points were in the cluster.
        const std::vector<int> entities = this->Entity;
        for (const int end : hidden)
        {
          this->Entity[end] = this->Id;
        }
        const Placement placement = this->FindPlacement(point);
        this->Entity = entities;
        if (!placement.IsValid)
        {
          continue;
        }
        for (const int end : hidden)
        {
          this->SplitSpoke(point, end);
        }
        this->Known[point] = this->FindPlacement(point);
        if (this->Known[point].IsValid)
        {
          this->Release({ point }, this->Known[point].Position, 0);
          return true;
        }
      }
    }
    return false;
  }

  /// Returns the points around `point` outside the cluster that are not in the part of `faces`
  /// which is star-shaped as seen from the centre of face `seed`; or in that face alone, unless
  /// isGrown.
  std::vector<int> HiddenFrom(
    int point, const std::vector<StarFace>& faces, std::size_t seed, bool isGrown) const
  {
    const auto direction = [&](int p) -> Eigen::Vector3d
    { return (this->Solid.Points.row(p) - this->Position()).normalized().transpose(); };
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
          isSeen = isSeen && (isShared || sign * view.dot(direction(a).cross(direction(b))) > 0.0);
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
      if (!this->IsIn(other) && !seen.count(other))
      {
        hidden.push_back(other);
      }
    }
    return hidden;
  }

  /// Inserts a point of the cluster into an edge from one of its points.
  int SplitSpoke(int point, int end)
  {
    const int middle = this->Solid.Split({ point, end });
    this->Add(middle);
    this->Generations[middle] = this->Generations[point] + 1;
    this->Solid.Points.row(middle) = this->Position();
    this->Forget(middle);
    return middle;
  }

  SolidCells& Solid;
  bool MaySplit;
  double& Work; ///< number of half-spaces in all linear programmes so far
  std::mt19937 Random;
  std::vector<int> Entity; ///< for each point: the cluster that contains it, or 0
  int Id = 1;              ///< the present cluster
  std::vector<int> Members;
  std::vector<Placement> Known; ///< for each member: where it can move
  std::vector<char> IsKnown;
  std::vector<int> Generations; ///< for each point: how many splits in a row made it
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
  SolidCells& solid, const ConeExpansionOptions& options, const Progress& report)
{
  ConeExpansionResult result;
  double done = 0.0;
  const Progress progress(
    [&](double fraction)
    {
      // Attempts begin anew, but the reports do not fall.
      done = std::max(done, fraction);
      report(done);
      return true;
    });
  CellSplits splits(solid, [&](int point) { return !solid.OnBoundary(point); });
  std::vector<int> inverted;
  for (int cell = 0; cell < solid.CellCount(); ++cell)
  {
    if (solid.Inverted(cell))
    {
      inverted.push_back(cell);
    }
  }
  if (options.SplitCells)
  {
    splits.Impossible(inverted);
  }
  double work = 0.0;
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
    for (int attempt = 0; attempt < options.MaximumAttempts && work < options.MaximumWork;
         ++attempt)
    {
      Cluster cluster(solid, enlarged, attempt, options.SplitCells, work);
      if (attempt % 4 == 3)
      {
        cluster.AddRing();
      }
      if (!cluster.Place(progress))
      {
        solid = kept;
        break;
      }
      enlarged = cluster.Points();
      enlarged.erase(std::remove_if(enlarged.begin(), enlarged.end(),
                       [&](int point) { return point >= kept.PointCount(); }),
        enlarged.end());
      ConeExpansionResult expanded = result;
      if (cluster.Expand(options, expanded, progress))
      {
        result = expanded;
        break;
      }
      solid = kept;
    }
  }
  return result;
}

} // namespace shape
