#include "Harmonic/LinearVolumeMap.h"

#include "Base/Errors.h"
#include "Distance/SignedDistance.h"
#include "Harmonic/HarmonicMapTypes.h"
#include "Harmonic/NearSurfaceCharges.h"
#include "Harmonic/Private/ScaledBoundary.h"

#include <Eigen/Cholesky>

#include <cmath>
#include <sstream>
#include <string>

namespace shape
{

namespace
{

void RequireRows(
  const Eigen::MatrixXd& values, Eigen::Index rows, Eigen::Index columns, const std::string& name)
{
  if (values.rows() != rows || values.cols() != columns)
  {
    throw InvalidInput(name + " has " + std::to_string(values.rows()) + " rows of " +
      std::to_string(values.cols()) + " numbers; give " + std::to_string(rows) + " rows of " +
      std::to_string(columns));
  }
  RequireFinite(values, name);
}

Eigen::MatrixXd WithOnes(const Eigen::MatrixXd& points)
{
  return points.rowwise().homogeneous();
}

} // namespace

ChargeGradient ComputeChargeGradient(const ChargeSet& map, const Eigen::MatrixXd& points,
  const Eigen::MatrixXd& byImages, const Eigen::MatrixXd& byJacobians, const Progress& progress)
{
  RequireRows(points, points.rows(), 3, "the list of points");
  RequireRows(byImages, points.rows(), 3, "the derivative by images");
  ChargeGradient gradient;
  gradient.Affine = byImages.transpose() * WithOnes(points);
  ChargeSet swept{ points, byImages };
  swept.Affine.setZero();
  const bool hasJacobians = byJacobians.size() > 0;
  gradient.Charges = Evaluate(swept, map.Points, progress.Part(0.0, hasJacobians ? 0.2 : 1.0));
  if (hasJacobians)
  {
    RequireRows(byJacobians, points.rows(), 9, "the derivative by Jacobians");
    for (int c = 0; c < 3; ++c)
    {
      // A derivative of 1 / |y - x| by y is the opposite of that by x.
      swept.Charges << byJacobians.col(c), byJacobians.col(3 + c), byJacobians.col(6 + c);
      const Eigen::MatrixXd slopes = EvaluateJacobians(
        swept, map.Points, progress.Part(0.2 + c * 0.8 / 3.0, 0.2 + (c + 1) * 0.8 / 3.0));
      for (int r = 0; r < 3; ++r)
      {
        gradient.Charges.col(r) -= slopes.col(3 * r + c);
        gradient.Affine(r, c) += byJacobians.col(3 * r + c).sum();
      }
    }
  }
  progress(1.0);
  return gradient;
}

struct LinearVolumeMap::Parts
{
  LinearVolumeMapOptions Options;
  ScaledBoundary Scaled;
  Eigen::Index Given = 0; ///< number of points of the boundary, unused ones included
  std::unique_ptr<NearSurfaceChargeSystem> System;
  Eigen::MatrixXd AffineFit; ///< 4 x n: computes the transposed affine part from the images

  /// Returns the images at the rows of the system from those at the points.
  Eigen::MatrixXd ToRows(const Eigen::MatrixXd& images) const
  {
    const Eigen::MatrixXi& triangles = this->Scaled.Surface.Triangles();
    Eigen::MatrixXd rows(images.rows() + triangles.rows(), 3);
    rows << images, AverageAtCorners(triangles, images);
    return rows;
  }

  /// The transpose of ToRows.
  Eigen::MatrixXd FromRows(const Eigen::MatrixXd& rows) const
  {
    const Eigen::MatrixXi& triangles = this->Scaled.Surface.Triangles();
    const Eigen::Index n = this->Scaled.Surface.Points().rows();
    Eigen::MatrixXd images = rows.topRows(n);
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    {
      for (const int corner : triangles.row(t))
      {
        images.row(corner) += rows.row(n + t) / 3.0;
      }
    }
    return images;
  }

  GmresOptions IterationOptions(double tolerance) const
  {
    GmresOptions options;
    options.Tolerance = tolerance;
    options.MaximumIterations = this->Options.MaximumIterations;
    return options;
  }

