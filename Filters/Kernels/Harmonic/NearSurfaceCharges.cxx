#include "Harmonic/NearSurfaceCharges.h"

#include "Base/Errors.h"
#include "Geometry/VertexNormals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace shape
{

namespace
{

/// Spacing of a triangular lattice / the side of a square of the area of one point.
constexpr double SpacingOfRootArea = 1.07;
/// Offset of the coarse charges / the spacing of the clusters.
constexpr double CoarseOffset = 0.5;
/// Errors of the sums with Effort Exact. The relaxed sums take a third of the time.
constexpr double ExactError = 1e-8, RelaxedError = 1e-6;
/// A transposed system is solved by relaxed sums once this share of its residual is left. An error
/// counts by the share (Simoncini and Szyld 2003). It may count a thousandth of the exact sums'
/// error: with a share of 1e-2, gradients by random images of bear_bis had 100 times the error.
constexpr double RelaxedShare = 1e-3 * ExactError / RelaxedError;

/// The coarse charges, and the index of the one that each site belongs to.
struct CoarseLevel
{
  Eigen::MatrixXd Sources;
  Eigen::VectorXi Clusters;
};

CoarseLevel PositionCoarse(const SignedDistance& boundary, const Eigen::MatrixXd& sites,
  const Eigen::MatrixXd& normals, const Eigen::VectorXd& areas, int perCluster,
  const Progress& progress)
{
  // The coarse system is dense: 3000 charges take 72 MB, and time grows with the cube.
  constexpr int fewest = 64, maximum = 3000;
  const int n = static_cast<int>(sites.rows());
  const int wanted = std::clamp(n / perCluster, std::min(fewest, n), maximum);
  // Halves of halves: there can be almost twice as many parts as wanted.
  const int size = (n + wanted - 1) / wanted;
  auto parts = SplitAtMedians(sites, size);
  if (parts.size() > maximum)
  {
    parts = SplitAtMedians(sites, 2 * size);
  }
  const auto count = static_cast<Eigen::Index>(parts.size());
  Eigen::MatrixXd centres(count, 3), directions(count, 3);
  Eigen::VectorXd offsets(count);
  CoarseLevel level;
  level.Clusters.resize(n);
  for (Eigen::Index p = 0; p < count; ++p)
  {
    // The charge lies on the normal of the site nearest to the cluster's mean: the mean itself may
    // lie off the surface.
    const Eigen::MatrixXd positions = sites(parts[p], Eigen::all);
    const Eigen::RowVector3d mean = positions.colwise().mean();
    Eigen::Index closest = 0;
    (positions.rowwise() - mean).rowwise().squaredNorm().minCoeff(&closest);
    centres.row(p) = positions.row(closest);
    directions.row(p) = normals.row(parts[p][closest]);
    offsets(p) = CoarseOffset * SpacingOfRootArea * std::sqrt(areas(parts[p]).sum());
    level.Clusters(parts[p]).setConstant(static_cast<int>(p));
  }
  // The offset is half the spacing of the clusters, from the area of each.
  const NearSurfaceCharges placed =
    InsertNearSurfaceCharges(boundary, centres, directions, offsets, progress);
  level.Sources = placed.Points;
  // A cluster without room for a charge joins the nearest cluster that has one.
  Eigen::VectorXi number = Eigen::VectorXi::Constant(count, -1);
  for (Eigen::Index k = 0; k < placed.Sites.size(); ++k)
  {
    number(placed.Sites(k)) = static_cast<int>(k);
  }
  for (Eigen::Index p = 0; p < count && placed.Sites.size() > 0; ++p)
  {
    if (number(p) < 0)
    {
      Eigen::Index nearest = 0;
      (centres(placed.Sites, Eigen::all).rowwise() - centres.row(p))
        .rowwise()
        .squaredNorm()
        .minCoeff(&nearest);
      number(p) = static_cast<int>(nearest);
    }
  }
  level.Clusters = number(level.Clusters).eval();
  return level;
}

/// Returns the mean weighted by the hat function of each point, as a sparse matrix: one row for
/// each point, one column for each surface point and centroid. The quadrature rule gives 1 / 12 of
/// a triangle's area to each corner and 3 / 4 to the centroid.
Eigen::SparseMatrix<double, Eigen::RowMajor> HatMeans(
  const Surface& surface, const Eigen::VectorXi& points)
{
  const int n = static_cast<int>(surface.Points().rows());
  const Eigen::VectorXd areas = 0.5 * surface.AreaVectors().rowwise().norm();
  const Eigen::VectorXd around = ComputePointAreas(surface);
  Eigen::VectorXi number = Eigen::VectorXi::Constant(n, -1);
  for (Eigen::Index k = 0; k < points.size(); ++k)
  {
    number(points(k)) = static_cast<int>(k);
  }
  // Row by row: the point, then the triangles around it in ascending order.
  Eigen::VectorXi start = Eigen::VectorXi::Zero(points.size() + 1);
  for (const int corner : surface.Triangles().reshaped())
  {
    if (number(corner) >= 0)
    {
      ++start(number(corner) + 1);
    }
  }
  start.tail(points.size()).array() += 1;
  std::partial_sum(start.begin(), start.end(), start.begin());
  Eigen::SparseMatrix<double, Eigen::RowMajor> means(points.size(), n + surface.Triangles().rows());
  means.resizeNonZeros(start(points.size()));
  Eigen::Map<Eigen::VectorXi>(means.outerIndexPtr(), points.size() + 1) = start;
  const auto append = [&](int row, int column, double share)
  {
    means.innerIndexPtr()[start(row)] = column;
    means.valuePtr()[start(row)++] = share;
  };
  for (Eigen::Index k = 0; k < points.size(); ++k)
  {
    append(static_cast<int>(k), points(k), 0.25);
  }
  for (int t = 0; t < surface.Triangles().rows(); ++t)
  {
    for (const int corner : surface.Triangles().row(t))
    {
      if (number(corner) >= 0)
      {
        append(number(corner), n + t, 0.25 * areas(t) / around(corner));
      }
    }
  }
  return means;
}

/// Returns the offset at which each site has a charge; 0 if it has none.
Eigen::VectorXd ReachedOffsets(const SignedDistance& boundary, const Eigen::MatrixXd& sites,
  const Eigen::MatrixXd& normals, const Eigen::VectorXd& offsets, const Progress& progress)
{
  // The offset is multiplied by `nearer` up to `steps` times: 0.7^4 = 0.24 is the limit of the
  // header.
  constexpr double room = 0.6, nearer = 0.7;
  constexpr int steps = 4;
  const Eigen::Index n = sites.rows();
  // All charges start at their full offset. In each round those that are too close to any part of
  // the surface move nearer to their site.
  Eigen::VectorXd reached = offsets;
  std::vector<int> open;
  for (int i = 0; i < n; ++i)
  {
    if (offsets(i) > 0.0 && normals.row(i).squaredNorm() > 0.0)
    {
      open.push_back(i);
    }
    else
    {
      reached(i) = 0.0;
    }
  }
  const auto positions = [&](const std::vector<int>& rows)
  {
    return Eigen::MatrixXd(sites(rows, Eigen::all) +
      Eigen::VectorXd(reached(rows)).asDiagonal() * normals(rows, Eigen::all));
  };
  for (int step = 0; step <= steps && !open.empty(); ++step)
  {
    const Eigen::VectorXd distances =
      boundary
        .Evaluate(positions(open), progress.Part(step / (steps + 1.0), (step + 1) / (steps + 1.0)))
        .Distances;
    std::vector<int> crowded;
    for (std::size_t k = 0; k < open.size(); ++k)
    {
      double& offset = reached(open[k]);
      if (!(distances(k) >= room * offset))
      {
        // 0 means that there is no room for a charge.
        offset *= step < steps ? nearer : 0.0;
        crowded.push_back(open[k]);
      }
    }
    open = std::move(crowded);
  }
  return reached;
}

/// The charges at the offsets that were reached.
NearSurfaceCharges ChargesAt(
  const Eigen::MatrixXd& sites, const Eigen::MatrixXd& normals, const Eigen::VectorXd& reached)
{
  std::vector<int> placed;
  NearSurfaceCharges sources;
  for (int i = 0; i < reached.size(); ++i)
  {
    if (reached(i) > 0.0)
    {
      placed.push_back(i);
    }
  }
  sources.Points = sites(placed, Eigen::all) +
    Eigen::VectorXd(reached(placed)).asDiagonal() * normals(placed, Eigen::all);
  sources.Offsets = reached(placed);
  sources.Sites = Eigen::Map<const Eigen::VectorXi>(placed.data(), placed.size());
  return sources;
}

} // namespace

NearSurfaceCharges InsertNearSurfaceCharges(const SignedDistance& boundary,
  const Eigen::MatrixXd& sites, const Eigen::MatrixXd& normals, const Eigen::VectorXd& offsets,
  const Progress& progress)
{
  return ChargesAt(sites, normals, ReachedOffsets(boundary, sites, normals, offsets, progress));
}

NearSurfaceChargeSystem::NearSurfaceChargeSystem(std::shared_ptr<const SignedDistance> boundary,
  const Surface& surface, double chargeDistance, Effort effort, const shape::Processes& processes,
  const SumDevice& device, const Progress& progress)
  : Shared(processes, { surface.Points().rows(), surface.Triangles().rows() })
{
  // Outline:
  // 1. One charge on the normal of each surface point.
  // 2. Coarse charges farther out, one for each cluster of points.
  // 3. The rows: values at points and centroids, their weights by quadrature, and the averages that
  //    the preconditioner reads.
  // 4. The preconditioner and the fast sums are set up. Each process keeps its share of the rows.
  const Eigen::MatrixXd normals = ComputeVertexNormals(surface, NormalWeight::Area);
  const Eigen::VectorXd areas = ComputePointAreas(surface);
  // Step 1: charges. Each process finds the offsets of its share.
  const Eigen::Index n = surface.Points().rows(), m = surface.Triangles().rows();
  const auto& points = this->Shared.OwnRange(0);
  Eigen::VectorXd reached = Eigen::VectorXd::Zero(n);
  reached.segment(points.Begin, points.Size()) =
    ReachedOffsets(*boundary, surface.Points().middleRows(points.Begin, points.Size()),
      normals.middleRows(points.Begin, points.Size()),
      chargeDistance * SpacingOfRootArea * areas.segment(points.Begin, points.Size()).cwiseSqrt(),
      progress.Part(0.0, 0.3, "placing the charges"));
  processes.Sum(reached);
  const NearSurfaceCharges near = ChargesAt(surface.Points(), normals, reached);
  if (near.Sites.size() == 0)
  {
    throw SolveFailure(
      "there is no room for any charge outside the boundary: its triangles face the wrong way, "
      "or it is folded onto itself; repair the boundary");
  }
  this->WithoutCharge = static_cast<int>(surface.Points().rows() - near.Sites.size());
  // Offset(): the smallest 1 % are left out, because a few narrow gaps say nothing about the rest.
  Eigen::VectorXd offsets = near.Offsets;
  const auto hundredth = offsets.begin() + offsets.size() / 100;
  std::nth_element(offsets.begin(), hundredth, offsets.end());
  this->NearOffset = *hundredth;
  // Step 2: coarse charges.
  const CoarseLevel coarse = PositionCoarse(*boundary, surface.Points()(near.Sites, Eigen::all),
    normals(near.Sites, Eigen::all), areas(near.Sites), effort == Effort::Little ? 128 : 32,
    progress.Part(0.3, 0.4, "placing the charges"));
  boundary.reset();
  // Step 3: rows and averages.
  TestedSystem system;
  system.Sites = surface.Points()(near.Sites, Eigen::all);
  system.Sources = near.Points;
  system.Rows.resize(n + m, 3);
  system.Rows << surface.Points(), ComputeCentroids(surface);
  system.Tests = HatMeans(surface, near.Sites);
  // The quadrature of HatMeans: 1 / 12 of each triangle's area at its corners and 3 / 4 at its
  // centroid. An area vector is twice as long as the area.
  system.Weights.resize(n + m);
  system.Weights << 0.25 * areas, 0.375 * surface.AreaVectors().rowwise().norm();
  this->AllSources.resize(near.Points.rows() + coarse.Sources.rows(), 3);
  this->AllSources << near.Points, coarse.Sources;
  const std::vector<int> own = this->Shared.OwnRows();
  // Step 4. With more effort blocks overlap more and all are solved by regularized least squares
  // (SchwarzOptions).
  SchwarzOptions blocks;
  blocks.Processes = processes;
  FmmSummationOptions sums;
  sums.Device = device;
  if (effort == Effort::More)
  {
    blocks.Around = 200;
    blocks.MaximumAmplification = 0.0;
  }
  else if (effort == Effort::Exact)
  {
    // With more overlap, the steps of both directions halve, and the transposed one, whose right
    // side is not smooth, needs hardly more steps. Blocks cost little beside sums this accurate.
    blocks.Around = 300;
    blocks.MaximumAmplification = std::numeric_limits<double>::infinity();
    sums.Tolerance = ExactError;
    FmmSummationOptions transposed = sums;
    transposed.LargerBoxes =
      std::max(1.0, static_cast<double>(n + m) / static_cast<double>(this->AllSources.rows()));
    this->TransposedSums =
      std::make_unique<FmmSummation>(system.Rows, this->AllSources, transposed);
    transposed.Tolerance = RelaxedError;
    this->RelaxedSums = std::make_unique<FmmSummation>(system.Rows, this->AllSources, transposed);
    this->Tests = system.Tests;
  }
  this->Preconditioner = std::make_unique<SchwarzPreconditioner>(system, own, coarse.Sources,
    coarse.Clusters, blocks, progress.Part(0.4, 0.9, "inverting the blocks"));
  this->Positions = system.Rows(own, Eigen::all);
  this->Weights = system.Weights(own) / system.Weights.sum();
  system = {};
  sums.AllPoints = n + m;
  this->Sums = std::make_unique<FmmSummation>(this->AllSources, this->Positions, sums,
    progress.Part(0.9, 1.0, "preparing the fast summation"));
}

Eigen::MatrixXd NearSurfaceChargeSystem::Values(
  const Eigen::MatrixXd& charges, const Progress& progress) const
{
  return this->Sums->Potentials(charges, progress);
}

GmresResult NearSurfaceChargeSystem::Solve(
  const Eigen::MatrixXd& values, const GmresOptions& given, const Progress& progress) const
{
  GmresOptions options = given;
  options.Inner = [this](const Eigen::MatrixXd& u, const Eigen::MatrixXd& v)
  { return this->Shared.Sum(this->Weights, u, v); };
  // Right-preconditioned GMRES in the weighted norm of the rows (Gmres.h).
  return SolveGmres([&](const Eigen::MatrixXd& charges, const Progress& part)
    { return this->Values(charges, part); },
    [&](const Eigen::MatrixXd& residual, const Progress& part)
    { return this->Preconditioner->Apply(residual, part); },
    values, this->Weights, options, progress);
}

GmresResult NearSurfaceChargeSystem::SolveAverages(
  const Eigen::MatrixXd& values, const GmresOptions& options, const Progress& progress) const
{
  return SolveGmres([&](const Eigen::MatrixXd& charges, const Progress& part)
    { return Eigen::MatrixXd(this->Tests * this->Values(charges, part)); },
    [&](const Eigen::MatrixXd& averages, const Progress& part)
    { return this->Preconditioner->ApplyToAverages(averages, part); },
    this->Tests * values, this->AverageWeights(), options, progress);
}

GmresResult NearSurfaceChargeSystem::SolveTransposed(
  const Eigen::MatrixXd& charges, const GmresOptions& options, const Progress& progress) const
{
  // (T A B)^T u = B^T charges; the result is T^T u. The norm of functionals is dual to that of
  // averages. The right side is scaled to norm 1, because the tolerance is absolute.
  const Eigen::VectorXd weights = this->AverageWeights().cwiseInverse();
  Eigen::MatrixXd rightSide = this->Preconditioner->ApplyTransposed(charges);
  const double norm = std::sqrt(
                 (weights.transpose() * rightSide.cwiseAbs2()).maxCoeff() / weights.sum()),
               size = norm > 0.0 ? norm : 1.0;
  rightSide /= size;
  const FmmSummation* sums = nullptr;
  GmresOptions relaxed = options;
  relaxed.Relax = [&](double left)
  { sums = (left > RelaxedShare ? this->TransposedSums : this->RelaxedSums).get(); };
  GmresResult result = SolveGmres(
    [&](const Eigen::MatrixXd& rows, const Progress& part)
    {
      return this->Preconditioner->ApplyTransposed(
        sums->Potentials(rows, part.Part(0.0, 0.7)), part.Part(0.7, 1.0));
    },
    [&](const Eigen::MatrixXd& averages, const Progress&)
    { return Eigen::MatrixXd(this->Tests.transpose() * averages); },
    rightSide, weights, relaxed, progress);
  result.Solution *= size;
  return result;
}

/// Returns the area of each average.
Eigen::VectorXd NearSurfaceChargeSystem::AverageWeights() const
{
  return this->Tests * this->Weights;
}

} // namespace shape
