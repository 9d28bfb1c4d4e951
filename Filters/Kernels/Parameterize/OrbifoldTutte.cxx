#include "Parameterize/OrbifoldTutte.h"

#include "Base/Errors.h"
#include "Laplacian/CotangentWeights.h"
#include "Linear/SparseSolve.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/Surface.h"
#include "Parameterize/OrbifoldInput.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace shape
{
namespace
{

using Complex = std::complex<double>;

/// The minimum weight of an edge: with positive weights nothing flips.
constexpr double MinimumWeight = 1e-2;

void RequireConeCount(const std::vector<int>& cones, OrbifoldType type)
{
  if (static_cast<int>(cones.size()) != GetConeCount(type))
  {
    throw InvalidInput("the orbifold has " + std::to_string(GetConeCount(type)) + " cones, but " +
      std::to_string(cones.size()) + " are given; give 3 or 4 Landmarks");
  }
}

/// Position of a point of the cut surface: the isometry of an unknown, or a given position.
struct Position
{
  int Unknown = -1;
  PlaneIsometry Motion; ///< applied to the unknown; if there is none, Shift is the position
};

/// Returns the positions of the cut surface's points, and the number of unknowns.
std::pair<std::vector<Position>, int> GetLoopPositions(
  const CutSurface& cut, const EdgePath& path, const OrbifoldTile& tile)
{
  // The boundary follows the path to its end and returns.
  std::vector<int> loop = FindManifoldBoundaryLoops(cut.Surface).front();
  std::rotate(loop.begin(),
    std::find_if(loop.begin(), loop.end(),
      [&](int point) { return cut.Provenance.Points(point) == path.Points.front(); }),
    loop.end());
  std::vector<Position> positions(cut.Surface.Points.rows());
  std::vector<char> isDone(positions.size(), 0);
  const auto count = static_cast<int>(loop.size());
  const auto twin = [&](int i) { return loop[(count - i) % count]; };
  const auto last = static_cast<int>(path.Stops.size()) - 1;
  for (int stop = 0; stop <= last; ++stop)
  {
    const int i = path.Stops[stop];
    positions[loop[i]].Motion = { 0.0, tile.There[stop] };
    positions[twin(i)].Motion = { 0.0, tile.Back[stop] };
    isDone[loop[i]] = isDone[twin(i)] = 1;
  }
  int unknowns = 0;
  for (int stop = 0; stop < last; ++stop)
  {
    for (int i = path.Stops[stop] + 1; i < path.Stops[stop + 1]; ++i)
    {
      positions[loop[i]] = { unknowns, {} };
      positions[twin(i)] = { unknowns++, tile.Legs[stop] };
      isDone[loop[i]] = isDone[twin(i)] = 1;
    }
  }
  for (std::size_t point = 0; point < positions.size(); ++point)
  {
    if (isDone[point] == 0)
    {
      positions[point] = { unknowns++, {} };
    }
  }
  return { std::move(positions), unknowns };
}

/// Minimizes the sum of w |p - q|^2 / 2 over the edges of all triangles.
class MeanEquations
{
public:
  explicit MeanEquations(int unknowns)
    : Right(Eigen::VectorXd::Zero(2 * unknowns))
  {
  }

  /// Adds the derivatives of w |p - q|^2 / 2 with respect to p and q.
  void AddSide(const Position& p, const Position& q, double weight)
  {
    this->AddHalf(p, q, weight);
    this->AddHalf(q, p, weight);
  }

  /// Returns the positions of the unknowns.
  std::vector<Complex> Solve(const Progress& progress)
  {
    if (this->Right.size() == 0)
    {
      return {}; // a tetrahedron whose points are all cones
    }
    Eigen::SparseMatrix<double> matrix(this->Right.size(), this->Right.size());
    matrix.setFromTriplets(this->Entries.begin(), this->Entries.end());
    SparseCholesky solver;
    solver.Factorize(matrix, progress.Part(0.2, 1.0));
    const Eigen::VectorXd solution = solver.Solve(this->Right);
    std::vector<Complex> unknowns;
    for (Eigen::Index i = 0; i < solution.size(); i += 2)
    {
      unknowns.emplace_back(solution(i), solution(i + 1));
    }
    return unknowns;
  }

private:
  void AddHalf(const Position& p, const Position& q, double weight)
  {
    if (p.Unknown < 0)
    {
      return;
    }
    // With p = Turn z + Shift the derivative by z is conj(Turn) w (p - q).
    const Complex back = weight * std::conj(p.Motion.Turn);
    this->AddBlock(p.Unknown, p.Unknown, weight);
    if (q.Unknown >= 0)
    {
      this->AddBlock(p.Unknown, q.Unknown, -back * q.Motion.Turn);
    }
    const Complex right = back * (q.Motion.Shift - p.Motion.Shift);
    this->Right(2 * p.Unknown) += right.real();
    this->Right(2 * p.Unknown + 1) += right.imag();
  }

  /// Returns the multiplication by a complex number as a real matrix.
  void AddBlock(int row, int column, Complex factor)
  {
    this->Entries.emplace_back(2 * row, 2 * column, factor.real());
    this->Entries.emplace_back(2 * row + 1, 2 * column + 1, factor.real());
    if (factor.imag() != 0.0)
    {
      this->Entries.emplace_back(2 * row, 2 * column + 1, -factor.imag());
      this->Entries.emplace_back(2 * row + 1, 2 * column, factor.imag());
    }
  }

  std::vector<Eigen::Triplet<double>> Entries;
  Eigen::VectorXd Right;
};

} // namespace

OrbifoldImage MapToOrbifold(const Surface& surface, const std::vector<int>& cones,
  OrbifoldType type, const Progress& progress)
{
  progress(0.0);
  // Outline (Aigerman and Lipman 2015):
  // 1. The surface is cut along a path through the cones, which makes it a disk.
  // 2. Cones have given positions. A point on the cut has two copies: one is an unknown, the other
  //    is its image under the leg's isometry.
  // 3. The Dirichlet energy of all edges, with positive cotangent weights, gives the equations of
  //    the weighted means.
  // 4. The solution, checked with exact predicates.
  RequireOrbifoldInput(surface, cones);
  RequireConeCount(cones, type);
  OrbifoldImage image;
  image.Cones = cones;
  image.Tile = BuildOrbifoldTile(type);
  // Step 1: the cut.
  const EdgePath path =
    FindEdgePathThrough(surface, cones, progress.Part(0.1, 0.2, "cutting the surface"));
  std::vector<std::array<int, 2>> edges;
  for (std::size_t i = 1; i < path.Points.size(); ++i)
  {
    edges.push_back({ path.Points[i - 1], path.Points[i] });
  }
  image.Cut = CutAlongEdges(surface, edges);
  progress(0.3);

  // Step 2: the unknowns.
  const auto [positions, unknowns] = GetLoopPositions(image.Cut, path, image.Tile);
  // Step 3: the equations.
  const Eigen::MatrixXi& triangles = surface.Triangles();
  const Eigen::SparseMatrix<double> weights =
    BuildPositiveStiffness(BuildCotangentStiffness(triangles,
                             ComputeTriangleAngles(surface).Cotangents, surface.Points().rows()),
      MinimumWeight);
  MeanEquations equations(unknowns);
  constexpr int often = 1 << 15; // triangles between reports
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    if (t % often == 0)
    {
      progress(0.3 + 0.1 * static_cast<double>(t) / static_cast<double>(triangles.rows()));
    }
    for (int corner = 0; corner < 3; ++corner)
    {
      const int next = (corner + 1) % 3;
      // One half from each of the edge's triangles.
      equations.AddSide(positions[image.Cut.Surface.Triangles(t, corner)],
        positions[image.Cut.Surface.Triangles(t, next)],
        -0.5 * weights.coeff(triangles(t, corner), triangles(t, next)));
    }
  }
  // Step 4: the solution.
  const std::vector<Complex> solution = equations.Solve(progress.Part(0.4, 0.9));
  image.Points.resize(static_cast<Eigen::Index>(positions.size()), 2);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    const Position& position = positions[i];
    const Complex z =
      position.Unknown >= 0 ? position.Motion(solution[position.Unknown]) : position.Motion.Shift;
    image.Points.row(static_cast<Eigen::Index>(i)) << z.real(), z.imag();
  }
  RequireUnflippedTile(image.Cut.Surface, image.Points);
  progress(1.0);
  return image;
}

Eigen::MatrixXd FitToBestParallelogram(const OrbifoldImage& image)
{
  // The Dirichlet energy of the image under a linear map T is trace(T D T'). With det T = 1 it is
  // minimal if T D T' is a multiple of the identity.
  const Mesh& cut = image.Cut.Surface;
  const Eigen::SparseMatrix<double> stiffness = BuildCotangentStiffness(
    cut.Triangles, ComputeTriangleAngles(cut).Cotangents, cut.Points.rows());
  const Eigen::Matrix2d energy = image.Points.transpose() * stiffness * image.Points;
  const Eigen::Matrix2d factor = energy.llt().matrixL();
  // With D = L L', T is proportional to L^-1, which preserves the direction of y.
  const Eigen::Matrix2d straight = std::sqrt(factor.determinant()) * factor.inverse();
  return image.Points * straight.transpose();
}

} // namespace shape
