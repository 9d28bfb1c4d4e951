#include "Hex/Grid/SizedHexes.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Base/Parallel.h"
#include "Mesh/HexMesh.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// Logarithms of size ratios: errors below the first are not corrected; the second is acceptable.
const double Tolerated = std::log(1.1), Accepted = std::log(1.2);
/// The minimum radius of a seed, in cells of the wanted size at its centre.
constexpr double MinimumRadius = 3.0;
/// The normal equations of the fit are dense: this bounds their cost.
constexpr int MaximumSeeds = 400;

/// Seeds whose flow stretches cells to the sizes wanted: a least-squares fit. Order of calls: Add,
/// then Step a few times, again and again; then take the Result.
class SizeFit
{
public:
  SizeFit(const Surface& surface, const Eigen::VectorXd& sizes)
  {
    constexpr int count = 3000;
    constexpr unsigned int seed = 1;
    const Eigen::MatrixXd spread = SampleRandomly(surface, count, seed);
    // Small parts with small cells may have little area, but they have points.
    const Eigen::Index stride = surface.Points().rows() / count + 1;
    const Eigen::Index points = (surface.Points().rows() + stride - 1) / stride;
    this->Positions.resize(count + points, 3);
    this->Positions.topRows(count) = spread;
    for (Eigen::Index i = 0; i < points; ++i)
    {
      this->Positions.row(count + i) = surface.Points().row(i * stride);
    }
    const ClosestPoints closest = SurfaceLocator(surface).Find(this->Positions);
    this->Wanted = PullBack(closest, surface.Triangles(), sizes).col(0).array().log();
    this->Stretch = Eigen::VectorXd::Zero(this->Wanted.size());
    this->CellSize = this->Wanted.mean();
  }

  /// The residual: logarithms of cell sizes relative to the wanted ones.
  Eigen::VectorXd Excess() const
  {
    return (this->CellSize - this->Stretch.array() - this->Wanted.array()).matrix();
  }

  /// Adds seeds where cells do not have the wanted size; false if there are no such positions.
  /// The positions with the largest error first, at least one radius apart.
  bool Add(double radius)
  {
    const Eigen::VectorXd excess = this->Excess().cwiseAbs();
    std::vector<int> order;
    for (int i = 0; i < static_cast<int>(excess.size()); ++i)
    {
      if (excess(i) > Tolerated && radius > MinimumRadius * std::exp(this->Wanted(i)))
      {
        order.push_back(i);
      }
    }
    std::stable_sort(
      order.begin(), order.end(), [&](int a, int b) { return excess(a) > excess(b); });
    const std::size_t before = this->Seeds.size();
    for (const int i : order)
    {
      const Eigen::RowVector3d centre = this->Positions.row(i);
      if (this->Seeds.size() < MaximumSeeds &&
        std::none_of(this->Seeds.begin() + static_cast<std::ptrdiff_t>(before), this->Seeds.end(),
          [&](const RefinementSeed& other) { return (other.Centre - centre).norm() < radius; }))
      {
        this->Seeds.push_back({ centre, radius, 0.0 });
      }
    }
    return this->Seeds.size() > before;
  }

