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
  /// Whether one angle for all samples is enough, for example while the shape is being dragged.
  bool SingleAngle = false;
  /// The maximum number of line searches for the single angle, and the maximum number for the
  /// samples' angles; >= 0.
  int LineSearches = 5;
  /// In degrees. The optimisation stops when a line search reduces the sum of the angles between
  /// the samples' normals and the wanted ones by less than this.
  double Enough = 2.0;
  /// The distance from the handle up to which the shape is computed, in the model's units. The
  /// shape's normals at the handle must not depend on points beyond it.
  double Reach = 0.0;
};

struct BoundaryNormalsResult
{
  HandlePose Pose;        ///< the given pose with rotated frames
  Eigen::VectorXd Angles; ///< s values in radians: see RotateAboutTangents
  /// ComputeMeanAngle between the shape's normals and the wanted ones before the optimisation, in
  /// degrees.
  double Before = 0.0;
  double After = 0.0; ///< the same angle after the optimisation
  int LineSearches = 0;
};

/// Estimates the normals of a deformed shape at the samples of its handle (s x 3, unit or zero).
using NormalsOfShape = std::function<Eigen::MatrixXd(const DeformedShape&)>;

/**
 * Rotates the frames of a posed handle to give the shape the wanted normals there: equation 12 of
 * Schmidt and Singh, "Drag-and-drop surface composition" (Graphics Interface 2010), section 4.1.
 * Frames rotate about the curve's tangent: first all by one angle, then each by its own angle. Each
 * step is a multiple of the signed angles that are still missing, smoothed along the curves. The
 * multiple follows from the share of these angles that the previous step corrected. The sum of |1 -
 * N . n| over the samples never increases.
 *
 * handle: the curves for which `deformation` was prepared. wanted: s x 3, the wanted unit normals;
 * a zero row means that any normal is allowed there. Throws InvalidInput if sizes differ; Aborted.
 */
BoundaryNormalsResult OptimizeBoundaryNormals(const ShapeDeformation& deformation,
  const BoundaryHandle& handle, const HandlePose& pose, const Eigen::MatrixXd& wanted,
  const NormalsOfShape& normals, const BoundaryNormalsOptions& options = {},
  const Progress& progress = {});

/// Returns the mean angle in degrees between two fields of unit normals (s x 3). Rows in which a
/// normal is zero are left out; if no row is left, the result is 0.
double ComputeMeanAngle(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

} // namespace shape
