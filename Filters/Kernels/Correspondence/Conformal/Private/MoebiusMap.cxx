#include "Correspondence/Conformal/Private/MoebiusMap.h"

#include <Eigen/LU>

#include <cmath>

namespace shape
{
namespace
{

/// Returns the matrix that takes (1 : 0), (0 : 1) and (1 : 1) to three points.
/// The columns of the frame are the first two points, each scaled so that their sum is the third.
Eigen::Matrix2cd Frame(const ComplexPoints& points)
{
  Eigen::Matrix2cd frame = points.topRows(2).transpose();
  const Eigen::Vector2cd shares = frame.inverse() * points.row(2).transpose();
  return frame * shares.asDiagonal();
}

} // namespace

ComplexPoints ToComplexPoints(const Eigen::MatrixXd& sphere)
{
  ComplexPoints points(sphere.rows(), 2);
  for (Eigen::Index i = 0; i < sphere.rows(); ++i)
  {
    const std::complex<double> across(sphere(i, 0), sphere(i, 1));
    const double up = sphere(i, 2);
    // (x + i y : 1 - z) and (1 + z : x - i y) are the same point of the projective line. The first
    // vanishes at the north pole, the second at the south pole.
    if (up < 0.0)
    {
      points.row(i) << across, 1.0 - up;
    }
    else
    {
      points.row(i) << 1.0 + up, std::conj(across);
    }
  }
  points.rowwise().normalize();
  return points;
}

Eigen::MatrixXd ToSphere(const ComplexPoints& points)
{
  Eigen::MatrixXd sphere(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const std::complex<double> one = points(i, 0), other = points(i, 1);
    const std::complex<double> across = 2.0 * one * std::conj(other);
    sphere.row(i) << across.real(), across.imag(), std::norm(one) - std::norm(other);
    sphere.row(i) /= std::norm(one) + std::norm(other);
  }
  return sphere;
}

Eigen::Matrix2cd SolveMoebiusTransform(const ComplexPoints& from, const ComplexPoints& to)
{
  Eigen::Matrix2cd moebius = Frame(to) * Frame(from).inverse();
  // Determinant 1 keeps the entries in range. A transform is defined up to a factor.
  return moebius / std::sqrt(moebius.determinant());
}

ComplexPoints ApplyMoebiusTransform(const ComplexPoints& points, const Eigen::Matrix2cd& moebius)
{
  return points * moebius.transpose();
}

Eigen::VectorXd ComputeLogAreaScales(const ComplexPoints& points, const Eigen::Matrix2cd& moebius)
{
  // For a unit vector p, a matrix M stretches lengths on the sphere by |det M| / |M p|^2, and areas
  // by the square of that.
  const Eigen::ArrayXd lengths =
    ApplyMoebiusTransform(points, moebius).rowwise().squaredNorm().array();
  return 2.0 * (std::log(std::abs(moebius.determinant())) - lengths.log());
}

} // namespace shape
