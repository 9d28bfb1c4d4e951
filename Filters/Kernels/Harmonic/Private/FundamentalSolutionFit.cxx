#include "Harmonic/Private/FundamentalSolutionFit.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/Sampling.h"
#include "Linear/DenseSolve.h"
#include "Mesh/Topology.h"

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <sstream>
#include <string>

namespace shape
{

namespace
{

/// Returns [A b] of the weighted least-squares affine map from `points` to `targets`.
Eigen::Matrix<double, 3, 4> AffineFit(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& targets, const Eigen::VectorXd& weights)
{
  const Eigen::VectorXd roots = weights.cwiseSqrt();
  Eigen::MatrixXd rows(points.rows(), 4);
  rows << points, Eigen::VectorXd::Ones(points.rows());
  const Eigen::MatrixXd solution = (roots.asDiagonal() * rows)
                                     .completeOrthogonalDecomposition()
                                     .solve(roots.asDiagonal() * targets);
  return solution.transpose();
}

/// Merges charges at the same position and drops zero charges; the field stays the same.
ChargeSet MergeCharges(const ChargeSet& set)
{
  const auto at = [&](int i) {
    return std::array<double, 3>{ set.Points(i, 0), set.Points(i, 1), set.Points(i, 2) };
  };
  // Sorted by position; equal positions by their number, so the first of each comes first.
  std::vector<int> order(set.Points.rows());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return at(a) < at(b); });
  Eigen::VectorXi position(set.Points.rows());
  for (std::size_t k = 0; k < order.size(); ++k)
  {
    position(order[k]) =
      k > 0 && at(order[k - 1]) == at(order[k]) ? position(order[k - 1]) : order[k];
  }
  // Numbers of the merged charges, in the order of the first of each.
  std::vector<int> first;
  for (int i = 0; i < position.size(); ++i)
  {
    if (position(i) == i)
    {
      first.push_back(i);
      position(i) = static_cast<int>(first.size()) - 1;
    }
    else
    {
      position(i) = position(position(i)); // the first comes earlier, and has its number
    }
  }
  ChargeSet merged{ set.Points(first, Eigen::all), Eigen::MatrixXd::Zero(first.size(), 3) };
  merged.Affine = set.Affine;
  for (Eigen::Index i = 0; i < position.size(); ++i)
  {
    merged.Charges.row(position(i)) += set.Charges.row(i);
  }
  std::vector<int> charged;
  for (int i = 0; i < merged.Charges.rows(); ++i)
  {
    if ((merged.Charges.row(i).array() != 0.0).any())
    {
      charged.push_back(i);
    }
  }
  merged.Points = merged.Points(charged, Eigen::all).eval();
  merged.Charges = merged.Charges(charged, Eigen::all).eval();
  return merged;
}

/// Returns the memory of SingularValues for an m x n matrix in GiB: either the matrix, its
/// triangular factor with U and V^T, and the workspace of LAPACK's gesdd; or, while the results are
/// received from the process that computed them, two copies of the reflectors, U and V^T.
double DecompositionMemory(double rows, double columns)
{
  const double shorter = std::min(rows, columns), square = shorter * shorter;
  const double values =
    std::max(rows * columns + 7.0 * square, 2.0 * rows * columns + 4.0 * square);
  return 8.0 * values / (1024.0 * 1024.0 * 1024.0);
}

} // namespace