  /// Makes one Gauss-Newton step for all strengths and the size of the grid.
  void Step()
  {
    // The ridge keeps the strengths small where seeds overlap and their sum alone is determined.
    constexpr double ridge = 1e-3;
    const auto count = static_cast<Eigen::Index>(this->Seeds.size());
    const Eigen::MatrixXd moved = GridDensity(this->Seeds).Forward(this->Positions);
    Eigen::MatrixXd slopes(this->Positions.rows(), count + 1);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      // The mean of the velocity's divergence at both ends of the path.
      const RefinementSeed& seed = this->Seeds[j];
      for (Eigen::Index i = 0; i < slopes.rows(); ++i)
      {
        slopes(i, j) =
          0.5 * (Divergence(seed, this->Positions.row(i)) + Divergence(seed, moved.row(i)));
      }
    }
    slopes.col(count).setConstant(-1.0);
    Eigen::VectorXd strengths(count + 1);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      strengths(j) = this->Seeds[j].Strength;
    }
    strengths(count) = 0.0;
    Eigen::MatrixXd normal = slopes.transpose() * slopes;
    Eigen::VectorXd right = slopes.transpose() * this->Excess();
    const double weight = ridge * static_cast<double>(slopes.rows());
    normal.diagonal().head(count).array() += weight;
    right.head(count) -= weight * strengths.head(count);
    const Eigen::VectorXd step = normal.ldlt().solve(right);
    for (Eigen::Index j = 0; j < count; ++j)
    {
      this->Seeds[j].Strength += step(j);
    }
    this->CellSize += step(count);
    this->FindStretch();
  }

  SizedGrid Result() const
  {
    const Eigen::ArrayXd excess = this->Excess();
    const auto share = [&](const auto& holds)
    { return static_cast<double>(holds.count()) / static_cast<double>(excess.size()); };
    return { this->Seeds, std::exp(this->CellSize), share(excess <= Accepted),
      share(excess >= -Accepted) };
  }

private:
  /// A third of the divergence of a seed's velocity at strength 1.
  static double Divergence(const RefinementSeed& seed, const Eigen::RowVector3d& position)
  {
    const double scaled = (position - seed.Centre).squaredNorm() / (seed.Radius * seed.Radius);
    return (1.0 - scaled / 3.0) * std::exp(-0.5 * scaled);
  }

  /// Returns the logarithm of the flow's stretch, the cube root of its determinant, at the
  /// positions.
  void FindStretch()
  {
    const GridDensity warp(this->Seeds);
    double minimum = this->Seeds.front().Radius;
    for (const RefinementSeed& seed : this->Seeds)
    {
      minimum = std::min(minimum, seed.Radius);
    }
    // Central differences of the flow, with a step far below the smallest seed.
    const double step = 1e-3 * minimum;
    Eigen::MatrixXd slopes[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const Eigen::RowVector3d way = step * Eigen::RowVector3d::Unit(axis);
      slopes[axis] = (warp.Forward(this->Positions.rowwise() + way) -
                       warp.Forward(this->Positions.rowwise() - way)) /
        (2.0 * step);
    }
    for (Eigen::Index i = 0; i < this->Stretch.size(); ++i)
    {
      Eigen::Matrix3d jacobian;
      jacobian << slopes[0].row(i), slopes[1].row(i), slopes[2].row(i);
      this->Stretch(i) = std::log(std::max(jacobian.determinant(), 1e-12)) / 3.0;
    }
  }

  Eigen::MatrixXd Positions;
  Eigen::VectorXd Wanted;  ///< logarithms of the wanted sizes
  Eigen::VectorXd Stretch; ///< logarithms of the stretch
  double CellSize;         ///< logarithm of the cell size
  std::vector<RefinementSeed> Seeds;
};

} // namespace

void RequireSizes(const Surface& surface, const Eigen::VectorXd& sizes)
{
  if (sizes.size() != surface.Points().rows())
  {
    throw InvalidInput("the SizeArray has " + std::to_string(sizes.size()) +
      " values for the surface's " + std::to_string(surface.Points().rows()) +
      " points; give one value for each point");
  }
  const auto good = [](double size) { return std::isfinite(size) && size > 0.0; };
  const auto bad =
    std::count_if(sizes.begin(), sizes.end(), [&](double size) { return !good(size); });
  if (bad > 0)
  {
    const auto first = std::find_if_not(sizes.begin(), sizes.end(), good) - sizes.begin();
    throw InvalidInput("the SizeArray has " + std::to_string(bad) +
      " values that are not positive and finite (first at point " + std::to_string(first) + ": " +
      FormatNumber(sizes(first)) +
      "); give a positive length in the surface's units at each point");
  }
}

