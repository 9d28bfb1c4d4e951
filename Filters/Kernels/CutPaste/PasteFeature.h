#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/PasteTarget.h"
#include "CutPaste/PastedFeature.h"
#include "CutPaste/PointTarget.h"
#include "CutPaste/Seam.h"
#include "CutPaste/SoupTarget.h"
#include "Deform/HandleFrames.h"
#include "Deform/ShapeDeformation.h"
#include "Mesh/Surface.h"
#include "Search/TriangleWalk.h"

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace shape
{

struct PasteFeatureOptions
{
  /// Whether the frames at the loop are optimised so that the feature joins the target smoothly.
  bool OptimizeNormals = true;
  /// Whether the feature is being dragged. If so, one angle for the whole loop is enough, the
  /// result is not checked, and no smaller scale is searched for if the feature does not fit.
  bool Dragging = false;
  /// The normals of the feature at its loop are rotated towards BiasFrame, and no longer match
  /// those of the target.
  PoseOptions Frames = {};
};

/// Returns the quantile of values for a share from 0 (minimum) to 1 (maximum); 0 if there are no
/// values.
double ComputePercentile(const Eigen::VectorXd& values, double share);

/// A feature prepared for being pasted any number of times: see PasteTarget, ShapeDeformation.
class FeatureToPaste
{
public:
  ///@{
  /**
   * feature: any triangles. bases: the footprints of the loops along which it is joined to a
   * target; the first one is at the seed. Throws InvalidInput if there is none, or if a loop is not
   * a closed curve of at least 3 points of the feature, crosses itself in the plane, or runs
   * clockwise there. Throws the exceptions of PrepareDeformation; Aborted.
   */
  FeatureToPaste(const shape::Surface& feature, std::vector<FeatureFootprint> bases,
    const DeformOptions& options = {}, const DeformFields& fields = {},
    const Progress& progress = {});
  FeatureToPaste(const shape::Surface& feature, const FeatureFootprint& base,
    const DeformOptions& options = {}, const DeformFields& fields = {},
    const Progress& progress = {})
    : FeatureToPaste(feature, std::vector<FeatureFootprint>{ base }, options, fields, progress)
  {
  }
  ///@}

  /**
   * Pastes the feature: its loops are mapped to the target (PasteTarget::Land), the feature is
   * deformed to follow them, and a band of triangles at each joins both. See section 4.2 of Schmidt
   * and Singh, "Drag-and-drop surface composition" (Graphics Interface 2010).
   *
   * The result is a 2-manifold if both inputs are; it is watertight if the target is and the
   * feature has no other boundary loop. Each joined loop after the first adds a handle, or connects
   * two components of the target. A feature returns to its position if it is pasted at the
   * seed of its base, with Scale 1 and Rotation 0, on the surface from which it was cut. The
   * deformation's scale is multiplied by the placement's Scale.
   *
   * OptimizeNormals rotates the frames (OptimizeBoundaryNormals) to match the feature's
   * angle-weighted normals at the loop to those of the target. The remaining angle is removed by
   * rotating the points near the loop (SeamNormals, up to a distance of 4 mean edges of the loop).
   * If all frames rotate alike, however, the feature moves rigidly and keeps its own normals. The
   * wanted normals change from the feature's own to the target's as the difference between the
   * frames' rotations increases to 5 degrees.
   *
   * Where a loop crosses a gap of the feature, the target and the band get a boundary.
   *
   * Throws the exceptions of PasteTarget::Land; SolveFailure if the result has the wrong topology;
   * Aborted.
   */
  PastedFeature PasteOn(PasteTarget& target, const PastePlacement& placement,
    const PasteFeatureOptions& options = {}, const Progress& progress = {}) const;

  /**
   * Pastes the feature on a polygon soup: the same, but the feature is deformed to the loop on the
   * soup (SoupTarget::Land), and the soup, cut along the loop, gets no band. Where the soup has a
   * triangle at the seam, both have the same points and edges: the edges of the feature's loop are
   * split where the soup's edges meet them. A sheet farther from the seam than a quarter of the
   * loop's edge stays separate, and LargestGap says how far away it is.
   *
   * Throws InvalidInput if the feature has several bases, as only one loop can be joined to a soup.
   * Throws the exceptions of SoupTarget::Land; Aborted.
   */
  PastedFeature PasteOn(SoupTarget& target, const PastePlacement& placement,
    const PasteFeatureOptions& options = {}, const Progress& progress = {}) const;

  /**
   * Pastes the feature on a point cloud: the same, but only the feature's points are joined to the
   * target's. Those below the feature are removed (PointTarget::Land). Where the next point of the
   * target is farther from the seam than the target's spacing, points of the target's surface are
   * added between them. The feature may be given by any triangles, such as the local ones of a
   * point cloud (ConnectSamples). A feature returns to its position if it is pasted where it was
   * cut, as on a manifold. normals: unit normals at the feature's points (n x 3), which move with
   * them.
   *
   * Throws InvalidInput if the feature has several bases. Throws the exceptions of
   * PointTarget::Land; Aborted.
   */
  PastedFeature PasteOn(PointTarget& target, const Eigen::MatrixXd& normals,
    const PastePlacement& placement, const PasteFeatureOptions& options = {},
    const Progress& progress = {}) const;

  const shape::Surface& Surface() const { return this->Feature; }
  const std::vector<FeatureFootprint>& Bases() const { return this->Stands; }
  /// The points of all joined loops, one loop after another.
  const std::vector<int>& LoopPoints() const { return this->Loop; }
  const ShapeDeformation& Deformation() const { return *this->Prepared; }
  const BoundaryHandle& LoopHandle() const { return this->Handle; }

private:
  /// The feature deformed to loops.
  struct Deformed
  {
    DeformedShape Shape; ///< its points with midpoints, rotations without
    PrescribedRotations Turns;
    Eigen::VectorXd AnglesBefore, AnglesAfter;
  };
  Deformed DeformTo(const Eigen::MatrixXd& positions, const Eigen::MatrixXd& normals, double scale,
    const PasteFeatureOptions& options, const Progress& progress) const;
  DeformedShape Smoothly(HandlePose& pose, const Eigen::MatrixXd& normals,
    const PasteFeatureOptions& options, const Progress& progress) const;
  Eigen::MatrixXd LoopNormals(const Eigen::MatrixXd& points) const;
  Eigen::MatrixXd WithMidpoints(const Eigen::MatrixXd& points) const;

  const FeatureFootprint& SingleBase(const std::string& target, const std::string& remedy) const;
  template <typename Landing>
  void Finish(const Landing& landing, Deformed deformed, const SurfaceLocator& target,
    PastedFeature& result) const;
  void Check(const PastedFeature& pasted) const;
  int SidesAcrossGaps() const;

  shape::Surface Feature;
  std::vector<FeatureFootprint> Stands;
  std::vector<int> Loop;
  /// The feature's triangles, split at the chords of its loops so that all of them can rotate
  /// there.
  CutTriangles Cut;
  TriangleFans Fans; ///< the fans of these triangles
  BoundaryHandle Handle;
  Eigen::MatrixXd NormalsBefore; ///< of the undeformed feature, at the points of its loops
  double NormalReach;            ///< maximum arrival time of a point on which the normals depend
  std::unique_ptr<ShapeDeformation> Prepared;
  std::unique_ptr<SeamNormals> Turning;
};

} // namespace shape
