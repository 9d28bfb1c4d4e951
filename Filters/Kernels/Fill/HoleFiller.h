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
 * A flat disk prepared for being deformed until its outline is the boundary loop of a hole. The
 * deformation can be repeated with other parameters. See section 4.1 of Schmidt and Singh,
 * "Drag-and-drop surface composition" (Graphics Interface 2010).
 *
 * As in the paper, the boundary's frames are optimised once, for the default parameters, and not
 * again when these change. The result therefore depends on the current parameters only, not on
 * earlier ones.
 */
class HoleDeformation
{
public:
  /// patch: its layout is the disk to deform. Throws Aborted.
  HoleDeformation(
    HolePatch patch, BoundaryLoop loop, bool optimizeNormals, const Progress& progress = {});

  /// Returns the deformed positions of the disk's points (n x 3); those on the boundary loop are
  /// exact. frames: a further rotation of the loop's frames. Throws InvalidInput if an option is
  /// out of range; Aborted.
  Eigen::MatrixXd Points(
    const DeformOptions& options, const PoseOptions& frames, const Progress& progress = {});

  const Eigen::MatrixXi& Triangles() const { return this->Patch.Surface.Triangles; }

  /// The mean angle in degrees between the normals at the loop and the wanted ones, with the
  /// default parameters: before and after the optimisation.
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

/// Returns the normals of a patch at its boundary loop (ComputeBoundaryNormals), which consists of
/// the patch's first `loop` points.
Eigen::MatrixXd ComputePatchBoundaryNormals(const Mesh& patch, Eigen::Index loop);

/// The method by which a hole is filled.
enum class FillMethod
{
  /// The first of Fair, Deformation and Membrane whose fill intersects neither the surface nor
  /// itself. If no method has such a fill, the method with the fewest intersections.
  Automatic,
  Deformation, ///< a flat disk deformed until its outline is the loop: HoleDeformation
  Fair,        ///< tangent to the surface, with harmonic mean curvature: SolveFairSurface
  Membrane     ///< of minimal area, with a crease along the loop: SolveMembrane
};

struct HoleFillerOptions
{
  bool OptimizeNormals = true; ///< Deformation only: see HoleDeformation
  /// Increase of the edge length per unit of distance from the loop, in [0, 1]. If it is 0, edges
  /// are as long as on the loop.
  double EdgeGrowth = 0.0;
  /// The approximate maximum number of new points in a hole; >= 1. If more would be needed,
  /// EdgeGrowth is raised.
  int MaximumPoints = 100000;
  /// Takes the indices of two points in the loop, and returns whether an edge outside the fill
  /// joins them. The function may be empty.
  std::function<bool(int, int)> IsTaken;
};

/// A surface that fills a hole.
struct HoleFill
{
  Mesh Patch; ///< the points of the loop first, in order, unchanged
  /// The mean angle in degrees between the normals at the loop and the wanted ones. It is measured
  /// on the membrane or, with Deformation, on the deformed disk before the frames are optimised.
  double DeviationBefore = 0.0;
  double DeviationAfter = 0.0; ///< the same angle for the result
  bool Converged = true;       ///< Fair: whether its iterations converged
  /// Fair: whether the result is usable. It is unusable if its area is more than ten times the
  /// membrane's. It is also unusable if it did not converge and its normals at the loop are more
  /// than 45 degrees from the wanted ones.
  bool IsSound = true;
};

/// Fills a hole, once or several times with different parameters. Results that do not depend on the
/// changed parameters are reused.
class HoleFiller
{
public:
  /// loop: no two consecutive points may coincide. If it has fewer than 3 points, the fill is
  /// empty. Where a normal is zero, the membrane's normal is used.
  explicit HoleFiller(BoundaryLoop loop, const HoleFillerOptions& options = {});

  /// Fills the hole. method: any except Automatic. Throws InvalidInput if an option is out of
  /// range; SolveFailure; Aborted.
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