// From coarse to fine: in each level seeds of one radius are added where sizes are wrong, and a few
// Gauss-Newton steps fit the strengths of all seeds.
SizedGrid BuildSizedGrid(
  const Surface& surface, const Eigen::VectorXd& sizes, const Progress& progress)
{
  SizeFit fit(surface, sizes);
  // Radii from 1/2 to 1/128 of the longest edge of the box.
  constexpr int levels = 7, steps = 3;
  double radius = 0.5 * ComputeLongestBoxEdge(surface.Points());
  for (int level = 0; level < levels; ++level, radius *= 0.5)
  {
    if (fit.Add(radius))
    {
      for (int step = 0; step < steps; ++step)
      {
        fit.Step();
        progress((level + (step + 1.0) / steps) / levels);
      }
    }
  }
  progress(1.0);
  return fit.Result();
}

Eigen::VectorXd ComputeSizeRatios(const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads,
  const Surface& surface, const Eigen::VectorXd& sizes)
{
  const Eigen::VectorXd wanted = PullBack(
    SurfaceLocator(surface).Find(ComputeQuadCentres(points, quads)), surface.Triangles(), sizes)
                                   .col(0);
  const Eigen::VectorXd areas =
    0.5 * ComputeAreaVectors({ points, SplitQuads(quads) }).rowwise().norm();
  Eigen::VectorXd ratios(quads.rows());
  for (Eigen::Index q = 0; q < quads.rows(); ++q)
  {
    ratios(q) = std::sqrt(areas(2 * q) + areas(2 * q + 1)) / wanted(q);
  }
  return ratios;
}

namespace
{

/// Corrects the requested sizes at the surface's points: each is divided by the local geometric
/// mean of the quads' size ratios.
Eigen::VectorXd Corrected(const Surface& surface, const Eigen::VectorXd& sizes,
  const Eigen::VectorXd& asked, const HexFit& fit, const Eigen::VectorXd& ratios)
{
  constexpr double reach = 3.0; // sizes
  const Eigen::MatrixXd centres = ComputeQuadCentres(fit.Solid.Points, fit.Quads);
  const Eigen::ArrayXd logarithms = ratios.array().log();
  Eigen::VectorXd corrected = asked;
  ParallelFor(static_cast<int>(sizes.size()), 64,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const double width = reach * sizes(i);
        const Eigen::ArrayXd squared =
          (centres.rowwise() - surface.Points().row(i)).rowwise().squaredNorm() / (width * width);
        // Relative to the nearest quad, so that the weights do not vanish if all are far away.
        const Eigen::ArrayXd weights = (0.5 * (squared.minCoeff() - squared)).exp();
        corrected(i) *= std::exp(-(weights * logarithms).sum() / weights.sum());
      }
    });
  return corrected;
}

} // namespace

SizedHexesResult BuildSizedHexahedra(const Surface& surface, const Eigen::VectorXd& sizes,
  GridHexesOptions options, const Progress& progress, const std::vector<Surface>& innerSurfaces)
{
  RequireSizes(surface, sizes);
  const int rounds = options.Rounds;
  options.Snap = false; // it changes the sizes
  Eigen::VectorXd asked = sizes;
  SizedHexesResult result;
  for (const bool last : { false, true })
  {
    const Progress part = last ? progress.Part(0.4, 1.0) : progress.Part(0.0, 0.4);
    SizedGrid grid = BuildSizedGrid(surface, asked, part.Part(0.0, 0.2, "sizing the grid"));
    options.CellSize = grid.CellSize;
    options.Seeds = std::move(grid.Seeds);
    // The first grid only measures the sizes, so it needs no further rounds.
    options.Rounds = last ? rounds : 1;
    result.Hexes = BuildGridHexahedra(surface, options, part.Part(0.2, 1.0), innerSurfaces);
    const HexFit& fit = result.Hexes.Fit;
    result.Ratios = ComputeSizeRatios(fit.Solid.Points, fit.Quads, surface, sizes);
    if (!last)
    {
      asked = Corrected(surface, sizes, asked, fit, result.Ratios);
    }
  }
  return result;
}

} // namespace shape
