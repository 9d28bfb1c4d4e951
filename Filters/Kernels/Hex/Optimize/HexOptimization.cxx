#include "Hex/Optimize/HexOptimization.h"

#include "Base/Errors.h"
#include "Hex/Optimize/Private/HexSweeps.h"
#include "Hex/Optimize/Private/HexUntangling.h"
#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The continuation from l_p to l_infinity (Livesu et al. 2015): each sharpness starts from the
/// positions of the last. Gentle ones precede untangling, the last ones raise the worst only.
const std::vector<double> GentleSharpnesses = { 2, 4, 6 };
const std::vector<double> Sharpnesses = { 2, 4, 6, 8, 10, 12, 16, 20 };
const std::vector<double> WorstSharpnesses = { 25, 30, 40, 60, 90 };

/// Keeps the points of the best state: the fewest inverted hexahedra, then the best minimum.
class Best
{
public:
  explicit Best(HexMesh& mesh)
    : Mesh(mesh)
    , Values(ComputeScaledJacobians(mesh))
  {
  }

  void Offer(Eigen::MatrixXd positions)
  {
    positions.swap(this->Mesh.Points);
    Eigen::VectorXd values = ComputeScaledJacobians(this->Mesh);
    // An inverted hexahedron outweighs any quality of the others.
    const int inverted = Count(values), before = this->Inverted();
    if (inverted < before || (inverted == before && values.minCoeff() >= this->Values.minCoeff()))
    {
      this->Values.swap(values);
    }
    else
    {
      positions.swap(this->Mesh.Points);
    }
  }

  int Inverted() const { return Count(this->Values); }
  double Minimum() const { return this->Values.minCoeff(); }

private:
  static int Count(const Eigen::VectorXd& values)
  {
    return static_cast<int>((values.array() <= 0.0).count());
  }

  HexMesh& Mesh;
  Eigen::VectorXd Values;
};

/// Sweeps over the movable points and offers the best state after each sharpness.
void LowerAll(const HexMesh& mesh, const PointConstraint& constraint,
  const std::vector<double>& sharpnesses, const HexOptimizationOptions& options, Best& best,
  const Progress& progress)
{
  const int count = options.Sweeps;
  HexSweeps sweeps(mesh, constraint);
  const double steps = static_cast<double>(sharpnesses.size()) * count;
  double done = 0.0;
  for (const double sharpness : sharpnesses)
  {
    for (int sweep = 0; sweep < count; ++sweep)
    {
      sweeps.Lower(sharpness, options.Marked, progress.Part(done / steps, (done + 1.0) / steps));
      ++done;
    }
    best.Offer(sweeps.Positions());
  }
}

/// Clears the marks that are not set in `others` as well; keeps all if `others` is empty.
void LeaveMarked(const std::vector<char>& others, std::vector<char>& marked)
{
  for (std::size_t point = 0; point < std::min(marked.size(), others.size()); ++point)
  {
    marked[point] = static_cast<char>(marked[point] && others[point]);
  }
}

/// Sweeps over the points of bad hexahedra.
void LowerWorst(const HexMesh& mesh, const PointConstraint& constraint,
  const HexOptimizationOptions& options, Best& best, const Progress& progress)
{
  HexSweeps sweeps(mesh, constraint);
  const double steps = static_cast<double>(WorstSharpnesses.size()) * options.WorstSweeps;
  double done = 0.0;
  for (const double sharpness : WorstSharpnesses)
  {
    std::vector<char> marked;
    for (int sweep = 0; sweep < options.WorstSweeps; ++sweep)
    {
      constexpr int between = 5; // one sweep hardly changes the set of bad hexahedra
      if (sweep % between == 0)
      {
        marked = sweeps.MarkBad(options.Bad);
        LeaveMarked(options.Marked, marked);
      }
      if (marked.empty())
      {
        break;
      }
      sweeps.Lower(sharpness, marked, progress.Part(done / steps, (done + 1.0) / steps));
      ++done;
    }
    best.Offer(sweeps.Positions());
  }
}

