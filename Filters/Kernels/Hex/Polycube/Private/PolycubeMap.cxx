#include "Hex/Polycube/Private/PolycubeMap.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Geometry/RotationVector.h"
#include "Hex/Polycube/Private/AxisAlignment.h"
#include "Hex/Polycube/Private/AxisLabels.h"
#include "Hex/Polycube/Private/IntegerCharts.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Solids/SolidVolume.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The trials: a factor of the compactness, and whether the axes are rotated to a generic
/// direction, which breaks ties of symmetric shapes.
struct Trial
{
  double Factor;
  bool Turned;
};
constexpr Trial Trials[] = { { 1.0, false }, { 0.5, false }, { 0.25, false }, { 1.0, true },
  { 0.4, true } };
const Eigen::Vector3d Turn(0.5, 0.3, 0.2); ///< axis times angle
/// Rounds of labelling and flattening, each of which improves the other's input.
constexpr int Flattenings = 3;
/// Relabellings with higher costs before the next trial.
constexpr int Repairs = 2;
/// A deformation is given up after this many Newton steps without fewer negative tetrahedra.
constexpr int FirstSteps = 8, Hopeless = 60;
/// No further trial starts after this many tetrahedra were deformed.
constexpr int MaximumWork = 150000;
/// The added cost of a label that did not work, for a triangle of the mean area.
constexpr double Dearer = 1.0, Forbidden = 50.0;
/// Charts with a greater fraction of the area are never given up.
constexpr double MaximumGivenUp = 0.03;
/// A chart is folded if more than this fraction of it is inverted.
constexpr double Folded = 0.1;
/// If the rounded charts leave no room, the cells become smaller by this factor.
constexpr int QuantisationAttempts = 4;
constexpr double QuantisationShrinkage = 0.75;

/// A trial: the solid with its labels, and the result of its deformation.
struct Attempt
{
  WorkingSolid Solid;
  Eigen::MatrixXd Positions;
  Eigen::VectorXi Labels;
  shape::Charts Charts;
  ConstrainedCoordinates Tied;
  std::vector<ChartFault> Faults;
  PatchResult Result;
  Eigen::Matrix3d Rotation; ///< rotation of the solid relative to the surface
};

double ComputeMeanEdgeLength(const WorkingSolid& solid)
{
  return std::sqrt(
    4.0 / std::sqrt(3.0) * 0.5 * ComputeAreaVectors(solid.Surface()).rowwise().norm().mean());
}

/// The options of each deformation. Tied coordinates have no fixed points, so the minimiser of
/// |J|^2 would collapse.
PatchOptions TiedOptions()
{
  PatchOptions options;
  options.MaximumSteps = 20;
  options.FirstEpsilon = 0.1;
  options.FromSmoothest = false;
  return options;
}

/// Makes tied coordinates equal: their mean.
void Tie(const ConstrainedCoordinates& tied, Eigen::MatrixXd& positions)
{
  Eigen::VectorXd sums = Eigen::VectorXd::Zero(tied.Count), counts = sums;
  for (Eigen::Index i = 0; i < tied.Unknowns.size(); ++i)
  {
    sums(tied.Unknowns(i)) += positions(i / 3, i % 3);
    counts(tied.Unknowns(i)) += 1.0;
  }
  for (Eigen::Index i = 0; i < tied.Unknowns.size(); ++i)
  {
    positions(i / 3, i % 3) = sums(tied.Unknowns(i)) / counts(tied.Unknowns(i));
  }
}

/// Returns the triangles of folded charts; a few inverted triangles of other charts are tolerated.
std::vector<char> FoldedOver(const Attempt& attempt)
{
  std::vector<char> turned =
    FindInvertedTriangles(attempt.Solid.Surface(attempt.Positions), attempt.Labels);
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(attempt.Charts.Count()), all = counts;
  for (Eigen::Index f = 0; f < attempt.Labels.size(); ++f)
  {
    counts(attempt.Charts.Of(f)) += turned[f];
    all(attempt.Charts.Of(f)) += 1.0;
  }
  for (Eigen::Index f = 0; f < attempt.Labels.size(); ++f)
  {
    const int chart = attempt.Charts.Of(f);
    turned[f] = turned[f] && counts(chart) > Folded * all(chart);
  }
  return turned;
}