FundamentalSolutionFit::FundamentalSolutionFit(const ScaledBoundary& scaled,
  const VolumeFeatures& features, const HarmonicVolumeMapOptions& options,
  const shape::Processes& processes, const Progress& progress)
  : Scaled(scaled)
  , Processes(processes)
  , SumError(std::clamp(0.03 * options.Tolerance, 1e-10, 1e-5))
  , Device(options.Device)
  , Threshold(options.SingularValueThreshold)
  , MaximumMemory(options.MaximumMemory)
{
  const Eigen::Index count = features.Points.rows();
  this->RootWeights = features.Weights.size() == count
    ? Eigen::VectorXd(features.Weights.cwiseSqrt())
    : Eigen::VectorXd::Constant(count, std::sqrt(options.FeatureWeight));
  const Eigen::MatrixXd positions = (features.Points.rowwise() - scaled.Origin) / scaled.Size;
  if (count > 0)
  {
    const Eigen::VectorXi outside =
      FindPointsOutsideDomain(*this->Distance(), positions, 0.5 * options.OffsetDistance, progress);
    Eigen::Index first = 0;
    if (outside.maxCoeff(&first) > 0)
    {
      throw InvalidInput(std::to_string(outside.sum()) +
        (outside.sum() == 1 ? " feature lies" : " features lie") +
        " outside the boundary (first at feature point " + std::to_string(first) +
        "); leave them out or correct their positions");
    }
  }

  // The residual is known at all probes: boundary points, one position in each triangle, and
  // features. It starts as the images minus the affine part.
  const Surface& surface = scaled.Surface;
  this->Shared =
    SharedRows(processes, { surface.Points().rows(), surface.Triangles().rows(), count });
  const auto &points = this->Shared.OwnRange(0), &triangles = this->Shared.OwnRange(1);
  const auto own = [&](const Eigen::MatrixXd& ofPoints, const Eigen::MatrixXd& ofTriangles,
                     const Eigen::MatrixXd& ofFeatures)
  {
    Eigen::MatrixXd all(this->Shared.OwnCount(), 3);
    all << ofPoints.middleRows(points.Begin, points.Size()),
      ofTriangles.middleRows(triangles.Begin, triangles.Size()), ofFeatures;
    return all;
  };
  this->Probes = own(surface.Points(), ComputeOffCentres(surface), positions);
  this->Residual = own(scaled.Targets, InterpolateAtOffCentres(surface, scaled.Targets),
    (features.Targets.rowwise() - scaled.TargetOrigin) / scaled.TargetSize);
  this->Sum.Affine = AffineFit(surface.Points(), scaled.Targets, ComputePointAreas(surface));
  this->Residual -= Evaluate(this->Sum, this->Probes);
  this->Positions.resize(0, 3);
  this->CollocationResidual.resize(0, 3);
}

std::shared_ptr<const SignedDistance> FundamentalSolutionFit::Distance()
{
  const Surface& surface = this->Scaled.Surface;
  if (this->Processes.Count > 1)
  {
    // The surface caches the search tree, so a copy of the surface is freed with the tree.
    return std::make_shared<const SignedDistance>(Surface(surface.AsMesh()));
  }
  if (!this->Field)
  {
    this->Field = std::make_shared<const SignedDistance>(surface);
  }
  return this->Field;
}

Eigen::MatrixXd FundamentalSolutionFit::Left(
  const Eigen::MatrixXd& positions, const Eigen::MatrixXd& targets, const Progress& progress) const
{
  const double all = this->Processes.SumOf(static_cast<double>(positions.rows()));
  return targets -
    Evaluate(
      this->Sum, positions, progress, this->SumError, static_cast<Eigen::Index>(all), this->Device);
}

void FundamentalSolutionFit::Collocate(const Eigen::MatrixXd& points, const Progress& progress)
{
  const Surface& surface = this->Scaled.Surface;
  const ClosestPoints closest = this->Distance()->Locator().Find(points, progress.Part(0.0, 0.5));
  const Eigen::Index before = this->Positions.rows();
  this->Positions.conservativeResize(before + points.rows(), 3);
  this->Positions.bottomRows(points.rows()) = closest.Positions;
  for (const int triangle : closest.Triangles)
  {
    this->CollocationComponents.push_back(
      surface.Topology().ComponentId(surface.Triangles()(triangle, 0)));
  }
  // The boundary condition of the next map: the images minus the sum so far (Li et al. 2010,
  // section 3.2).
  this->CollocationResidual.conservativeResize(before + points.rows(), 3);
  this->CollocationResidual.bottomRows(points.rows()) =
    PullBack(closest, surface.Triangles(), this->Scaled.Targets) -
    Evaluate(
      this->Sum, closest.Positions, progress.Part(0.5, 1.0), this->SumError, 0, this->Device);
}

void FundamentalSolutionFit::RequireMemory(int boundaryRows, int sources) const
{
  const Eigen::Index rows = boundaryRows + this->RootWeights.size();
  const double memory = DecompositionMemory(static_cast<double>(rows), sources);
  // LAPACK stores its workspace size, 4 times the square of the shorter side, as a 32-bit integer.
  constexpr Eigen::Index maximum = 23000;
  if (memory > this->MaximumMemory || std::min<Eigen::Index>(rows, sources) > maximum)
  {
    std::ostringstream message;
    message << "the system of " << rows << " x " << sources << " would take " << memory
            << " GiB to decompose; the limits are " << this->MaximumMemory
            << " GiB and a shorter side of " << maximum
            << "; lower CollocationRatio and SourceRatio, or use MultiLevel with more subsets";
    throw InvalidInput(message.str());
  }
}

