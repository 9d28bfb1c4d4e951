#include "Hex/Optimize/Private/HexSweeps.h"

#include "Base/Parallel.h"
#include "Quality/ScaledJacobian.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include <algorithm>
#include <iterator>

namespace shape
{
namespace
{

/// Relative to a point's reach: shorter steps are not made, and smaller moves are ignored.
constexpr double Negligible = 1e-4;

/// Moves a point along some directions if that lowers the energy; returns whether it moved.
bool Step(Eigen::Ref<Eigen::Vector3d> point, const StarEnergy& star, double sharpness,
  const StarEnergy::Expansion& here, const PointDirections& directions,
  const PointConstraint& constraint, int id)
{
  const Eigen::Vector3d x = point;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> curvature =
    directions.transpose() * here.Curvature * directions;
  // Relative to the trace: keeps the matrix positive definite where a direction has no curvature.
  constexpr double ridge = 1e-6;
  curvature.diagonal().array() += ridge * curvature.trace();
  Eigen::Vector3d step =
    -directions * curvature.ldlt().solve(directions.transpose() * here.Gradient);
  if (!step.allFinite())
  {
    return false;
  }
  // The expansion is not valid for positions beyond the neighbours.
  const double longest = 0.5 * here.Reach, length = step.norm();
  if (length < Negligible * longest)
  {
    return false;
  }
  step *= length > longest ? longest / length : 1.0;
  // The line search takes the first step that lowers the energy after the projection.
  for (double share = 1.0; share > 0.02; share *= 0.4)
  {
    Eigen::Vector3d position = x + share * step;
    if (constraint.Freedom(id) < 3)
    {
      position = constraint.Nearest(id, position.transpose()).transpose();
    }
    if (star.Value(position, sharpness) < here.Value)
    {
      point = position;
      return true;
    }
  }
  return false;
}

} // namespace

HexSweeps::HexSweeps(const HexMesh& mesh, const PointConstraint& constraint)
  : Hexahedra(mesh.Hexahedra)
  , MinimumSquares(StarEnergy::MinimumSquares(mesh))
  , Points(mesh.Points.transpose())
  , Constraint(constraint)
  , Around(mesh.Points.rows())
  , MovedAt(mesh.Points.rows(), 0)
  , LookedAt(mesh.Points.rows(), 0)
  , ChangedAt(mesh.Points.rows(), 0)
{
  for (int hex = 0; hex < this->Hexahedra.rows(); ++hex)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      this->Around[this->Hexahedra(hex, corner)].push_back({ hex, corner });
    }
  }
  this->FindIndependentSets();
}

void HexSweeps::Lower(double sharpness, const std::vector<char>& marked, const Progress& progress)
{
  if (sharpness != this->Sharpness)
  {
    // Another sharpness is another energy, in which no point is at rest.
    std::fill(this->LookedAt.begin(), this->LookedAt.end(), 0);
    this->Sharpness = sharpness;
  }
  this->ForAll(marked, progress,
    [&](int point)
    {
      if (!this->IsAtRest(point))
      {
        this->LookedAt[point] = this->Now;
        this->Move(point, sharpness);
      }
    });
}

void HexSweeps::Smooth(const std::vector<char>& marked, const Progress& progress)
{
  this->ForAll(marked, progress, [&](int point) { this->MoveTowardsMean(point); });
}

void HexSweeps::Project()
{
  this->ForAll({}, {},
    [&](int point)
    {
      if (this->Constraint.Freedom(point) < 3)
      {
        this->Points.col(point) =
          this->Constraint.Nearest(point, this->Points.col(point).transpose()).transpose();
        this->ChangedAt[point] = this->Now;
      }
    });
}

std::vector<char> HexSweeps::MarkBad(double bad)
{
  const bool isFirst = this->ScaledJacobians.size() == 0;
  this->ScaledJacobians.conservativeResize(this->Hexahedra.rows());
  ParallelFor(static_cast<int>(this->Hexahedra.rows()), 4096,
    [&](int begin, int end)
    {
      for (int hex = begin; hex < end; ++hex)
      {
        const auto points = this->Hexahedra.row(hex);
        if (isFirst ||
          std::any_of(points.begin(), points.end(),
            [&](int point) { return this->ChangedAt[point] > this->EvaluatedAt; }))
        {
          Eigen::Matrix<double, 8, 3> corners;
          for (int k = 0; k < 8; ++k)
          {
            corners.row(k) = this->Points.col(points(k)).transpose();
          }
          this->ScaledJacobians(hex) = ComputeScaledJacobian(corners);
        }
      }
    });
  this->EvaluatedAt = this->Now;
  return MarkPointsOfBadHexahedra(this->Hexahedra, this->ScaledJacobians, this->Points.cols(), bad);
}