/// The number of inverted triangles of folded charts.
int CountFolded(const Attempt& attempt)
{
  const std::vector<char> folded = FoldedOver(attempt);
  return static_cast<int>(std::count(folded.begin(), folded.end(), 1));
}

/// Deforms the solid with these labels:
/// 1. Each chart gets one coordinate along its axis.
/// 2. Surface edges that would become degenerate are split.
/// 3. Newton's method makes the tetrahedra positive.
Attempt Deform(const WorkingSolid& solid, const Eigen::VectorXi& labels,
  const Eigen::MatrixXd& start, const Progress& progress)
{
  Attempt attempt{ solid, start, labels, FindCharts(solid.Surface(), labels), {}, {}, {}, {} };
  attempt.Tied = ConstrainCharts(attempt.Charts, solid.Points.rows());
  // A border of triangles zigzags by up to half an edge: that is no reversal.
  attempt.Faults = FindChartFaults(attempt.Charts, start, 0.5 * ComputeMeanEdgeLength(solid));
  // A triangle with all its corners on one unknown of another axis could not have an area.
  SplitSurfaceEdges(attempt.Solid,
    FindConstrainedEdges(solid.Triangles, attempt.Charts, attempt.Tied), attempt.Positions,
    attempt.Labels);
  attempt.Charts = FindCharts(attempt.Solid.Surface(), attempt.Labels);
  attempt.Tied = ConstrainCharts(attempt.Charts, attempt.Solid.Points.rows());
  Tie(attempt.Tied, attempt.Positions);
  PatchOptions options = TiedOptions();
  // Most hopeless labels show within a few Newton steps; only promising ones get the full number.
  options.MaximumSteps = FirstSteps;
  attempt.Result =
    MinimizeConstrainedEnergy(attempt.Positions, attempt.Solid, attempt.Tied, options, progress);
  if (attempt.Result.Negative > 0 && attempt.Result.Negative < Hopeless)
  {
    attempt.Result = MinimizeConstrainedEnergy(
      attempt.Positions, attempt.Solid, attempt.Tied, TiedOptions(), progress);
  }
  return attempt;
}

bool IsPositive(const WorkingSolid& solid, const Eigen::MatrixXd& positions, Eigen::Index t)
{
  const auto c = solid.Tetrahedra.row(t);
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k)
  {
    edges.col(k) = (positions.row(c(k + 1)) - positions.row(c(0))).transpose();
  }
  return edges.determinant() > 0.0;
}

/// Raises the costs of labels that did not work: on charts with too few neighbours, around
/// tetrahedra that stayed negative, and on inverted triangles if charts must face their labels.
/// `before`: the labels of the triangles that the costs refer to.
void RaiseCosts(const WorkingSolid& solid, const Eigen::VectorXi& before, const Attempt& attempt,
  bool isFacing, Eigen::MatrixXd& costs)
{
  const Charts charts = FindCharts(solid.Surface(), before);
  const double area = charts.Areas.sum();
  std::vector<char> givenUp(charts.Count(), 0);
  for (const ChartFault& fault : attempt.Faults)
  {
    givenUp[fault.Chart] |= fault.What == ChartFault::Kind::FewNeighbours &&
      charts.Areas(fault.Chart) < MaximumGivenUp * area;
  }
  std::vector<char> near(attempt.Solid.SurfacePointCount, 0);
  if (isFacing)
  {
    const std::vector<char> folded = FoldedOver(attempt);
    for (Eigen::Index f = 0; f < attempt.Solid.Triangles.rows(); ++f)
    {
      for (const int v : attempt.Solid.Triangles.row(f))
      {
        near[v] |= folded[f];
      }
    }
  }
  for (Eigen::Index t = 0; t < attempt.Solid.Tetrahedra.rows(); ++t)
  {
    if (!IsPositive(attempt.Solid, attempt.Positions, t))
    {
      for (const int v : attempt.Solid.Tetrahedra.row(t))
      {
        if (v < attempt.Solid.SurfacePointCount)
        {
          near[v] = 1;
        }
      }
    }
  }
  for (Eigen::Index f = 0; f < solid.Triangles.rows(); ++f)
  {
    const auto c = solid.Triangles.row(f);
    // A small chart with too few neighbours is removed. Elsewhere the label only becomes less
    // likely.
    if (givenUp[charts.Of(f)])
    {
      costs(f, before(f)) += Forbidden;
    }
    else if (near[c(0)] || near[c(1)] || near[c(2)])
    {
      costs(f, before(f)) += Dearer;
    }
  }
}

