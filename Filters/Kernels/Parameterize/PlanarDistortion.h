#pragma once

#include <Eigen/Core>

namespace shape
{

/// Measures of an affine map of the plane by its singular values s1 >= s2 > 0, as in table 1 of
/// Rabinovich, Poranne, Panozzo and Sorkine-Hornung, "Scalable locally injective mappings", 2017.
enum class Distortion
{
  SymmetricDirichlet,            ///< sum of s^2 + s^-2: 4 for an isometry, the minimum
  ExponentialSymmetricDirichlet, ///< exp(e SymmetricDirichlet): the worst triangles count most
  /// exp(e ((s1 / s2 + s2 / s1) / 2 + (s1 s2 + 1 / (s1 s2)) / 4)) (Fu, Liu and Guo, "Computing
  /// locally injective mappings by advanced MIPS", 2015)
  AMIPS,
  ConformalAMIPS, ///< s1 / s2 + s2 / s1: 2 for a similarity, the minimum
  LogARAP,        ///< sum of log(s)^2 (Hencky strain): 0 for an isometry
  ARAP            ///< sum of (s - 1)^2: 0 for an isometry; finite even if a triangle loses its area
};

/// Whether a measure is the exponential of another one, so large at a bad start that it overflows.
bool IsExponential(Distortion distortion);

/// A measure near given singular values, and the quadratic that stands in for it there: the sum of
/// Weights (s - c)^2 has the same gradient, where c is 1, or for ConformalAMIPS and AMIPS what is
/// best for the other singular value.
struct DistortionTerms
{
  double Value;
  Eigen::Vector2d Gradient; ///< by s1 and s2
  Eigen::Vector2d Weights;  ///< > 0: Gradient / (2 (s - c)), and its limit at s = c
};

/// singular: both > 0. exponent: e above. Values that overflow are infinite.
DistortionTerms EvaluateDistortion(
  Distortion distortion, double exponent, const Eigen::Vector2d& singular);

} // namespace shape
