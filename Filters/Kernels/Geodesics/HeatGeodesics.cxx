#include "Geodesics/HeatGeodesics.h"

#include "Base/Parallel.h"
#include "Geodesics/EdgeGeodesics.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace shape
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Returns 1 inside, 0 at the ends of edges with one triangle.
Eigen::VectorXd InsideOf(const Surface& surface)
{
  Eigen::VectorXd inside = Eigen::VectorXd::Ones(surface.Points().rows());
  const std::vector<HalfEdge>& sorted = surface.HalfEdges();
  const auto areSame = [&](std::size_t i, std::size_t j)
  { return sorted[i].Low() == sorted[j].Low() && sorted[i].High() == sorted[j].High(); };
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    const bool isShared =
      (i > 0 && areSame(i, i - 1)) || (i + 1 < sorted.size() && areSame(i, i + 1));
    if (!isShared)
    {
      inside(sorted[i].Begin) = 0.0;
      inside(sorted[i].End) = 0.0;
    }
  }
  return inside;
}

/// Returns the maximum distance along edges between a point and the first point of its component.
double Extent(const Surface& surface)
{
  const Eigen::VectorXi& componentId = surface.Topology().ComponentId;
  std::vector<int> firsts;
  for (int point = 0; point < componentId.size(); ++point)
  {
    if (componentId(point) == static_cast<int>(firsts.size()))
    {
      firsts.push_back(point);
    }
  }
  const Eigen::VectorXd distances = ComputeEdgeGeodesics(
    surface, { firsts, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(firsts.size())) });
  double extent = 0.0;
  for (const double distance : distances)
  {
    extent = std::isinf(distance) ? extent : std::max(extent, distance);
  }
  return extent;
}

/// Returns stiffness * time + diagonal; the diagonal is 1 at points without a triangle.
Eigen::SparseMatrix<double> Shifted(
  const Eigen::SparseMatrix<double>& stiffness, double time, const Eigen::VectorXd& diagonal)
{
  Eigen::SparseMatrix<double> matrix = time * stiffness;
  for (Eigen::Index i = 0; i < diagonal.size(); ++i)
  {
    matrix.coeffRef(i, i) += diagonal(i) > 0.0 ? diagonal(i) : 1.0;
  }
  return matrix;
}

} // namespace

HeatGeodesics::HeatGeodesics(const Surface& surface, const Progress& progress)
  : Given(surface.Triangles())
  , Laplacian(GetIntrinsicLaplacian(surface))
  , ComponentId(surface.Topology().ComponentId)
  , Inside(InsideOf(surface))
{
  const Eigen::MatrixXd& lengths = this->Laplacian->Flat.Sides;
  this->Corners.resize(lengths.rows(), 3);
  for (Eigen::Index t = 0; t < this->Corners.rows(); ++t)
  {
    const double a = lengths(t, 0), b = lengths(t, 1), c = lengths(t, 2);
    // The law of cosines; the product of sum and difference loses no digits when the edges are
    // nearly equal.
    const double x = (c * c + (b - a) * (b + a)) / (2.0 * c);
    this->Corners.row(t) << c, x, std::sqrt(std::max(b * b - x * x, 0.0));
  }
  // Heat decays like exp(-distance / sqrt(time)): at 300 times the root of the time it is 1e-130,
  // still within double precision.
  constexpr double share = 1.0 / 300.0, rest = 1e-9;
  const Eigen::Index points = surface.Points().rows();
  const Eigen::SparseMatrix<double>& stiffness = this->Laplacian->Stiffness;
  const Eigen::VectorXd& masses = this->Laplacian->Masses;
  // The extent from one point is at least half of the diameter.
  const double side = std::max(lengths.mean(), share * 2.0 * Extent(surface));
  // Crane et al.: the time is the square of the mean edge length.
  const double time = side * side;
  // First step of algorithm 1: the backward Euler step (M + t S) u = delta.
  this->Heat.Factorize(Shifted(stiffness, time, masses), progress.Part(0.2, 0.5));
  // The constant of each component is undetermined; adding a small share of the masses fixes it.
  this->Poisson.Factorize(
    Shifted(stiffness, 1.0, (rest / masses.sum()) * masses), progress.Part(0.5, 0.8));
  if (this->Inside.minCoeff() == 0.0)
  {
    const Eigen::VectorXd boundary = Eigen::VectorXd::Ones(points) - this->Inside;
    const Eigen::SparseMatrix<double> kept =
      this->Inside.asDiagonal() * stiffness * this->Inside.asDiagonal();
    const Eigen::VectorXd diagonal = this->Inside.cwiseProduct(masses) + boundary;
    this->HeatWithin.emplace();
    this->HeatWithin->Factorize(Shifted(kept, time, diagonal), progress.Part(0.8, 1.0));
  }
  progress(1.0);
}

