#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>

namespace shape
{

/// Points of the unit sphere as points of the complex projective line, n x 2: (z : 1) for
/// stereographic projection z from the north pole, without loss near either pole.
using ComplexPoints = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, 2>;

/// sphere: n x 3, of length 1. Rows have length 1.
ComplexPoints ToComplexPoints(const Eigen::MatrixXd& sphere);

/// The way back; rows of any length but 0.
Eigen::MatrixXd ToSphere(const ComplexPoints& points);

/**
 * The Moebius map of the sphere that takes three points to three others: an orientation-preserving
 * conformal map, of which there is just one (Lipman and Funkhouser, "Moebius voting for surface
 * correspondence", 2009, section 3). Points are columns times the matrix. from, to: three rows, no
 * two of which are the same point; where two nearly are, the result is not finite.
 */
Eigen::Matrix2cd SolveMoebiusTransform(const ComplexPoints& from, const ComplexPoints& to);

/// The points' images.
ComplexPoints ApplyMoebiusTransform(const ComplexPoints& points, const Eigen::Matrix2cd& moebius);

/// Logarithms of how much a map enlarges areas on the sphere at points with rows of length 1 (n).
Eigen::VectorXd ComputeLogAreaScales(const ComplexPoints& points, const Eigen::Matrix2cd& moebius);

} // namespace shape