/// Returns the best of several trials with one compactness. work: counts the deformed tetrahedra.
Attempt TryCompactness(const WorkingSolid& solid, const Eigen::MatrixXd& aligned,
  double compactness, bool isFacing, int& work, const Progress& progress)
{
  Eigen::MatrixXd costs = Eigen::MatrixXd::Zero(solid.Triangles.rows(), 6);
  Eigen::MatrixXd positions = aligned;
  Eigen::VectorXi labels = FindAxisLabels(solid, positions, compactness);
  for (int round = 0; round < Flattenings; ++round)
  {
    positions = FlattenAlongAxes(solid, labels, positions, progress);
    if (round + 1 < Flattenings)
    {
      labels = FindAxisLabels(solid, positions, compactness);
    }
  }
  Attempt best;
  best.Result.Negative = std::numeric_limits<int>::max();
  for (int repair = 0; repair <= Repairs; ++repair)
  {
    Attempt attempt = Deform(solid, labels, positions, progress);
    work += static_cast<int>(attempt.Solid.Tetrahedra.rows());
    RaiseCosts(solid, labels, attempt, isFacing, costs);
    attempt.Result.Negative += isFacing ? CountFolded(attempt) : 0;
    if (attempt.Result.Negative < best.Result.Negative)
    {
      best = std::move(attempt);
    }
    if (best.Result.Negative == 0 || repair == Repairs)
    {
      break;
    }
    const Eigen::VectorXi next = FindAxisLabels(solid, positions, compactness, costs);
    labels = next;
    positions = FlattenAlongAxes(solid, labels, positions, progress);
  }
  return best;
}

/// Moves the charts to integer coordinates. Returns whether every tetrahedron is positive there.
bool MoveToIntegers(Attempt& attempt, const Progress& progress)
{
  // The charts' coordinates become integers at once and are fixed there. The other coordinates
  // follow by minimising the energy, which untangles what the jump inverted.
  const Eigen::VectorXi numbers =
    RoundCharts(attempt.Solid, attempt.Charts, attempt.Tied, attempt.Positions);
  ConstrainedCoordinates fixed = attempt.Tied;
  for (std::size_t v = 0; v < attempt.Charts.AtPoint.size(); ++v)
  {
    for (const int chart : attempt.Charts.AtPoint[v])
    {
      const int axis = attempt.Charts.Labels[chart] / 2;
      attempt.Positions(v, axis) = numbers(chart);
      fixed.Unknowns(3 * v + axis) = -1;
    }
  }
  std::vector<int> renumbered(fixed.Count, -1);
  fixed.Count = 0;
  for (int& unknown : fixed.Unknowns)
  {
    if (unknown >= 0)
    {
      int& number = renumbered[unknown];
      number = number < 0 ? fixed.Count++ : number;
      unknown = number;
    }
  }
  attempt.Result =
    MinimizeConstrainedEnergy(attempt.Positions, attempt.Solid, fixed, TiedOptions(), progress);
  return attempt.Result.Negative == 0;
}

} // namespace

std::vector<char> FindInvertedTriangles(const Mesh& polycube, const Eigen::VectorXi& labels)
{
  const Eigen::MatrixXd vectors = ComputeAreaVectors(polycube);
  std::vector<char> turned(labels.size());
  for (Eigen::Index f = 0; f < labels.size(); ++f)
  {
    turned[f] = !(vectors.row(f).dot(GetLabelAxis(labels(f))) > 0.0);
  }
  return turned;
}

