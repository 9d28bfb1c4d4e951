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
  /// Whether the frames at the loop are optimised so that the feature joins the target smoothly.
  bool OptimizeNormals = true;
  /// For a feature that is being dragged: one angle for the whole loop is enough, the result is not
  /// checked, and no smaller scale is searched if the feature does not fit.
  bool Dragging = false;
};

/// The quantile of values at a share from 0 to 1; 0 if there are none.
double ComputePercentile(const Eigen::VectorXd& values, double share);

/// A feature prepared for being pasted, again and again: see PasteTarget, ShapeDeformation.
class FeatureToPaste
{
public:
  /**
   * feature: any triangles; base: of its loop. Throws InvalidInput if the loop is no closed curve
   * of at least 3 points of the feature, crosses itself in the plane or runs clockwise there, or as
   * PrepareDeformation does; Aborted.
   */
  FeatureToPaste(const shape::Surface& feature, FeatureFootprint base,
    const DeformOptions& options = {}, const DeformFields& fields = {},
    const Progress& progress = {});

  /**
   * Pastes the feature: its loop is mapped to the target (PasteTarget::Land), the feature is
   * deformed to follow it, and a band of triangles joins both. Section 4.2 of Schmidt and Singh,
   * "Drag-and-drop surface composition" (Graphics Interface 2010).
   *
   * The result is a 2-manifold if both were; watertight if the target was and the feature has no
   * other loop. Pasted where it was cut (Scale 1, no Rotation, on the surface that its base is
   * from), the feature returns to its position. `Scale` multiplies the deformation's.
   *
   * OptimizeNormals rotates the frames (OptimizeBoundaryNormals) so that the feature's normals at
   * the loop, weighted by angle, become the target's; then the points near the loop by the
   * remaining angle (SeamNormals, to a distance of 4 mean edges of the loop). If the loop moves as
   * a rigid body, the feature keeps its angle to the surface; as the frames come to differ by 5
   * degrees, the target's normals take over.
   *
   * Throws as PasteTarget::Land; SolveFailure if the result is not the expected surface; Aborted.
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
  CutTriangles
    Cut; ///< the feature's, split at the chords of its loop, so that all can rotate there
  TriangleFans Fans; ///< of these
  BoundaryHandle Handle;
  Eigen::MatrixXd NormalsBefore; ///< at the loop, of the feature at rest
  double NormalReach;            ///< arrival time of the last point that the normals depend on
  std::unique_ptr<ShapeDeformation> Prepared;
  std::unique_ptr<SeamNormals> Turning;
};

} // namespace shape