/// Second step of algorithm 1: X = -grad u / |grad u| in each triangle, and its integrated
/// divergence.
Eigen::VectorXd HeatGeodesics::Divergence(const Eigen::VectorXd& heat) const
{
  Eigen::VectorXd divergence = Eigen::VectorXd::Zero(heat.size());
  const Eigen::MatrixXi& triangles = this->Laplacian->Flat.Triangles;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    const int p = triangles(t, 0), q = triangles(t, 1), r = triangles(t, 2);
    // The second corner is at (c, 0), the third at (x, y). The hat functions' gradients, times
    // twice the area, are the opposite edges rotated inwards by a right angle.
    const double c = this->Corners(t, 0), x = this->Corners(t, 1), y = this->Corners(t, 2);
    const double across = y * (heat(q) - heat(p));
    const double along = c * (heat(r) - heat(p)) - x * (heat(q) - heat(p));
    const double largest = std::max(std::abs(across), std::abs(along));
    if (largest > 0.0)
    {
      // Far from the seeds the square of the heat would underflow.
      const double u = across / largest, v = along / largest;
      const double half = 0.5 / (this->Laplacian->Copies * std::sqrt(u * u + v * v));
      divergence(p) += half * (y * u + (c - x) * v);
      divergence(q) -= half * (y * u - x * v);
      divergence(r) -= half * (c * v);
    }
  }
  return divergence;
}

Eigen::VectorXd HeatGeodesics::Distances(const SurfacePoints& seeds) const
{
  return this->Distances(PushForward(
    seeds, this->Given, Eigen::VectorXd::Ones(seeds.Triangles.size()), this->ComponentId.size()));
}

/// The three steps of algorithm 1 for all columns: heat, normalised gradient, Poisson equation.
Eigen::MatrixXd HeatGeodesics::Distances(const Eigen::MatrixXd& seeds) const
{
  Eigen::MatrixXd heat = this->Heat.Solve(seeds);
  if (this->HeatWithin)
  {
    // Section 3.4: the mean of Neumann and Dirichlet conditions, since either alone bends the level
    // sets at the boundary.
    heat = 0.5 * (heat + this->HeatWithin->Solve(this->Inside.asDiagonal() * seeds));
  }
  // Columns for each task: a column is a pass over all triangles.
  constexpr int grain = 4;
  const int sets = static_cast<int>(seeds.cols());
  ParallelFor(sets, grain,
    [&](int begin, int end)
    {
      for (int k = begin; k < end; ++k)
      {
        heat.col(k) = this->Divergence(heat.col(k));
      }
    });
  // Third step of algorithm 1.
  Eigen::MatrixXd distances = this->Poisson.Solve(heat);
  ParallelFor(sets, grain,
    [&](int begin, int end)
    {
      for (int k = begin; k < end; ++k)
      {
        this->Begin(seeds.col(k), distances.col(k));
      }
    });
  return distances;
}

/// The Poisson equation determines distances up to a constant in each component.
void HeatGeodesics::Begin(
  const Eigen::Ref<const Eigen::VectorXd>& seeds, Eigen::Ref<Eigen::VectorXd> distances) const
{
  const int components = this->ComponentId.maxCoeff() + 1;
  std::vector<double> minimum(components, Infinity);
  std::vector<char> hasSeed(components, 0);
  for (Eigen::Index point = 0; point < seeds.size(); ++point)
  {
    const int component = this->ComponentId(point);
    if (component >= 0)
    {
      minimum[component] = std::min(minimum[component], distances(point));
      hasSeed[component] |= seeds(point) > 0.0;
    }
  }
  for (Eigen::Index point = 0; point < seeds.size(); ++point)
  {
    const int component = this->ComponentId(point);
    distances(point) =
      component >= 0 && hasSeed[component] ? distances(point) - minimum[component] : Infinity;
  }
}

std::shared_ptr<const HeatGeodesics> GetHeatGeodesics(
  const Surface& surface, const Progress& progress)
{
  return surface.Cached<HeatGeodesics>([&]() { return HeatGeodesics(surface, progress); });
}

Eigen::MatrixXd ComputeHeatDistances(
  const Surface& surface, const std::vector<int>& points, const Progress& progress)
{
  constexpr int batch = 32; // number of sets solved in one pass over the factors
  const std::shared_ptr<const HeatGeodesics> geodesics =
    GetHeatGeodesics(surface, progress.Part(0.0, 0.1));
  const int count = static_cast<int>(points.size());
  Eigen::MatrixXd distances(surface.Points().rows(), count);
  for (int first = 0; first < count; first += batch)
  {
    const int size = std::min(batch, count - first);
    Eigen::MatrixXd seeds = Eigen::MatrixXd::Zero(surface.Points().rows(), size);
    for (int k = 0; k < size; ++k)
    {
      seeds(points[first + k], k) = 1.0;
    }
    distances.middleCols(first, size) = geodesics->Distances(seeds);
    progress(0.1 + 0.9 * (first + size) / count);
  }
  return distances;
}

} // namespace shape
