#pragma once

#include "Base/Progress.h"
#include "Deform/BoundaryNormals.h"
#include "Deform/HandleFrames.h"
#include "Deform/ShapeDeformation.h"
#include "Fill/FairSurface.h"
#include "Fill/HolePatch.h"

#include <Eigen/Core>

#include <memory>

namespace shape
{

/**
 * A hole's flat disk prepared for being deformed until its outline is the rim, again and again with
 * other parameters: section 4.1 of Schmidt and Singh, "Drag-and-drop surface composition" (Graphics
 * Interface 2010).
 *
 * The boundary's frames are optimised once, for the parameters' defaults, and kept when these are
 * tuned, as there: so the result depends on the parameters alone, not on the way to them.
 */
class HoleDeformation
{
public:
  /// patch: its layout is the disk that is deformed. Throws Aborted.
  HoleDeformation(
    HolePatch patch, BoundaryLoop loop, bool optimizeNormals, const Progress& progress = {});

  /// Where the disk's points go (n x 3); the rim exactly to its points. frames: turn the rim's
  /// frames further. Throws InvalidInput where an option is out of its range, Aborted.
  Eigen::MatrixXd Points(
    const DeformOptions& options, const PoseOptions& frames, const Progress& progress = {});

  const Eigen::MatrixXi& Triangles() const { return this->Patch.Surface.Triangles; }

  /// Degrees between the normals at the rim and those wanted, in the mean, with the defaults:
  /// before and after they were optimised.
  double DeviationBefore() const { return this->Frames.Before; }
  double DeviationAfter() const { return this->Frames.After; }

private:
  HolePatch Patch;
  BoundaryLoop Loop;
  PointGraph Graph;
  BoundaryHandle Handle;
  BoundaryNormalsResult Frames;
  std::unique_ptr<ShapeDeformation> Prepared;
  DeformOptions PreparedFor;
};

/// The normals of a patch at its rim, its first `rim` points: see ComputeBoundaryNormals.
Eigen::MatrixXd ComputePatchBoundaryNormals(const Mesh& patch, Eigen::Index loop);

} // namespace shape