Eigen::VectorXd FundamentalSolutionFit::GetCollocationAreas(int count) const
{
  std::vector<std::vector<int>> rows(this->Scaled.Surface.Topology().Components);
  for (int i = 0; i < count; ++i)
  {
    rows[this->CollocationComponents[i]].push_back(i);
  }
  Eigen::VectorXd areas(count);
  for (const std::vector<int>& component : rows)
  {
    if (!component.empty())
    {
      areas(component) = ComputeSampledAreas(this->Positions(component, Eigen::all));
    }
  }
  return areas;
}

FundamentalSolutionFit::Fit FundamentalSolutionFit::Solve(
  int boundaryRows, const Eigen::MatrixXd& sources, const Progress& progress) const
{
  // Li et al. 2010, section 3.3, for all three coordinates at once:
  // - step 2: the coefficient matrix; features are further rows (section 4.4);
  // - steps 3 and 4: its singular value decomposition solves the weighted least-squares problem;
  // - section 4.2: singular values below the threshold show redundant sources.
  const Eigen::Index featureRows = this->RootWeights.size();
  const Eigen::Index rows = boundaryRows + featureRows;
  this->RequireMemory(boundaryRows, static_cast<int>(sources.rows()));
  Eigen::MatrixXd points(rows, 3), rightSide(rows, 3);
  points << this->Positions.topRows(boundaryRows), this->Probes.bottomRows(featureRows);
  rightSide << this->CollocationResidual.topRows(boundaryRows),
    this->Residual.bottomRows(featureRows);
  // Step 2. A row multiplied by the square root of w has the weight of w equal rows (section 4.4).
  Eigen::MatrixXd matrix = BuildPotentialMatrix(points, sources, progress.Part(0.0, 0.1));
  Eigen::VectorXd roots(rows);
  roots << this->GetCollocationAreas(boundaryRows).cwiseSqrt(), this->RootWeights;
  ParallelFor(
    static_cast<int>(matrix.cols()), 64,
    [&](int begin, int end)
    { matrix.middleCols(begin, end - begin).array().colwise() *= roots.array(); },
    progress.Part(0.1, 0.12));
  // Steps 3 and 4.
  const SingularValues decomposition(std::move(matrix), progress.Part(0.12, 0.95));

  Fit fit;
  fit.Rows = static_cast<int>(rows);
  fit.Charges =
    decomposition.Solve(roots.asDiagonal() * rightSide, this->Threshold, progress.Part(0.95, 0.98));
  // Section 4.2. A singular vector combines all sources; the source of its largest entry is
  // redundant.
  std::set<int> redundant;
  const Eigen::MatrixXd vectors =
    decomposition.RightVectors(decomposition.Rank(this->Threshold), progress.Part(0.98, 1.0));
  for (const auto& vector : vectors.colwise())
  {
    int source = 0;
    vector.cwiseAbs().maxCoeff(&source);
    redundant.insert(source);
  }
  fit.Redundant.assign(redundant.begin(), redundant.end());
  return fit;
}

