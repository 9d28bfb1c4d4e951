#pragma once

#include <Eigen/Core>

namespace shape
{

/// Distortion measures of an affine map of the plane with singular values s1 >= s2 > 0. A sum over
/// s has one term for s1 and one for s2, and e is an exponent. See table 1 of Rabinovich, Poranne,
/// Panozzo and Sorkine-Hornung, "Scalable locally injective mappings", 2017.
enum class Distortion
{
  SymmetricDirichlet,            ///< sum of s^2 + s^-2; minimum 4 for an isometry
  ExponentialSymmetricDirichlet, ///< exp(e SymmetricDirichlet): dominated by the worst triangles
  /// exp(e ((s1 / s2 + s2 / s1) / 2 + (s1 s2 + 1 / (s1 s2)) / 4)) (Fu, Liu and Guo, "Computing
  /// locally injective mappings by advanced MIPS", 2015)
  AMIPS,
  ConformalAMIPS, ///< s1 / s2 + s2 / s1; minimum 2 for a similarity
  LogARAP,        ///< sum of log(s)^2 (Hencky strain): 0 for an isometry
  ARAP            ///< sum of (s - 1)^2: 0 for an isometry; finite even for an image without area
};

/// Whether a measure is the exponential of another measure. Such a measure overflows if the
/// distortion is large.
bool IsExponential(Distortion distortion);

/// A measure at given singular values, and a quadratic function with the same gradient there: the
/// sum of Weights (s - c)^2 over s = s1, s2. Here c is 1, except for two measures. For
/// ConformalAMIPS, c is the geometric mean of s1 and s2. For AMIPS, c is the s that minimises the
/// measure while the other singular value is fixed.
struct DistortionTerms
{
  double Value;
  Eigen::Vector2d Gradient; ///< derivatives with respect to s1 and s2
  Eigen::Vector2d Weights;  ///< > 0: Gradient / (2 (s - c)), or the limit of this at s = c
};

/// Evaluates a measure. singular: s1 and s2, both > 0. exponent: the e of an exponential measure.
/// Values that overflow are infinite.
DistortionTerms EvaluateDistortion(
  Distortion distortion, double exponent, const Eigen::Vector2d& singular);

} // namespace shape
