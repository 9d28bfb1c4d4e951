#pragma once

#include "Base/Progress.h"
#include "Deform/BoundaryHandle.h"
#include "Deform/ShapeDeformation.h"

#include <Eigen/Core>

#include <functional>

namespace shape
{

struct BoundaryNormalsOptions
{
  /// Whether one angle, the same for all samples, is enough: for a shape that is being dragged.
  bool SingleAngle = false;
  /// Searches along lines that are made for the single angle, and again for one angle for each
  /// sample, at most; >= 0.
  int LineSearches = 5;
  /// They end where one gains less than this: degrees, summed over the samples.
  double Enough = 2.0;
  /// How far from the handle the shape is computed to find its normals, in the model's units.
  double Reach = 0.0;
};

struct BoundaryNormalsResult
{
  HandlePose Pose;        ///< the given one, turned
  Eigen::VectorXd Angles; ///< s, radians: see RotateAboutTangents
  double Before = 0.0;    ///< degrees between the shape's normals and those wanted: the mean, of
  double After = 0.0;     ///< samples that want one
  int LineSearches = 0;
};

/// Estimates the normals of a deformed shape at the samples of its handle (s x 3, unit or zero).
using NormalsOfShape = std::function<Eigen::MatrixXd(const DeformedShape&)>;

/**
 * Turns the frames of a posed handle until the shape leaves it by the normals wanted there:
 * equation 12 of Schmidt and Singh, "Drag-and-drop surface composition" (Graphics Interface 2010),
 * section 4.1. Each frame turns about the curve's tangent; first all by one angle, then each by its
 * own. A step goes along the signed angles that are missing, smoothed along the curves; how much of
 * them it makes up for tells how long it should be. |1 - N . n|, summed over the samples, never
 * becomes more.
 *
 * handle: curves, as `deformation` was prepared for it. wanted: s x 3, unit, or zero where any will
 * do. Throws InvalidInput where sizes differ, Aborted.
 */
BoundaryNormalsResult OptimizeBoundaryNormals(const ShapeDeformation& deformation,
  const BoundaryHandle& handle, const HandlePose& pose, const Eigen::MatrixXd& wanted,
  const NormalsOfShape& normals, const BoundaryNormalsOptions& options = {},
  const Progress& progress = {});

/// Degrees between two fields of unit normals (s x 3), in the mean over the rows where neither is
/// zero; 0 where there are none.
double ComputeMeanAngle(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

} // namespace shape