FundamentalSolutionFit::Added FundamentalSolutionFit::Add(
  const Eigen::MatrixXd& sources, const Eigen::MatrixXd& charges, const Progress& progress)
{
  const Eigen::Index m = this->Scaled.Surface.Triangles().rows();
  ChargeSet step{ sources, charges };
  step.Affine.setZero();
  // All processes sum by the same method.
  const Eigen::MatrixXd change = Evaluate(step, this->Probes, progress.Part(0.0, 0.8),
    this->SumError, this->Shared.Count(), this->Device);

  // The least-squares factor of each coordinate, over the weighted probes.
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(this->Probes.rows());
  weights.segment(this->Shared.OwnRange(0).Size(), this->Shared.OwnRange(1).Size())
    .setConstant(static_cast<double>(std::max<Eigen::Index>(1, this->Positions.rows())) / m);
  weights.tail(this->RootWeights.size()) = this->RootWeights.cwiseAbs2();
  const auto inner = [&](const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
  { return Eigen::RowVector3d(this->Shared.Sum(weights, a, b)); };
  const Eigen::RowVector3d squares = inner(change, change);
  const Eigen::RowVector3d factors =
    (squares.array() > 0.0)
      .select(inner(change, this->Residual).array() / squares.array(), 0.0)
      .max(0.0);
  // The map helps no coordinate: it is left out.
  if (factors.maxCoeff() == 0.0)
  {
    return { factors, 0.0 };
  }
  const double left = inner(this->Residual, this->Residual).sum();
  this->Residual -= change * factors.asDiagonal();
  this->CollocationResidual -=
    Evaluate(step, this->Positions, progress.Part(0.8, 1.0), this->SumError, 0, this->Device) *
    factors.asDiagonal();
  const Eigen::Index before = this->Sum.Points.rows();
  this->Sum.Points.conservativeResize(before + sources.rows(), 3);
  this->Sum.Charges.conservativeResize(before + sources.rows(), 3);
  this->Sum.Points.bottomRows(sources.rows()) = sources;
  this->Sum.Charges.bottomRows(sources.rows()) = charges * factors.asDiagonal();
  return { factors, 1.0 - std::sqrt(inner(this->Residual, this->Residual).sum() / left) };
}

Eigen::MatrixXd FundamentalSolutionFit::WorstPoints(int count, double spacing) const
{
  // Badly fitted boundary points (Li et al. 2010, section 4.1.2), in order of their residual.
  const Eigen::Index probes = this->Probes.rows() - this->RootWeights.size();
  const Eigen::VectorXd errors = this->Residual.topRows(probes).rowwise().squaredNorm();
  std::vector<int> order(probes);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return errors(a) > errors(b); });
  Eigen::MatrixXd worst(count, 3);
  int found = 0;
  // Few points are wanted, so a linear search through those already taken is fast enough.
  for (const int candidate : order)
  {
    if (found == count)
    {
      break;
    }
    const Eigen::RowVector3d point = this->Probes.row(candidate);
    if (found == 0 ||
      (worst.topRows(found).rowwise() - point).rowwise().squaredNorm().minCoeff() >
        spacing * spacing)
    {
      worst.row(found++) = point;
    }
  }
  return worst.topRows(found);
}

HarmonicVolumeMapResult::Level FundamentalSolutionFit::Errors() const
{
  const double n = static_cast<double>(this->Scaled.Surface.Points().rows());
  const double m = static_cast<double>(this->Scaled.Surface.Triangles().rows());
  const Eigen::Index points = this->Shared.OwnRange(0).Size();
  const Eigen::Index triangles = this->Shared.OwnRange(1).Size();
  const auto squares = [&](Eigen::Index first, Eigen::Index count)
  {
    Eigen::VectorXd chosen = Eigen::VectorXd::Zero(this->Residual.rows());
    chosen.segment(first, count).setOnes();
    return this->Shared.Sum(chosen, this->Residual, this->Residual).sum();
  };
  HarmonicVolumeMapResult::Level level;
  level.RMSEVertices = std::sqrt(squares(0, points) / n);
  level.RMSEInside = std::sqrt(squares(points, triangles) / m);
  // Each process fills its own entry.
  Eigen::VectorXd largest = Eigen::VectorXd::Zero(this->Processes.Count);
  if (points + triangles > 0)
  {
    largest(this->Processes.Number) =
      this->Residual.topRows(points + triangles).rowwise().norm().maxCoeff();
  }
  this->Processes.Sum(largest);
  level.Maximum = largest.maxCoeff();
  if (this->Collocations() > 0)
  {
    level.RMSECollocations =
      std::sqrt(this->CollocationResidual.squaredNorm() / this->Collocations());
  }
  return level;
}

double FundamentalSolutionFit::FeatureError() const
{
  const Eigen::Index count = this->RootWeights.size();
  return count == 0 ? 0.0 : std::sqrt(this->Residual.bottomRows(count).squaredNorm() / count);
}

ChargeSet FundamentalSolutionFit::Map() const
{
  // With y' = (y - o) / s and f = o' + s' f'(y'), a potential of y' is s times that of y.
  const ScaledBoundary& scaled = this->Scaled;
  ChargeSet map = MergeCharges(this->Sum);
  map.Points = (scaled.Size * map.Points).rowwise() + scaled.Origin;
  map.Charges *= scaled.Size * scaled.TargetSize;
  const Eigen::Matrix3d linear = scaled.TargetSize / scaled.Size * this->Sum.Affine.leftCols<3>();
  map.Affine.leftCols<3>() = linear;
  map.Affine.col(3) = scaled.TargetOrigin.transpose() +
    scaled.TargetSize * this->Sum.Affine.col(3) - linear * scaled.Origin.transpose();
  return map;
}

} // namespace shape
