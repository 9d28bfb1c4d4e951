#include "Harmonic/ChargeSet.h"

#include "Base/Parallel.h"
#include "Fmm/DirectSummation.h"
#include "Fmm/FmmSummation.h"

#include <algorithm>
#include <cmath>

namespace shape
{

namespace
{

constexpr double InverseFourPi = 0.25 / M_PI;
/// Returns the relative tolerance of a sum that keeps the given error, in units of the image's
/// size. Large charges of alternating sign, whose potentials cancel, need a smaller tolerance. It
/// is estimated from 64 positions near the charges, so it does not depend on the points.
double ToleranceFor(const ChargeSet& set, double error)
{
  constexpr int count = 64;
  const Eigen::RowVector3d middle = set.Points.colwise().mean();
  Eigen::MatrixXd positions(count, 3);
  for (int i = 0; i < count; ++i)
  {
    // A little inside the charges, which surround the domain.
    positions.row(i) = 0.95 * set.Points.row(i * set.Points.rows() / count) + 0.05 * middle;
  }
  const Eigen::MatrixXd image = SumPotentialsDirectly(set.Points, set.Charges, positions) +
    positions * set.Affine.leftCols<3>().transpose();
  const double size = (image.colwise().maxCoeff() - image.colwise().minCoeff()).maxCoeff();
  const Eigen::MatrixXd absolute =
    SumPotentialsDirectly(set.Points, set.Charges.cwiseAbs(), positions);
  return error * size / absolute.maxCoeff();
}

/// Sums over the charges: directly, or by the multipole method if it is faster and keeps the error.
Eigen::MatrixXd Sums(const ChargeSet& set, const Eigen::MatrixXd& points, bool gradients,
  double error, Eigen::Index allPoints, const SumDevice& device, const Progress& progress)
{
  constexpr double worthATry = 1e8; // below it the multipole method is not faster
  const double pairs = static_cast<double>(set.Points.rows()) *
    static_cast<double>(std::max(points.rows(), allPoints));
  if (pairs > worthATry && points.allFinite())
  {
    const double tolerance = ToleranceFor(set, error);
    if (tolerance >= FmmSummationOptions::MinimumTolerance)
    {
      FmmSummationOptions options;
      // 1e-3 is the loosest grade of FmmSummation; tolerances above 0.1 are rejected.
      options.Tolerance = std::min(tolerance, 1e-3);
      options.AllPoints = allPoints;
      options.Device = device;
      const FmmSummation fast(set.Points, points, options, progress.Part(0.0, 0.3));
      return gradients ? fast.Gradients(set.Charges, progress.Part(0.3, 1.0))
                       : fast.Potentials(set.Charges, progress.Part(0.3, 1.0));
    }
  }
  return gradients
    ? SumGradientsDirectly(set.Points, set.Charges, points, progress, device)
    : SumPotentialsDirectly(set.Points, set.Charges, points, RootError::Rounding, progress, device);
}

} // namespace

Eigen::MatrixXd Evaluate(const ChargeSet& set, const Eigen::MatrixXd& points,
  const Progress& progress, double error, Eigen::Index allPoints, const SumDevice& device)
{
  Eigen::MatrixXd values = Sums(set, points, false, error, allPoints, device, progress);
  values += points.lazyProduct(set.Affine.leftCols<3>().transpose());
  values.rowwise() += set.Affine.col(3).transpose();
  return values;
}

Eigen::MatrixXd EvaluateJacobians(const ChargeSet& set, const Eigen::MatrixXd& points,
  const Progress& progress, const SumDevice& device)
{
  // The same error as the default of Evaluate.
  constexpr double error = 1e-10;
  Eigen::MatrixXd values = Sums(set, points, true, error, 0, device, progress);
  for (int r = 0; r < 3; ++r)
  {
    for (int c = 0; c < 3; ++c)
    {
      values.col(3 * r + c).array() += set.Affine(r, c);
    }
  }
  return values;
}

Eigen::Matrix3d GetJacobian(const Eigen::MatrixXd& jacobians, Eigen::Index i)
{
  Eigen::Matrix3d square;
  square << jacobians.block<1, 3>(i, 0), jacobians.block<1, 3>(i, 3), jacobians.block<1, 3>(i, 6);
  return square;
}

/// The coefficient matrix A_uv = K(P_u, Q_v) of Li et al. 2010, section 3.3, step 2 (K: eq. 1).
Eigen::MatrixXd BuildPotentialMatrix(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& sources, const Progress& progress)
{
  Eigen::MatrixXd matrix(points.rows(), sources.rows());
  ParallelFor(
    static_cast<int>(sources.rows()), 8,
    [&](int begin, int end)
    {
      for (int j = begin; j < end; ++j)
      {
        matrix.col(j) = InverseFourPi *
          ((points.col(0).array() - sources(j, 0)).square() +
            (points.col(1).array() - sources(j, 1)).square() +
            (points.col(2).array() - sources(j, 2)).square())
            .rsqrt();
      }
    },
    progress);
  return matrix;
}

} // namespace shape
