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
  /// Whether one angle for all samples is enough: for a shape that is being dragged.
  bool SingleAngle = false;
  /// The maximum number of line searches for the single angle, and again for the samples' angles;
  /// >= 0.
  int LineSearches = 5;
  /// The search ends when one gains less than this: in degrees, summed over the samples.
  double Enough = 2.0;
  /// The distance from the handle up to which the shape is computed, in the model's units: as far
  /// as its normals at the handle depend on it.
  double Reach = 0.0;
};

struct BoundaryNormalsResult
{
  HandlePose Pose;        ///< the given one, its frames rotated
  Eigen::VectorXd Angles; ///< s, radians: see RotateAboutTangents
  double Before = 0.0; ///< ComputeMeanAngle in degrees between the shape's normals and the wanted
  double After = 0.0;  ///< ones, before and after
  int LineSearches = 0;
};

/// Estimates the normals of a deformed shape at the samples of its handle (s x 3, unit or zero).
using NormalsOfShape = std::function<Eigen::MatrixXd(const DeformedShape&)>;

/**
 * Rotates the frames of a posed handle so that the shape has the wanted normals there: equation 12
 * of Schmidt and Singh, "Drag-and-drop surface composition" (Graphics Interface 2010), section 4.1.
 * Each frame rotates about the curve's tangent; first all by one angle, then each by its own. A
 * step goes along the missing signed angles, smoothed along the curves; its length follows from the
 * share of them that it corrects. The sum of |1 - N . n| over the samples never increases.
 *
 * handle: curves, for which `deformation` was prepared. wanted: s x 3, unit, or zero for any
 * normal. Throws InvalidInput if sizes differ, Aborted.
 */
BoundaryNormalsResult OptimizeBoundaryNormals(const ShapeDeformation& deformation,
  const BoundaryHandle& handle, const HandlePose& pose, const Eigen::MatrixXd& wanted,
  const NormalsOfShape& normals, const BoundaryNormalsOptions& options = {},
  const Progress& progress = {});

/// The mean angle in degrees between two fields of unit normals (s x 3) over the rows of which
/// neither is zero; 0 if there are none.
double ComputeMeanAngle(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

} // namespace shape
