#include "Correspondence/Conformal/Private/MidEdgeMap.h"

#include "Base/Errors.h"
#include "Laplacian/CotangentWeights.h"
#include "Linear/DirichletProblem.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

namespace shape
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/// Numbers the edges in the order of their first half-edges.
Eigen::MatrixXi NumberEdges(const Surface& surface)
{
  const std::vector<int>& twins = surface.Twins();
  Eigen::MatrixXi edges(surface.Triangles().rows(), 3);
  int count = 0;
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    const int twin = twins[side];
    edges(side / 3, side % 3) = twin < side ? edges(twin / 3, twin % 3) : count++;
  }
  return edges;
}

/// Adds up the differences of the conjugate function across triangles, from edge to edge. The sum
/// around a point is the flux from it: 0, 1 or -1.
void Conjugate(const Surface& surface, const Eigen::MatrixXd& cotangents, const Eigen::VectorXd& u,
  MidEdgeMap& map)
{
  const Eigen::MatrixXi& triangles = surface.Triangles();
  const std::vector<int>& twins = surface.Twins();
  map.Conjugate.setZero(map.Harmonic.size());
  std::vector<char> isReached(map.Harmonic.size(), 0);
  std::vector<int> sides = { 0 }; // half-edges whose edge has a value
  isReached[map.EdgeOf(0, 0)] = 1;
  for (std::size_t next = 0; next < sides.size(); ++next)
  {
    for (const int side : { sides[next], twins[sides[next]] })
    {
      const int t = side / 3;
      double value = map.Conjugate(map.EdgeOf(t, side % 3));
      for (int step = 0; step < 2; ++step)
      {
        // From the midpoint of the edge before corner j to that of the edge behind it. The
        // difference is the flux of the gradient towards j (Pinkall and Polthier, section 4).
        const int i = (side + step) % 3, j = (i + 1) % 3, k = (i + 2) % 3;
        const double ui = u(triangles(t, i)), uj = u(triangles(t, j)), uk = u(triangles(t, k));
        value += 0.5 * (cotangents(t, k) * (uj - ui) + cotangents(t, i) * (uj - uk));
        const int edge = map.EdgeOf(t, j);
        if (!isReached[edge])
        {
          isReached[edge] = 1;
          map.Conjugate(edge) = value;
          sides.push_back(3 * t + j);
        }
      }
    }
  }
}

/// The places of the points: the means of their edges' midpoints.
ComplexPoints Places(const Surface& surface, const MidEdgeMap& map, int from, int to)
{
  const Eigen::Index points = surface.Points().rows();
  Eigen::VectorXd harmonic = Eigen::VectorXd::Zero(points), turns = harmonic, counts = harmonic,
                  first = harmonic;
  for (Eigen::Index t = 0; t < map.EdgeOf.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      // A closed surface has each edge at a point once as an edge that begins there.
      const int point = surface.Triangles()(t, k), edge = map.EdgeOf(t, k);
      first(point) = counts(point) == 0.0 ? map.Conjugate(edge) : first(point);
      const double turn = map.Conjugate(edge) - first(point);
      harmonic(point) += map.Harmonic(edge);
      turns(point) += turn - std::round(turn);
      counts(point) += 1.0;
    }
  }
  ComplexPoints places(points, 2);
  for (Eigen::Index i = 0; i < points; ++i)
  {
    // The square root of z : 1 / the square root of z, which does not overflow at either end.
    const std::complex<double> half =
      Pi * std::complex<double>(harmonic(i) / counts(i), first(i) + turns(i) / counts(i));
    places.row(i) << std::exp(half), std::exp(-half);
  }
  places.row(from) << 0.0, 1.0;
  places.row(to) << 1.0, 0.0;
  places.rowwise().normalize();
  return places;
}

} // namespace

MidEdgeMap FlattenMidEdges(const Surface& surface, int from, int to, const Progress& progress)
{
  if (from == to)
  {
    throw InvalidInput("the source and the sink of the harmonic function are both point " +
      std::to_string(from) + "; give different points");
  }
  const Eigen::Index points = surface.Points().rows();
  const TriangleAngles angles = ComputeTriangleAngles(surface);
  const Eigen::SparseMatrix<double> stiffness =
    BuildCotangentStiffness(surface.Triangles(), angles.Cotangents, points);
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(points, 1), right = u;
  right(to) = 1.0;
  DirichletProblem(stiffness, { from }, progress.Part(0.0, 0.8)).Solve(u, right);
  // The flux fixes the function up to a constant: half of the points go inside the unit circle.
  Eigen::VectorXd sorted = u;
  std::nth_element(sorted.begin(), sorted.begin() + points / 2, sorted.end());
  u.array() -= sorted(points / 2);
  MidEdgeMap map;
  map.EdgeOf = NumberEdges(surface);
  map.Harmonic.resize(map.EdgeOf.maxCoeff() + 1);
  for (Eigen::Index t = 0; t < map.EdgeOf.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      map.Harmonic(map.EdgeOf(t, k)) =
        0.5 * (u(surface.Triangles()(t, k)) + u(surface.Triangles()(t, (k + 1) % 3)));
    }
  }
  Conjugate(surface, angles.Cotangents, u, map);
  map.Points = Places(surface, map, from, to);
  progress(1.0);
  return map;
}

} // namespace shape