PolycubeMap FindPolycubeMap(const Surface& surface, double compactness,
  const PolycubeMapOptions& options, const Progress& progress)
{
  RequireOption(compactness > 0.0 && std::isfinite(compactness), "Compactness", compactness,
    "positive and finite");
  RequireOption(options.CellSize >= 0.0 && std::isfinite(options.CellSize), "the cell size",
    options.CellSize, "positive and finite, or 0 for an automatic size");
  RequireClosedSurface(surface, "the surface");
  RequireVolume(surface, "the surface");
  // 1. BuildWorkingSolid: a coarse tetrahedralisation, rotated to the axes.
  // 2. AlignWithAxes: the normals are turned towards the axes (Gregson et al. 2011).
  // 3. TryCompactness: labels (PolyCut), flattening and one coordinate for each chart, with repairs
  //    of the labels. Further compactnesses are tried until no tetrahedron is negative.
  // 4. MoveToIntegers: the charts move to integer coordinates (RoundCharts).
  WorkingSolid solid = BuildWorkingSolid(
    surface, options.Triangles, progress.Part(0.0, 0.08, "tetrahedralizing the solid"));
  const Eigen::MatrixXd positions = solid.Points;
  const Eigen::Matrix3d straight = FindAxisRotation(solid.Surface());
  Attempt best;
  best.Result.Negative = std::numeric_limits<int>::max();
  int work = 0;
  double left = 1.0; // of the progress of the trials: the first ones often succeed
  // All trials with the same direction of the axes share the alignment.
  for (const bool turned : { false, true })
  {
    const Eigen::Matrix3d rotation =
      turned ? Eigen::Matrix3d(ToRotation(Turn) * straight) : straight;
    solid.Points = positions * rotation.transpose();
    const Eigen::MatrixXd aligned =
      AlignWithAxes(solid, progress.Part(0.08, 0.25, "aligning the surface with the axes"));
    for (const Trial& trial : Trials)
    {
      if (trial.Turned != turned || best.Result.Negative == 0 || work > MaximumWork)
      {
        continue;
      }
      Attempt attempt =
        TryCompactness(solid, aligned, trial.Factor * compactness, options.Facing, work,
          progress.Part(0.25, 0.9, "dividing the surface into patches")
            .Part(1.0 - left, 1.0 - 0.5 * left));
      left *= 0.5;
      attempt.Rotation = rotation;
      if (attempt.Result.Negative < best.Result.Negative)
      {
        best = std::move(attempt);
      }
    }
  }
  if (best.Result.Negative > 0)
  {
    throw SolveFailure("no valid polycube was found: with " + std::to_string(best.Charts.Count()) +
      " charts, " + std::to_string(best.Result.Negative) + " of " +
      std::to_string(best.Solid.Tetrahedra.rows()) + " tetrahedra stay inverted" +
      (options.Facing ? " or lie under folded charts" : "") + "; " +
      (best.Faults.empty() ? "no single chart is at fault"
                           : DescribeFaults(best.Faults, best.Charts)) +
      "; try Shape Polycube with another Compactness, or Shape Hex Remesh with Method Grid");
  }
  double size = options.CellSize > 0.0
    ? options.CellSize
    : std::cbrt(ComputeEnclosedVolume(best.Solid.Surface()) / AutomaticCells);
  for (int attempt = 0; attempt < QuantisationAttempts; ++attempt, size *= QuantisationShrinkage)
  {
    // Each attempt starts from the polycube before rounding.
    Attempt whole = best;
    whole.Solid.Points /= size;
    whole.Positions /= size;
    if (MoveToIntegers(
          whole, progress.Part(0.9, 1.0, "moving the patches to integer coordinates")) &&
      (!options.Facing || CountFolded(whole) == 0))
    {
      PolycubeMap map;
      map.Solid = std::move(whole.Solid);
      // Back to the surface's units and axes.
      map.Solid.Points = size * map.Solid.Points * whole.Rotation;
      map.Positions = std::move(whole.Positions);
      map.Labels = std::move(whole.Labels);
      map.Charts = std::move(whole.Charts);
      map.CellSize = size;
      map.Distortion = whole.Result.EnergyAfter;
      return map;
    }
  }
  throw SolveFailure("the charts of the polycube cannot be rounded to cells of size " +
    FormatNumber(size / QuantisationShrinkage) +
    "; use a smaller TargetEdgeLength in Shape Polycube, or CellSize in Shape Hex Remesh");
}

} // namespace shape
