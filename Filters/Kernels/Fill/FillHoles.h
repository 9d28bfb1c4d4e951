#pragma once

#include "Base/Progress.h"
#include "Fill/HoleFiller.h"
#include "Fill/LoopCorners.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace shape
{

struct FillHolesOptions
{
  FillMethod Method = FillMethod::Automatic;
  HoleFillerOptions Filler;
  DeformOptions Deformation; ///< for the method Deformation; may be changed interactively
  PoseOptions Frames;        ///< a further rotation of the frames at the loops; also interactive
};

/// A filled hole of a surface.
struct FilledHole
{
  int Number = 0;        ///< index of its loop among the given loops
  std::vector<int> Loop; ///< points of the surface, with the fill to the left
  int FirstPoint = 0;    ///< index of the first new point in the filled surface
  int Points = 0;
  int FirstTriangle = 0; ///< index of the fill's first triangle in the filled surface
  int Triangles = 0;
  FillMethod Method = FillMethod::Fair; ///< never Automatic
  std::string Reason;                   ///< the reason for this method, in words
  double Nonplanarity = 0.0;            ///< of the loop: see ComputeNonplanarity
  double DeviationBefore = 0.0;         ///< see HoleFill
  double DeviationAfter = 0.0;
  /// Number of pairs of triangles that intersect beyond their common corners and edges. At least
  /// one triangle of each pair is in the fill. A pair between two fills is counted for the later
  /// one.
  int SelfIntersections = 0;
};

struct FilledSurface
{
  /// The surface's points and triangles first, unchanged; then those of the fills, hole by hole.
  Mesh Surface;
  std::vector<FilledHole> Holes;
  /// The provenance from the given surface. A point of a fill takes its data from the nearest point
  /// of the loop. A triangle of a fill takes its data from a triangle of the surface at the loop.
  /// For smooth values see ExtendValuesOntoFill.
  shape::Provenance Provenance;
};

/**
 * Fills the holes of a surface, or builds the patches between curves, once or several times with
 * different parameters. Repeated calls of Fill recompute only what depends on the changed
 * parameters.
 *
 * Holes are filled as in Schmidt and Singh, "Drag-and-drop surface composition" (Graphics Interface
 * 2010), section 4.1, or by a fair surface. A fair surface is much closer to spheres and other
 * round shapes. The edges of a fill are as long as the edges of its loop. The points of the loops
 * and the triangles beside them do not change. A manifold therefore remains a manifold, and becomes
 * watertight if all of its loops are filled.
 */
class SurfaceFiller
{
public:
  /// loops: indices of the surface's points, with the surface to the left, as FindBoundaryLoops
  /// returns them; each loop has at least 3 points. Throws InvalidInput if an index is out of range
  /// or a point is not finite.
  SurfaceFiller(const shape::Surface& surface, const std::vector<std::vector<int>>& loops,
    const HoleFillerOptions& options = {});

  /// rims: loops of the surface's points, with the fill to the left. normals: n x 3, the normals of
  /// the fills at the surface's points; where a normal is zero, the membrane's normal is used. The
  /// surface may have no triangles.
  SurfaceFiller(const shape::Surface& surface, const std::vector<std::vector<int>>& rims,
    const Eigen::MatrixXd& normals, const HoleFillerOptions& options = {});
  ~SurfaceFiller();

  /// Fills all holes; options.Filler is ignored here. Throws InvalidInput if an option is out of
  /// range; SolveFailure, with the first point of the hole, if a hole cannot be filled; Aborted.
  FilledSurface Fill(const FillHolesOptions& options, const Progress& progress = {});

private:
  struct Hole;
  void Add(const std::vector<std::vector<int>>& rims,
    const std::function<Eigen::MatrixXd(const std::vector<int>&)>& normals,
    HoleFillerOptions options);
  bool Try(
    Hole& hole, FillMethod method, const FillHolesOptions& options, const Progress& progress);
  std::vector<bool> FillEach(const FillHolesOptions& options, const Progress& progress);
  void Replace(Hole& hole, const FillHolesOptions& options, const Progress& progress);
  FilledSurface Joined(const Hole* last) const;

  shape::Surface Surface;
  std::unique_ptr<UsedEdges> Taken;
  std::vector<Hole> Holes;
};

/// Fills all holes of a surface (FindBoundaryLoops), which may have any triangles. Throws the
/// exceptions of SurfaceFiller.
FilledSurface FillHoles(
  const Surface& surface, const FillHolesOptions& options = {}, const Progress& progress = {});

/// Fills the given loops, which have the surface to the left.
FilledSurface FillLoops(const Surface& surface, const std::vector<std::vector<int>>& loops,
  const FillHolesOptions& options = {}, const Progress& progress = {});

/// Returns harmonic values at a fill's points (hole.Points x d), which continue the given values at
/// the loop (SolveHarmonicValues). values: one row for each point of hole.Loop, in order.
Eigen::MatrixXd ExtendValuesOntoFill(
  const Mesh& surface, const FilledHole& hole, const Eigen::MatrixXd& values);

} // namespace shape