  static void RequireConvergence(const GmresResult& result, double tolerance)
  {
    // A residual near the tolerance is as good: the sums have rounding errors.
    constexpr double slack = 10.0;
    if (!(result.Residuals.maxCoeff() <= slack * tolerance))
    {
      std::ostringstream message;
      message << "the charges do not converge: the residual is " << result.Residuals.maxCoeff()
              << " of the size after " << result.Iterations
              << " iterations; make the boundary's triangles more even with Remesh, or raise "
                 "Tolerance";
      throw SolveFailure(message.str());
    }
  }
};

LinearVolumeMap::~LinearVolumeMap() = default;
LinearVolumeMap::LinearVolumeMap(LinearVolumeMap&&) noexcept = default;
LinearVolumeMap& LinearVolumeMap::operator=(LinearVolumeMap&&) noexcept = default;

LinearVolumeMap::LinearVolumeMap(
  const Surface& boundary, const LinearVolumeMapOptions& options, const Progress& progress)
  : Self(std::make_unique<Parts>())
{
  RequireOption(options.Tolerance > 0.0 && std::isfinite(options.Tolerance), "Tolerance",
    options.Tolerance, "positive and finite");
  RequireOption(options.GradientTolerance > 0.0 && std::isfinite(options.GradientTolerance),
    "GradientTolerance", options.GradientTolerance, "positive and finite");
  RequireOption(
    options.MaximumIterations >= 1, "MaximumIterations", options.MaximumIterations, "at least 1");
  Parts& self = *this->Self;
  self.Options = options;
  self.Given = boundary.Points().rows();
  self.Scaled = ScaleBoundary(boundary, boundary.Points());
  const Surface& surface = self.Scaled.Surface;
  self.System = std::make_unique<NearSurfaceChargeSystem>(std::make_shared<SignedDistance>(surface),
    surface, HarmonicVolumeMapOptions().ChargeDistance, NearSurfaceChargeSystem::Effort::Exact,
    Processes(), SumDevice(), progress);
  // Weighted least squares of affine maps by their normal equations: the box has unit size.
  const Eigen::MatrixXd rows = WithOnes(surface.Points());
  const Eigen::MatrixXd weighted = rows.transpose() * ComputePointAreas(surface).asDiagonal();
  self.AffineFit = Eigen::Matrix4d(weighted * rows).ldlt().solve(weighted);
}

ChargeSet LinearVolumeMap::Fit(const Eigen::MatrixXd& given, const Progress& progress) const
{
  const Parts& self = *this->Self;
  RequireRows(given, self.Given, 3, "the boundary map");
  const ScaledBoundary& scaled = self.Scaled;
  const Eigen::MatrixXd images = given(scaled.Points, Eigen::all);
  // The affine part, then the charges of what is left, in units of the image.
  const Eigen::MatrixXd affine = self.AffineFit * images;
  const double longest = ComputeLongestBoxEdge(images), size = longest > 0.0 ? longest : 1.0;
  const Eigen::MatrixXd left =
    (self.ToRows(images) - WithOnes(self.System->Rows()) * affine) / size;
  const GmresResult fit =
    self.System->SolveAverages(left, self.IterationOptions(self.Options.Tolerance), progress);
  Parts::RequireConvergence(fit, self.Options.Tolerance);
  // The coordinates of the input: y = size * s + origin, for points s of the unit box.
  ChargeSet map;
  map.Points = (self.System->Sources() * scaled.Size).rowwise() + scaled.Origin;
  map.Charges = fit.Solution * (size * scaled.Size);
  map.Affine.leftCols<3>() = affine.topRows<3>().transpose() / scaled.Size;
  map.Affine.col(3) =
    affine.row(3).transpose() - map.Affine.leftCols<3>() * scaled.Origin.transpose();
  return map;
}

Eigen::MatrixXd LinearVolumeMap::Gradient(const Eigen::MatrixXd& points,
  const Eigen::MatrixXd& byImages, const Eigen::MatrixXd& byJacobians,
  const Progress& progress) const
{
  // Outline: the steps of Fit, transposed, in reverse order.
  // 1. The derivatives by the charges and the affine part, in units of the box.
  // 2. The derivative by the rows' residual, by the transposed system.
  // 3. The derivative by the affine part: directly, and through the residual.
  // 4. The derivative by the images.
  const Parts& self = *this->Self;
  const ScaledBoundary& scaled = self.Scaled;
  // Step 1.
  RequireRows(points, points.rows(), 3, "the list of points");
  ChargeSet sources;
  sources.Points = self.System->Sources();
  const ChargeGradient gradient =
    ComputeChargeGradient(sources, (points.rowwise() - scaled.Origin) / scaled.Size, byImages,
      byJacobians / scaled.Size, progress.Part(0.0, 0.2));
  // Step 2.
  const GmresResult swept = self.System->SolveTransposed(gradient.Charges,
    self.IterationOptions(self.Options.GradientTolerance), progress.Part(0.2, 1.0));
  Parts::RequireConvergence(swept, self.Options.GradientTolerance);
  const Eigen::MatrixXd& byRows = swept.Solution;
  // Step 3.
  const Eigen::MatrixXd byAffine =
    gradient.Affine.transpose() - WithOnes(self.System->Rows()).transpose() * byRows;
  // Step 4.
  Eigen::MatrixXd byBoundary = Eigen::MatrixXd::Zero(self.Given, 3);
  byBoundary(scaled.Points, Eigen::all) =
    self.FromRows(byRows) + self.AffineFit.transpose() * byAffine;
  return byBoundary;
}

} // namespace shape
