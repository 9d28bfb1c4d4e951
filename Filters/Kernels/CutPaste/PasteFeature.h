#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/PasteTarget.h"
#include "CutPaste/PastedFeature.h"
#include "CutPaste/Seam.h"
#include "Deform/ShapeDeformation.h"
#include "Mesh/Surface.h"
#include "Search/TriangleWalk.h"

#include <Eigen/Core>

#include <memory>

namespace shape
{

struct PasteFeatureOptions
{
  /// Whether the frames at the loop are turned until the feature meets the target smoothly.
  bool OptimizeNormals = true;
  /// Whether one angle for the whole loop is enough, the result is not checked and no smaller scale
  /// is looked for where the feature does not fit: for a feature that is being dragged.
  bool Dragging = false;
};

/// The value that a share (0 to 1) of the values does not exceed; 0 where there are none.
double ComputePercentile(const Eigen::VectorXd& values, double share);

/// A feature prepared for being set down, again and again: see PasteTarget, ShapeDeformation.
class FeatureToPaste
{
public:
  /**
   * feature: any triangles; base: where its loop stood. Throws InvalidInput where the loop is no
   * closed curve of at least 3 points of the feature, crosses itself in the plane or runs
   * clockwise there, or as PrepareDeformation; Aborted.
   */
  FeatureToPaste(const shape::Surface& feature, FeatureFootprint base,
    const DeformOptions& options = {}, const DeformFields& fields = {},
    const Progress& progress = {});

  /**
   * Sets the feature down: its loop is laid on the target (PasteTarget::Land), the feature deformed
   * after it, and the two joined by a band of triangles. Section 4.2 of Schmidt and Singh,
   * "Drag-and-drop surface composition" (Graphics Interface 2010).
   *
   * The result is a 2-manifold where both were; watertight where the target was and the feature has
   * no other loop. Set down where it was cut (Scale 1, no Rotation, on the surface that its base
   * is from) the feature is in its old place. `Scale` multiplies the deformation's.
   *
   * OptimizeNormals turns the frames (OptimizeBoundaryNormals) so that the feature's normals at the
   * loop, of its triangles by their angles, become the target's; then the points near the loop by
   * what is left (SeamNormals, as far as 4 sides of the loop). Where the loop moves as a rigid body
   * the feature keeps the angle at which it stood; as the frames come to differ by 5 degrees, the
   * target's count.
   *
   * Throws as PasteTarget::Land; SolveFailure where the result is not what it must be; Aborted.
   */
  PastedFeature PasteOn(PasteTarget& target, const PastePlacement& placement,
    const PasteFeatureOptions& options = {}, const Progress& progress = {}) const;

  const shape::Surface& Surface() const { return this->Feature; }
  const FeatureFootprint& Base() const { return this->Stand; }
  const ShapeDeformation& Deformation() const { return *this->Prepared; }

private:
  Eigen::MatrixXd Smoothly(HandlePose pose, const Eigen::MatrixXd& normals,
    const PasteFeatureOptions& options, const Progress& progress) const;
  Eigen::MatrixXd LoopNormals(const Eigen::MatrixXd& points) const;
  Eigen::MatrixXd WithMidpoints(const Eigen::MatrixXd& points) const;

  void Check(const PastedFeature& pasted) const;

  shape::Surface Feature;
  FeatureFootprint Stand;
  CutTriangles Cut;  ///< the feature's, at the chords of its loop, so that all can be turned there
  TriangleFans Fans; ///< of these
  BoundaryHandle Handle;
  Eigen::MatrixXd NormalsBefore; ///< at the loop, where the feature was cut
  double NormalReach;            ///< arrival time of the last point that these depend on
  std::unique_ptr<ShapeDeformation> Prepared;
  std::unique_ptr<SeamNormals> Turning;
};

} // namespace shape
