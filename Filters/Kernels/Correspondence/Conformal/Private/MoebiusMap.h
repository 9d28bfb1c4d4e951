#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>

namespace shape
{

/// Points of the unit sphere as points of the complex projective line, n x 2. Each row is a
/// multiple of (z, 1), where z is the stereographic projection from the north pole; the north pole
/// itself is (1, 0). No precision is lost near either pole.
using ComplexPoints = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 2>;

/// Converts unit vectors (n x 3) to complex points. The rows of the result have length 1.
ComplexPoints ToComplexPoints(const Eigen::MatrixXd& sphere);

/// Converts complex points to unit vectors (n x 3). Rows may have any length except 0.
Eigen::MatrixXd ToSphere(const ComplexPoints& points);

/**
 * Computes the Moebius map of the sphere that takes three given points to three other given points.
 * It is the unique orientation-preserving conformal map that does so (Lipman and Funkhouser,
 * "Moebius voting for surface correspondence", 2009, section 3). The image of a point, written as a
 * column, is the returned matrix times this column. from, to: three distinct points each. If two
 * nearly coincide, the result is not finite.
 */
Eigen::Matrix2cd SolveMoebiusTransform(const ComplexPoints& from, const ComplexPoints& to);

/// Returns the images of the points under a Moebius map.
ComplexPoints ApplyMoebiusTransform(const ComplexPoints& points, const Eigen::Matrix2cd& moebius);

/// Returns the logarithm of a Moebius map's area scale on the sphere at each point (n values). The
/// rows of `points` have length 1.
Eigen::VectorXd ComputeLogAreaScales(const ComplexPoints& points, const Eigen::Matrix2cd& moebius);

} // namespace shape