/// Sweeps over the points of bad hexahedra, with more sweeps near those that are still too bad.
void Raise(const HexMesh& mesh, const PointConstraint& constraint,
  const HexOptimizationOptions& options, Best& best, const Progress& progress)
{
  LowerWorst(mesh, constraint, options, best, progress.Part(0.0, 0.4));
  // Longer sweeps continue only while each attempt gains enough and few points are concerned.
  constexpr double minimumGain = 0.01, share = 0.2;
  constexpr double maximum = 0.1; // fraction of the points: for more it helps too little
  constexpr int attempts = 3, rings = 3;
  HexOptimizationOptions longer = options;
  // Sixty sweeps at each sharpness stop too early: with more the worst scaled Jacobian of a femur
  // rises from 0.16 to 0.28. Near the worst hexahedra only: over a whole mesh of narrow corners
  // they take minutes.
  longer.WorstSweeps *= 3;
  double before = options.RaiseAgainFrom - minimumGain;
  for (int attempt = 0; attempt < attempts && best.Minimum() < options.RaiseTo &&
       best.Minimum() >= before + minimumGain;
       ++attempt)
  {
    const double begin = 0.4 + share * attempt;
    before = best.Minimum();
    longer.Marked = MarkPointsOfBadHexahedra(mesh, options.RaiseTo);
    GrowRings(mesh.Hexahedra, rings, longer.Marked);
    LeaveMarked(options.Marked, longer.Marked);
    if (static_cast<double>(std::count(longer.Marked.begin(), longer.Marked.end(), 1)) >
      maximum * static_cast<double>(mesh.Points.rows()))
    {
      break;
    }
    LowerWorst(mesh, constraint, longer, best, progress.Part(begin, begin + share));
  }
}

/// A few sweeps of low sharpness repair most inverted hexahedra. The rest is untangled before
/// sweeps of higher sharpness, which repair few, are spent on it.
void Turn(HexMesh& mesh, const PointConstraint& constraint, const HexOptimizationOptions& options,
  Best& best, const Progress& progress)
{
  LowerAll(mesh, constraint, GentleSharpnesses, options, best, progress.Part(0.0, 0.3));
  if (best.Inverted() > 0)
  {
    HexMesh untangled = mesh;
    UntangleHexahedra(untangled, constraint, options.UntanglingSteps, progress.Part(0.3, 1.0));
    best.Offer(std::move(untangled.Points));
  }
}

void RequireIndices(const HexMesh& mesh)
{
  if (mesh.Hexahedra.size() > 0 &&
    (mesh.Hexahedra.minCoeff() < 0 || mesh.Hexahedra.maxCoeff() >= mesh.Points.rows()))
  {
    throw InvalidInput("a hexahedron uses a point that does not exist; repair the mesh");
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
  mesh.Points = mover.Positions();
}

void SmoothInverted(HexMesh& mesh, const PointConstraint& constraint, const Progress& progress)
{
  RequireIndices(mesh);
  HexSweeps mover(mesh, constraint);
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round)
  {
    std::vector<char> marked = MarkPointsOfBadHexahedra(mesh, 0.0);
    if (marked.empty())
    {
      break;
    }
    // One more ring in each round.
    GrowRings(mesh.Hexahedra, round, marked);
    mover.Smooth(
      marked, progress.Part(static_cast<double>(round) / rounds, (round + 1.0) / rounds));
    mesh.Points = mover.Positions();
  }
}

// 1. Turn: gentle sweeps and untangling, if some hexahedra are inverted.
// 2. LowerAll: sweeps of growing sharpness over all points.
// 3. Raise: sharper sweeps near the worst hexahedra.
// The best state (Best) is kept throughout.
HexOptimizationResult OptimizeHexahedra(HexMesh& mesh, const PointConstraint& constraint,
  const HexOptimizationOptions& options, const Progress& progress)
{
  if (options.Sweeps < 0 || options.WorstSweeps < 0 || options.UntanglingSteps < 0)
  {
    throw InvalidInput("Sweeps, WorstSweeps and UntanglingSteps must not be negative");
  }
  RequireIndices(mesh);
  if (mesh.Hexahedra.size() == 0)
  {
    return {};
  }
  Best best(mesh);
  HexOptimizationResult result;
  result.MinimumBefore = best.Minimum();
  result.InvertedBefore = best.Inverted();
  // Sweeps over all points repair some hexahedra that untangling alone does not.
  constexpr double worstFrom = 0.75; // of the progress
  constexpr int attempts = 2;
  constexpr double ends[] = { 0.0, 0.65, worstFrom }; // a second attempt is rare
  for (int attempt = 0; attempt < attempts && (attempt == 0 || best.Inverted() > 0); ++attempt)
  {
    // An attempt starts from the best state of the last one.
    const Progress part = progress.Part(ends[attempt], ends[attempt + 1]);
    const bool turns = best.Inverted() > 0 && (attempt > 0 || !options.SweepFirst);
    const double turned = turns ? 0.4 : 0.0;
    if (turns)
    {
      Turn(mesh, constraint, options, best, part.Part(0.0, turned, "untangling the hexahedra"));
    }
    LowerAll(mesh, constraint, Sharpnesses, options, best, part.Part(turned, 1.0));
  }
  if (best.Minimum() > options.RaiseFrom)
  {
    Raise(mesh, constraint, options, best,
      progress.Part(worstFrom, 1.0, "improving the worst hexahedra"));
  }
  result.MinimumAfter = best.Minimum();
  result.InvertedAfter = best.Inverted();
  progress(1.0);
  return result;
}

} // namespace shape
