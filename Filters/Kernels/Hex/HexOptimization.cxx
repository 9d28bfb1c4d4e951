#include "Hex/HexOptimization.h"

#include "Core/Errors.h"
#include "Core/Parallel.h"
#include "Hex/HexUntangling.h"
#include "Hex/StarEnergy.h"
#include "Quality/ScaledJacobian.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

namespace shape
{
namespace
{

constexpr double Sharpnesses[] = { 2, 4, 6, 8, 10, 12, 16, 20 };
constexpr double WorstSharpnesses[] = { 25, 30, 40, 60, 90 };

class Optimizer
{
public:
  Optimizer(const HexMesh& mesh, const PointConstraint& constraint)
    : Hexahedra(mesh.Hexahedra)
    , Points(mesh.Points.transpose())
    , Constraint(constraint)
    , Around(mesh.Points.rows())
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

  /// Lowers the energy around all points, or those that are marked.
  void Sweep(double sharpness, const std::vector<char>& marked = {})
  {
    this->ForAll(marked, [&](int point) { this->Move(point, sharpness); });
  }

  /// Moves all points, or those that are marked, half way to the middle of their neighbours.
  void Smooth(const std::vector<char>& marked = {})
  {
    this->ForAll(marked, [&](int point) { this->MoveTowardsMean(point); });
  }

  /// Puts every point where it may be.
  void Project()
  {
    this->ForAll({},
      [&](int point)
      {
        if (this->Constraint.Freedom(point) < 3)
        {
          this->Points.col(point) =
            this->Constraint.Nearest(point, this->Points.col(point).transpose()).transpose();
        }
      });
  }

  Eigen::MatrixXd Places() const { return this->Points.transpose(); }

private:
  /// Points without a common hexahedron, greedily.
  void FindIndependentSets()
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
      const auto set = std::find(taken.begin(), taken.end(), 0) - taken.begin();
      if (set == static_cast<std::ptrdiff_t>(this->IndependentSets.size()))
      {
        this->IndependentSets.emplace_back();
      }
      setOf[point] = static_cast<int>(set);
      if (!this->Around[point].empty() && this->Constraint.Freedom(static_cast<int>(point)) > 0)
      {
        this->IndependentSets[set].push_back(static_cast<int>(point));
      }
    }
  }

  template <typename Body>
  void ForAll(const std::vector<char>& marked, const Body& body)
  {
    for (const std::vector<int>& set : this->IndependentSets)
    {
      std::vector<int> points;
      std::copy_if(set.begin(), set.end(), std::back_inserter(points),
        [&](int point) { return marked.empty() || marked[point]; });
      ParallelFor(static_cast<int>(points.size()), 64,
        [&](int begin, int end)
        { std::for_each(&points[begin], &points[begin] + end - begin, body); });
    }
  }

  /// Of those neighbours that are as little free as it is: a point of a surface stays amidst those
  /// of the surface.
  void MoveTowardsMean(int point)
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
    }
  }

  /// A Newton step along the directions that the constraint allows; where these lead nowhere, as at
  /// a ridge of the surface, one in any direction and back to where the point may be.
  void Move(int point, double sharpness)
  {
    const Eigen::Vector3d x = this->Points.col(point);
    const StarEnergy star(this->Points, this->Hexahedra, this->Around[point]);
    const StarEnergy::Expansion here = star.Expand(x, sharpness);
    const bool free = this->Constraint.Freedom(point) == 3;
    const PointDirections all = Eigen::Matrix3d::Identity();
    const PointDirections allowed = free ? all : this->Constraint.Directions(point, x.transpose());
    if (!this->Step(point, star, here, allowed, sharpness) && !free)
    {
      this->Step(point, star, here, all, sharpness);
    }
  }

  /// Whether a step along some directions lowers the energy; if so, it is taken.
  bool Step(int point, const StarEnergy& star, const StarEnergy::Expansion& here,
    const PointDirections& directions, double sharpness)
  {
    const Eigen::Vector3d x = this->Points.col(point);
    Eigen::MatrixXd curvature = directions.transpose() * here.Curvature * directions;
    constexpr double ridge = 1e-6;
    curvature.diagonal().array() += ridge * curvature.trace();
    Eigen::Vector3d step =
      -directions * curvature.ldlt().solve(directions.transpose() * here.Gradient);
    if (!step.allFinite())
    {
      return false;
    }
    // The expansion says nothing about places beyond the neighbours.
    const double longest = 0.5 * star.Reach(x), length = step.norm();
    step *= length > longest ? longest / length : 1.0;
    for (double share = 1.0; share > 0.02; share *= 0.4)
    {
      Eigen::Vector3d place = x + share * step;
      if (this->Constraint.Freedom(point) < 3)
      {
        place = this->Constraint.Nearest(point, place.transpose()).transpose();
      }
      if (star.Value(place, sharpness) < here.Value)
      {
        this->Points.col(point) = place;
        return true;
      }
    }
    return false;
  }

  const Eigen::MatrixXi& Hexahedra;
  Eigen::Matrix3Xd Points;
  const PointConstraint& Constraint;
  std::vector<std::vector<std::array<int, 2>>> Around;
  std::vector<std::vector<int>> IndependentSets;
};