/// Finds sets of points that share no hexahedron, greedily.
void HexSweeps::FindIndependentSets()
{
  std::vector<int> setOf(this->Around.size(), -1);
  for (std::size_t point = 0; point < this->Around.size(); ++point)
  {
    std::vector<char> taken(this->IndependentSets.size() + 1, 0);
    for (const auto& incidence : this->Around[point])
    {
      for (const int other : this->Hexahedra.row(incidence[0]))
      {
        if (setOf[other] >= 0)
        {
          taken[setOf[other]] = 1;
        }
      }
    }
    // The first set without a point of the same hexahedra.
    const auto set = std::find(taken.begin(), taken.end(), 0) - taken.begin();
    if (set == static_cast<std::ptrdiff_t>(this->IndependentSets.size()))
    {
      this->IndependentSets.emplace_back();
    }
    // Fixed points get a set, too, but are not listed: nothing moves them.
    setOf[point] = static_cast<int>(set);
    if (!this->Around[point].empty() && this->Constraint.Freedom(static_cast<int>(point)) > 0)
    {
      this->IndependentSets[set].push_back(static_cast<int>(point));
    }
  }
}

template <typename Body>
void HexSweeps::ForAll(const std::vector<char>& marked, const Progress& progress, const Body& body)
{
  const auto count = static_cast<double>(this->IndependentSets.size());
  double done = 0.0;
  for (const std::vector<int>& set : this->IndependentSets)
  {
    ++this->Now;
    std::vector<int> points;
    std::copy_if(set.begin(), set.end(), std::back_inserter(points),
      [&](int point) { return marked.empty() || marked[point]; });
    ParallelFor(
      static_cast<int>(points.size()), 256,
      [&](int begin, int end)
      { std::for_each(&points[begin], &points[begin] + end - begin, body); },
      progress.Part(done / count, (done + 1.0) / count));
    ++done;
  }
}

/// A step from the same star would fail again. Many points do not move in late sweeps.
bool HexSweeps::IsAtRest(int point) const
{
  const int looked = this->LookedAt[point];
  return looked > 0 &&
    std::all_of(this->Around[point].begin(), this->Around[point].end(),
      [&](const auto& incidence)
      {
        const auto corners = this->Hexahedra.row(incidence[0]);
        return std::all_of(
          corners.begin(), corners.end(), [&](int other) { return this->MovedAt[other] < looked; });
      });
}

void HexSweeps::MoveTowardsMean(int point)
{
  const int freedom = this->Constraint.Freedom(point);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int count = 0;
  for (const auto& [hex, corner] : this->Around[point])
  {
    for (const int end : HexNeighbours[corner])
    {
      const int neighbour = this->Hexahedra(hex, end);
      if (this->Constraint.Freedom(neighbour) <= freedom)
      {
        sum += this->Points.col(neighbour);
        ++count;
      }
    }
  }
  if (count > 0)
  {
    const Eigen::Vector3d mean = 0.5 * (this->Points.col(point) + sum / count);
    this->Points.col(point) =
      freedom == 3 ? mean : this->Constraint.Nearest(point, mean.transpose()).transpose();
    this->ChangedAt[point] = this->Now;
  }
}

/// Takes a Newton step along the directions that the constraint allows. If that fails, as at a
/// ridge of the surface, takes one in any direction and projects the point back.
void HexSweeps::Move(int point, double sharpness)
{
  const Eigen::Vector3d x = this->Points.col(point);
  const StarEnergy star(this->Points, this->Hexahedra, this->MinimumSquares, this->Around[point]);
  const StarEnergy::Expansion here = star.Expand(x, sharpness);
  const bool free = this->Constraint.Freedom(point) == 3;
  const PointDirections all = Eigen::Matrix3d::Identity();
  const PointDirections allowed = free ? all : this->Constraint.Directions(point, x.transpose());
  if (!Step(this->Points.col(point), star, sharpness, here, allowed, this->Constraint, point) &&
    !free)
  {
    Step(this->Points.col(point), star, sharpness, here, all, this->Constraint, point);
  }
  if (this->Points.col(point) != x)
  {
    this->ChangedAt[point] = this->Now;
  }
  if ((this->Points.col(point) - x).norm() > Negligible * here.Reach)
  {
    this->MovedAt[point] = this->Now;
  }
}

} // namespace shape
