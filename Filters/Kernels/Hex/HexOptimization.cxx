#include "Hex/HexOptimization.h"

#include "Core/Errors.h"
#include "Hex/HexSweeps.h"
#include "Hex/HexUntangling.h"
#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <iterator>
#include <vector>

namespace shape
{
namespace
{

constexpr double Sharpnesses[] = { 2, 4, 6, 8, 10, 12, 16, 20 };
constexpr double WorstSharpnesses[] = { 25, 30, 40, 60, 90 };

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
  HexSweeps sweeps(mesh, constraint);
  const double steps = static_cast<double>(std::size(Sharpnesses)) * options.Sweeps;
  double done = 0.0;
  for (const double sharpness : Sharpnesses)
  {
    for (int sweep = 0; sweep < options.Sweeps; ++sweep)
    {
      sweeps.Lower(sharpness, {}, progress.Part(0.8 * done / steps, 0.8 * (done + 1.0) / steps));
      ++done;
    }
    best.Offer(sweeps.Places());
  }
  done = 0.0;
  for (const double sharpness : WorstSharpnesses)
  {
    std::vector<char> marked;
    for (int sweep = 0; sweep < options.WorstSweeps; ++sweep)
    {
      constexpr int between = 5; // which are bad changes little by one sweep
      if (sweep % between == 0)
      {
        marked = PointsOfBad({ sweeps.Places(), mesh.Hexahedra }, options.Bad);
      }
      if (marked.empty())
      {
        break;
      }
      const double share = 0.2 / (std::size(WorstSharpnesses) * options.WorstSweeps);
      sweeps.Lower(
        sharpness, marked, progress.Part(0.8 + done * share, 0.8 + (done + 1.0) * share));
      ++done;
    }
    best.Offer(sweeps.Places());
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

void SmoothHexahedra(
  HexMesh& mesh, const PointConstraint& constraint, int sweeps, const Progress& progress)
{
  RequireIndices(mesh);
  HexSweeps mover(mesh, constraint);
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    mover.Smooth({}, progress.Part(static_cast<double>(sweep) / sweeps, (sweep + 1.0) / sweeps));
  }
  mover.Project();
  mesh.Points = mover.Places();
}

void SmoothInverted(HexMesh& mesh, const PointConstraint& constraint, const Progress& progress)
{
  RequireIndices(mesh);
  HexSweeps mover(mesh, constraint);
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<char> marked = PointsOfBad(mesh, 0.0);
    if (marked.empty())
    {
      break;
    }
    GrowRings(mesh.Hexahedra, round, marked);
    mover.Smooth(
      marked, progress.Part(static_cast<double>(round) / rounds, (round + 1.0) / rounds));
    mesh.Points = mover.Places();
  }
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