/// Keeps the points of the best of several states: the fewest inverted, then the best worst one.
class Best
{
public:
  explicit Best(HexMesh& mesh)
    : Mesh(mesh)
    , Values(ScaledJacobians(mesh))
  {
  }

  void Offer(Eigen::MatrixXd places)
  {
    places.swap(this->Mesh.Points);
    Eigen::VectorXd values = ScaledJacobians(this->Mesh);
    const int inverted = Inverted(values), before = Inverted(this->Values);
    if (inverted < before || (inverted == before && values.minCoeff() >= this->Values.minCoeff()))
    {
      this->Values.swap(values);
    }
    else
    {
      places.swap(this->Mesh.Points);
    }
  }

  static int Inverted(const Eigen::VectorXd& values)
  {
    return static_cast<int>((values.array() <= 0.0).count());
  }

  const Eigen::VectorXd& ScaledJacobiansOfBest() const { return this->Values; }

private:
  HexMesh& Mesh;
  Eigen::VectorXd Values;
};

/// Marks the points of hexahedra of a lower scaled Jacobian, none where there is none.
std::vector<char> PointsOfBad(const HexMesh& mesh, double bad)
{
  const Eigen::VectorXd values = ScaledJacobians(mesh);
  std::vector<char> marked;
  for (Eigen::Index hex = 0; hex < values.size(); ++hex)
  {
    if (values(hex) < bad)
    {
      marked.resize(mesh.Points.rows(), 0);
      const auto points = mesh.Hexahedra.row(hex);
      std::for_each(points.begin(), points.end(), [&](int point) { marked[point] = 1; });
    }
  }
  return marked;
}

/// One run over all sharpnesses; the best state on the way is offered.
void Run(const HexMesh& mesh, const PointConstraint& constraint,
  const HexOptimizationOptions& options, Best& best, const Progress& progress)
{
  Optimizer optimizer(mesh, constraint);
  const double steps = static_cast<double>(std::size(Sharpnesses)) * options.Sweeps;
  double done = 0.0;
  for (const double sharpness : Sharpnesses)
  {
    for (int sweep = 0; sweep < options.Sweeps; ++sweep)
    {
      optimizer.Sweep(sharpness);
      progress(0.8 * ++done / steps);
    }
    best.Offer(optimizer.Places());
  }
  done = 0.0;
  for (const double sharpness : WorstSharpnesses)
  {
    HexMesh now{ optimizer.Places(), mesh.Hexahedra };
    for (int sweep = 0; sweep < options.WorstSweeps; ++sweep)
    {
      const std::vector<char> marked = PointsOfBad(now, options.Bad);
      if (marked.empty())
      {
        break;
      }
      optimizer.Sweep(sharpness, marked);
      now.Points = optimizer.Places();
      progress(0.8 + 0.2 * ++done / (std::size(WorstSharpnesses) * options.WorstSweeps));
    }
    best.Offer(std::move(now.Points));
  }
}

void RequireIndices(const HexMesh& mesh)
{
  if (mesh.Hexahedra.size() > 0 &&
    (mesh.Hexahedra.minCoeff() < 0 || mesh.Hexahedra.maxCoeff() >= mesh.Points.rows()))
  {
    throw InvalidInput("a hexahedron has a point that is not there");
  }
}

} // namespace

void SmoothHexahedra(HexMesh& mesh, const PointConstraint& constraint, int sweeps)
{
  RequireIndices(mesh);
  Optimizer optimizer(mesh, constraint);
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    optimizer.Smooth();
  }
  optimizer.Project();
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round)
  {
    mesh.Points = optimizer.Places();
    std::vector<char> marked = PointsOfBad(mesh, 0.0);
    if (marked.empty())
    {
      break;
    }
    GrowRings(mesh.Hexahedra, round, marked);
    optimizer.Smooth(marked);
  }
  mesh.Points = optimizer.Places();
}

HexOptimizationResult OptimizeHexahedra(HexMesh& mesh, const PointConstraint& constraint,
  const HexOptimizationOptions& options, const Progress& progress)
{
  if (options.Sweeps < 0 || options.WorstSweeps < 0)
  {
    throw InvalidInput("Sweeps and WorstSweeps must not be negative");
  }
  RequireIndices(mesh);
  if (mesh.Hexahedra.size() == 0)
  {
    return {};
  }
  Best best(mesh);
  HexOptimizationResult result;
  result.LeastBefore = best.ScaledJacobiansOfBest().minCoeff();
  result.InvertedBefore = Best::Inverted(best.ScaledJacobiansOfBest());
  Run(mesh, constraint, options, best, progress.Part(0.0, 0.5));
  if (Best::Inverted(best.ScaledJacobiansOfBest()) > 0)
  {
    HexMesh untangled = mesh;
    UntangleHexahedra(untangled, constraint, progress.Part(0.5, 0.6));
    best.Offer(untangled.Points);
    Run(untangled, constraint, options, best, progress.Part(0.6, 1.0));
  }
  result.LeastAfter = best.ScaledJacobiansOfBest().minCoeff();
  result.InvertedAfter = Best::Inverted(best.ScaledJacobiansOfBest());
  progress(1.0);
  return result;
}

} // namespace shape
