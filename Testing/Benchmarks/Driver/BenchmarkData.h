#pragma once

#include "Mesh/Mesh.h"

#include <string>
#include <vector>

// Models and boundary data of the benchmarks.
namespace benchmark
{

/// Reads a surface in OFF format and scales it to a box with longest edge 1 around the origin.
/// Polygons are divided into triangles; coincident points are merged if `weld` is set. Throws
/// shape::InvalidInput if it cannot be read or has no polygons.
shape::Mesh ReadOff(const std::string& path, bool weld);

/// Scales a surface to a box with longest edge 1 around the origin.
void ScaleToUnitBox(shape::Mesh& mesh);

/// Divides each triangle into three by its centroid, flips the old edges, and smooths the old
/// points (Kobbelt, "Sqrt(3)-subdivision", 2000). For closed surfaces.
shape::Mesh Subdivide(const shape::Mesh& mesh);

/// Divides each triangle into four at the midpoints of its edges. values (n x d): at the points.
/// Returns the values at the new points, which are means at the midpoints.
Eigen::MatrixXd Split(Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values);

/// Positions in triangles: count x 3 coordinates, with the triangle and the barycentric coordinates
/// of each.
struct TrianglePositions
{
  std::vector<int> Triangles;
  Eigen::MatrixXd Weights;
  Eigen::MatrixXd Points;
};

/// Samples `each` uniformly distributed positions in each triangle. If that exceeds `maximum` in
/// total, samples `maximum` positions in randomly chosen triangles instead.
TrianglePositions SampleRandomly(const shape::Mesh& mesh, int each, int maximum, unsigned int seed);

/// Interpolates values at the points of `mesh` (n x 3) at the given positions, linearly in each
/// triangle.
Eigen::MatrixXd Interpolated(
  const shape::Mesh& mesh, const Eigen::MatrixXd& values, const TrianglePositions& positions);

/// Returns `count` points uniformly distributed inside a closed surface that faces outwards. A
/// point is inside if the signed distance is negative. With `winding` its winding number must also
/// be 1, for a surface that intersects itself.
Eigen::MatrixXd InteriorPoints(
  const shape::Mesh& mesh, int count, unsigned int seed, bool winding = false);

/**
 * Data A: a map that is harmonic in and around the solid and known everywhere. It is a sum of the
 * identity, harmonic polynomials of degree 1 to 4, and the potentials of 8 point charges outside.
 * The polynomials are (a . y)^d with complex a, a . a = 0; two of each degree for each coordinate.
 * The charges are between 0.2 and 0.5 of the size away from the surface.
 */
class HarmonicField
{
public:
  HarmonicField(const shape::Mesh& mesh, unsigned int seed);
  Eigen::MatrixXd Evaluate(const Eigen::MatrixXd& points) const;

private:
  Eigen::MatrixXd Polynomials; ///< a row for each: Re a, Im a, weight; by degree and coordinate
  Eigen::MatrixXd ChargePositions;
  Eigen::MatrixXd Charges;
};

/// Data C: a smooth, non-harmonic map: a twist about x, a bend and a dent.
Eigen::MatrixXd Deformed(const Eigen::MatrixXd& points);

/// Data B: the sphere map of a surface by shape::Parameterize, stored in the file `cache`.
Eigen::MatrixXd MapToSphere(const shape::Mesh& mesh, const std::string& cache);

} // namespace benchmark
