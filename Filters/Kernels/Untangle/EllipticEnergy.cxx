#include "Untangle/EllipticEnergy.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

constexpr double ShapeFactor = (1.0 - EllipticEnergy::VolumeShare) / 3.0;

} // namespace

Eigen::Matrix<double, 4, 3> ComputeHatGradients(const Eigen::Matrix3d& edges)
{
  Eigen::Matrix<double, 4, 3> gradients;
  gradients.bottomRows<3>() = edges.inverse();
  gradients.row(0) = -gradients.bottomRows<3>().colwise().sum();
  return gradients;
}

namespace
{

/// root: sqrt(determinant^2 + epsilon^2).
double ComputeChi(double determinant, double epsilon, double root)
{
  // Without cancellation on either side.
  return determinant > 0.0 ? 0.5 * (determinant + root)
                           : 0.5 * epsilon * (epsilon / (root - determinant));
}

} // namespace

double EllipticEnergy::Chi(double determinant, double epsilon)
{
  return ComputeChi(determinant, epsilon, std::hypot(determinant, epsilon));
}

double EllipticEnergy::EpsilonFor(double determinant, double chi, double minimum)
{
  // chi is the positive root of chi^2 - D chi = epsilon^2 / 4.
  return determinant < chi ? std::max(2.0 * std::sqrt(chi * (chi - determinant)), minimum)
                           : minimum;
}

EllipticEnergy::EllipticEnergy(const Eigen::Matrix3d& jacobian, double epsilon)
  : J(jacobian)
{
  this->C.col(0) = jacobian.col(1).cross(jacobian.col(2));
  this->C.col(1) = jacobian.col(2).cross(jacobian.col(0));
  this->C.col(2) = jacobian.col(0).cross(jacobian.col(1));
  this->D = jacobian.col(0).dot(this->C.col(0));
  const double length = std::hypot(this->D, epsilon);
  this->X = ComputeChi(this->D, epsilon, length);
  this->Slope = this->X / length;
  const double root = std::cbrt(this->X);
  this->Power = 1.0 / (root * root);
}

double EllipticEnergy::Value() const
{
  // The shape term and the volume term, each 1 - t and t for a rotation.
  return ShapeFactor * this->J.squaredNorm() * this->Power +
    0.5 * VolumeShare * (this->D * this->D + 1.0) / this->X;
}

Eigen::Matrix3d EllipticEnergy::Gradient() const
{
  // The chain rule over |J|^2, chi(D) and D(J), whose gradients are 2 J, Slope and the cofactors C.
  const double byChi = -(2.0 / 3.0) * ShapeFactor * this->J.squaredNorm() * this->Power / this->X -
    0.5 * VolumeShare * (this->D * this->D + 1.0) / (this->X * this->X);
  const double byDeterminant = byChi * this->Slope + VolumeShare * this->D / this->X;
  return (2.0 * ShapeFactor * this->Power) * this->J + byDeterminant * this->C;
}

EllipticEnergy::Curvature EllipticEnergy::SecondDerivative() const
{
  // The second derivatives of both terms as functions of J, D and chi, with dchi = Slope dD and dD
  // = C : dJ. The curvature of chi and of D, which may be negative, is left out.
  const double s = this->Slope / this->X; // derivative of log chi by D
  const double d = this->D;
  return { 2.0 * ShapeFactor * this->Power, -(4.0 / 3.0) * ShapeFactor * this->Power * s,
    (10.0 / 9.0) * ShapeFactor * this->J.squaredNorm() * this->Power * s * s +
      VolumeShare / this->X * (1.0 - 2.0 * d * s + (d * d + 1.0) * s * s) };
}

} // namespace shape
