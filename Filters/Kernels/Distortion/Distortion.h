#pragma once

#include <Eigen/Core>

namespace shape
{

/// Distortion measures of an affine map with singular values s > 0: two in the plane (d = 2), three
/// in space (d = 3). A sum over s has one term for each, and e is an exponent. See table 1 of
/// Rabinovich, Poranne, Panozzo and Sorkine-Hornung, "Scalable locally injective mappings", 2017.
enum class Distortion
{
  SymmetricDirichlet,            ///< sum of s^2 + s^-2; minimum 2 d for an isometry
  ExponentialSymmetricDirichlet, ///< exp(e SymmetricDirichlet): dominated by the worst simplices
  /// exp(e (c + a / 2)) with a = (D + 1 / D) / 2, D the product of all s, and c the conformal part:
  /// (s1 / s2 + s2 / s1) / 2 in the plane, (sum of s^2 times sum of s^-2 - 1) / 8 in space (Fu, Liu
  /// and Guo, "Computing locally injective mappings by advanced MIPS", 2015)
  AMIPS,
  ConformalAMIPS, ///< sum of s^2 / D^(2 / d); minimum d for a similarity
  Hencky,         ///< sum of log(s)^2 (Hencky strain): 0 for an isometry
  ARAP            ///< sum of (s - 1)^2: 0 for an isometry; finite even for an image without size
};

/// Whether a measure is the exponential of another measure. Such a measure overflows if the
/// distortion is large.
bool IsExponential(Distortion distortion);

/// A measure at given singular values, and a quadratic function with the same gradient there: the
/// sum of Weights (s - c)^2 over all s. Here c is 1, except for two measures. For ConformalAMIPS, c
/// is the root mean square of all s. For AMIPS, c is the s that minimises the measure while the
/// other singular values are fixed.
template <int Dimension>
struct DistortionTerms
{
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  double Value;
  Vector Gradient; ///< derivatives with respect to each s
  Vector Weights;  ///< > 0: Gradient / (2 (s - c)), or the limit of this at s = c
};

/// Evaluates a measure; Dimension is 2 or 3. singular: all s, each > 0. exponent: the e of an
/// exponential measure. Values that overflow are infinite.
template <int Dimension>
DistortionTerms<Dimension> EvaluateDistortion(
  Distortion distortion, double exponent, const Eigen::Matrix<double, Dimension, 1>& singular);

} // namespace shape
