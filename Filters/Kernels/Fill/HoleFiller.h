#pragma once

#include "Base/Progress.h"
#include "Deform/BoundaryNormals.h"
#include "Deform/HandleFrames.h"
#include "Deform/ShapeDeformation.h"
#include "Fill/FairSurface.h"
#include "Fill/HolePatch.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>

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

/// How a hole is filled.
enum class FillMethod
{
  Automatic,   ///< Fair; where that meets the surface or itself Deformation, then Membrane; where
               ///< all do, the one that does it least
  Deformation, ///< a flat disk deformed until its outline is the rim: HoleDeformation
  Fair,        ///< tangent to the surface, of harmonic mean curvature: SolveFairSurface
  Membrane     ///< as taut as can be, with a crease along the rim: SolveMembrane
};

struct HoleFillerOptions
{
  bool OptimizeNormals = true; ///< of Deformation: HoleDeformation
  /// By how much edges grow with the distance from the rim; 0: they are as long as on the rim. >= 0
  double EdgeGrowth = 0.0;
  /// Of new points in a hole, about: edges grow away from the rim where more would be needed. >= 1
  int MaximumPoints = 100000;
  /// Whether two points of the rim, by their place in it, are joined by an edge elsewhere, or none.
  std::function<bool(int, int)> IsTaken;
};

/// A surface that fills a hole.
struct HoleFill
{
  Mesh Patch;                   ///< the rim's points first, in order, unchanged
  double DeviationBefore = 0.0; ///< degrees between its normals at the rim and those wanted, in the
                                ///< mean: the membrane's, for Deformation that of the disk deformed
                                ///< before the frames at the rim are optimised
  double DeviationAfter = 0.0;  ///< the same of the result
  bool Converged = true;        ///< Fair: whether its iterations did
  /// Fair: false where the result is no good: its area is more than ten times the membrane's, or
  /// it did not converge and leaves the rim by more than 45 degrees from the normals wanted.
  bool IsSound = true;
};

/// A hole that is filled, perhaps again with other parameters: what does not depend on them is
/// kept.
class HoleFiller
{
public:
  /// rim: no two neighbours at the same place; fewer than 3 points are filled by no triangle. A
  /// zero normal counts as the membrane's there.
  explicit HoleFiller(BoundaryLoop loop, const HoleFillerOptions& options = {});

  /// method: any but Automatic. Throws InvalidInput where an option is out of its range,
  /// SolveFailure, Aborted.
  HoleFill Fill(FillMethod method, const DeformOptions& options = {},
    const PoseOptions& frames = {}, const Progress& progress = {});

  const BoundaryLoop& Loop() const { return this->Border; }

private:
  const HolePatch& Span(const Progress& progress);
  HoleFill Deformation(
    const DeformOptions& options, const PoseOptions& frames, const Progress& progress);
  HoleFill Fair(const Progress& progress);
  HoleFill Membrane(const Progress& progress);
  double Deviation(const Mesh& patch) const;

  BoundaryLoop Border;
  HoleFillerOptions Options;
  PatchSizes Sizes;
  std::optional<HolePatch> Coarse; ///< the membrane
  std::unique_ptr<HoleDeformation> Deformed;
  std::optional<HoleFill> FairFill, MembraneFill;
};

} // namespace shape
