#pragma once

#include "Mesh/Mesh.h"

#include <string>
#include <vector>

// Models and boundary data of the benchmarks.
namespace benchmark
{

/// A surface in OFF format, its polygons cut into triangles, points at the same place joined where
/// `weld` is set, in a box of longest side 1 around the origin. Throws std::runtime_error.
shape::Mesh ReadOff(const std::string& path, bool weld);

/// Each triangle in three: its centroid joined with its corners, old edges flipped, old points
/// smoothed (Kobbelt, "Sqrt(3)-subdivision", 2000). For closed surfaces.
shape::Mesh Subdivide(const shape::Mesh& mesh);

/// Each triangle in four, at the middles of its edges. values (n x d), of the points; returns those
/// of the new points, with means at the middles.
Eigen::MatrixXd Split(Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values);

/// Positions in triangles: count x 3 positions with the triangle and the barycentric coordinates.
struct TrianglePositions
{
  std::vector<int> Triangles;
  Eigen::MatrixXd Weights;
  Eigen::MatrixXd Points;
};

/// Evenly distributed over each triangle, as many in each: at most `most` in all, of triangles
/// drawn at random where there are more.
TrianglePositions SampleRandomly(const shape::Mesh& mesh, int each, int maximum, unsigned int seed);

/// What values at the points of `mesh` (n x 3) are at the places, linear in each triangle.
Eigen::MatrixXd Interpolated(
  const shape::Mesh& mesh, const Eigen::MatrixXd& values, const TrianglePositions& positions);

/// `count` points evenly distributed inside a closed, outward facing surface: where the signed
/// distance says so, and with `winding` also the winding number: once inside one that crosses
/// itself.
Eigen::MatrixXd InteriorPoints(
  const shape::Mesh& mesh, int count, unsigned int seed, bool winding = false);

/**
 * Data A: a map that is harmonic in and around the solid, known everywhere: the identity, harmonic
 * polynomials of degree 1 to 4 ((a . y)^d with complex a, a . a = 0; two of each degree for each
 * coordinate) and 8 point charges outside, between 0.2 and 0.5 of the size from the surface.
 */
class HarmonicField
{
public:
  HarmonicField(const shape::Mesh& mesh, unsigned int seed);
  Eigen::MatrixXd Evaluate(const Eigen::MatrixXd& points) const;

private:
  Eigen::MatrixXd Polynomials; ///< one a row: Re a, Im a, weight; degrees and coordinates by turns
  Eigen::MatrixXd ChargePositions;
  Eigen::MatrixXd Charges;
};

/// Data C: a smooth map that is not harmonic: a twist about x, a bend and a dent.
Eigen::MatrixXd Deformed(const Eigen::MatrixXd& points);

/// Data B: the sphere map of a surface by shape::Parameterize, kept in the file `cache`.
Eigen::MatrixXd MapToSphere(const shape::Mesh& mesh, const std::string& cache);

} // namespace benchmark
