#include "Harmonic/NearSurfaceCharges.h"

#include "Base/Errors.h"
#include "Geometry/VertexNormals.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace shape
{

namespace
{

/// Side of the square that a point's area would fill, as the spacing of a triangular lattice.
constexpr double SpacingOfRootArea = 1.07;
/// Of the charges / the spacing. Nearer, the map is bumpy between its points; farther, the charges
/// become redundant. RMSE inside triangles of sphere maps at 0.6, 0.75, 0.9, 1.0: bear_bis 1.9e-4,
/// 1.5e-4, 1.4e-4, 1.4e-4; bunny00 1.1e-4, 8.8e-5, 7.8e-5, 7.6e-5; retinal 6.0e-4, 5.6e-4, 5.7e-4,
/// 6.5e-4.
constexpr double NearOffsetOfSpacing = 0.9;
/// Of the coarse charges / the spacing of the clusters.
constexpr double CoarseOffset = 0.5;

/// Coarse charges and the one that each site belongs to.
struct CoarseLevel
{
  Eigen::MatrixXd Sources;
  Eigen::VectorXi Clusters;
};

CoarseLevel PositionCoarse(const SignedDistance& boundary, const Eigen::MatrixXd& sites,
  const Eigen::MatrixXd& normals, const Eigen::VectorXd& areas, int perCluster,
  const Progress& progress)
{
  constexpr int fewest = 64, maximum = 3000;
  const int n = static_cast<int>(sites.rows());
  const int wanted = std::clamp(n / perCluster, std::min(fewest, n), maximum);
  const auto parts = SplitAtMedians(sites, (n + wanted - 1) / wanted);
  const auto count = static_cast<Eigen::Index>(parts.size());
  Eigen::MatrixXd centres(count, 3), directions(count, 3);
  Eigen::VectorXd offsets(count);
  CoarseLevel level;
  level.Clusters.resize(n);
  for (Eigen::Index p = 0; p < count; ++p)
  {
    const Eigen::MatrixXd positions = sites(parts[p], Eigen::all);
    const Eigen::RowVector3d mean = positions.colwise().mean();
    Eigen::Index closest = 0;
    (positions.rowwise() - mean).rowwise().squaredNorm().minCoeff(&closest);
    centres.row(p) = positions.row(closest);
    directions.row(p) = normals.row(parts[p][closest]);
    offsets(p) = CoarseOffset * SpacingOfRootArea * std::sqrt(areas(parts[p]).sum());
    level.Clusters(parts[p]).setConstant(static_cast<int>(p));
  }
  const NearSurfaceCharges placed =
    InsertNearSurfaceCharges(boundary, centres, directions, offsets, progress);
  level.Sources = placed.Points;
  // A cluster whose charge found no room joins the nearest one that has.
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

/// Means of a hat function over the triangles around each point, by the rule that has 1 / 12 of a
/// triangle's area at its corners and 3 / 4 at its centroid: points' count x (points, centroids).
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
  std::vector<Eigen::Triplet<double>> entries;
  for (int t = 0; t < surface.Triangles().rows(); ++t)
  {
    for (const int corner : surface.Triangles().row(t))
    {
      if (number(corner) >= 0)
      {
        entries.emplace_back(number(corner), n + t, 0.25 * areas(t) / around(corner));
      }
    }
  }
  for (Eigen::Index k = 0; k < points.size(); ++k)
  {
    entries.emplace_back(static_cast<int>(k), points(k), 0.25);
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> means(points.size(), n + surface.Triangles().rows());
  means.setFromTriplets(entries.begin(), entries.end());
  return means;
}

} // namespace

NearSurfaceCharges InsertNearSurfaceCharges(const SignedDistance& boundary,
  const Eigen::MatrixXd& sites, const Eigen::MatrixXd& normals, const Eigen::VectorXd& offsets,
  const Progress& progress)
{
  constexpr double room = 0.6, nearer = 0.7;
  constexpr int steps = 4;
  const Eigen::Index n = sites.rows();
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
        offset *= step < steps ? nearer : 0.0;
        crowded.push_back(open[k]);
      }
    }
    open = std::move(crowded);
  }

  std::vector<int> placed;
  NearSurfaceCharges sources;
  for (int i = 0; i < n; ++i)
  {
    if (reached(i) > 0.0)
    {
      placed.push_back(i);
    }
  }
  sources.Points = positions(placed);
  sources.Offsets = reached(placed);
  sources.Sites = Eigen::Map<const Eigen::VectorXi>(placed.data(), placed.size());
  return sources;
}

NearSurfaceChargeSystem::NearSurfaceChargeSystem(
  const SignedDistance& boundary, const Surface& surface, Effort effort, const Progress& progress)
{
  const Eigen::MatrixXd normals = ComputeVertexNormals(surface, NormalWeight::Area);
  const Eigen::VectorXd areas = ComputePointAreas(surface);
  const NearSurfaceCharges near = InsertNearSurfaceCharges(boundary, surface.Points(), normals,
    NearOffsetOfSpacing * SpacingOfRootArea * areas.cwiseSqrt(), progress.Part(0.0, 0.3));
  if (near.Sites.size() == 0)
  {
    throw SolveFailure(
      "no charge finds room outside the boundary; its triangles face the wrong way "
      "or it is folded onto itself");
  }
  this->WithoutCharge = static_cast<int>(surface.Points().rows() - near.Sites.size());
  Eigen::VectorXd offsets = near.Offsets;
  const auto hundredth = offsets.begin() + offsets.size() / 100;
  std::nth_element(offsets.begin(), hundredth, offsets.end());
  this->NearOffset = *hundredth;
  const CoarseLevel coarse = PositionCoarse(boundary, surface.Points()(near.Sites, Eigen::all),
    normals(near.Sites, Eigen::all), areas(near.Sites), effort == Effort::Little ? 128 : 32,
    progress.Part(0.3, 0.4));
  const Eigen::Index n = surface.Points().rows(), m = surface.Triangles().rows();
  this->System.Sites = surface.Points()(near.Sites, Eigen::all);
  this->System.Sources = near.Points;
  this->System.Rows.resize(n + m, 3);
  this->System.Rows << surface.Points(), ComputeCentroids(surface);
  this->System.Tests = HatMeans(surface, near.Sites);
  this->System.Weights.resize(n + m);
  this->System.Weights << 0.25 * areas, 0.375 * surface.AreaVectors().rowwise().norm();
  this->AllSources.resize(near.Points.rows() + coarse.Sources.rows(), 3);
  this->AllSources << near.Points, coarse.Sources;
  SchwarzOptions blocks;
  if (effort != Effort::Little)
  {
    blocks.Around = 200;
    blocks.MaximumAmplification = 0.0;
  }
  this->Preconditioner = std::make_unique<SchwarzPreconditioner>(
    this->System, coarse.Sources, coarse.Clusters, blocks, progress.Part(0.4, 0.9));
  this->Sums = std::make_unique<FmmSummation>(
    this->AllSources, this->System.Rows, FmmSummationOptions(), progress.Part(0.9, 1.0));
}

Eigen::MatrixXd NearSurfaceChargeSystem::Values(
  const Eigen::MatrixXd& charges, const Progress& progress) const
{
  return this->Sums->Potentials(charges, progress);
}

GmresResult NearSurfaceChargeSystem::Solve(
  const Eigen::MatrixXd& values, const GmresOptions& options, const Progress& progress) const
{
  return SolveGmres([&](const Eigen::MatrixXd& charges) { return this->Values(charges); },
    [&](const Eigen::MatrixXd& residual) { return this->Preconditioner->Apply(residual); }, values,
    this->System.Weights, options, progress);
}

} // namespace shape
