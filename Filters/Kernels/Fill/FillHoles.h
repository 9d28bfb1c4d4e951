#pragma once

#include "Base/Progress.h"
#include "Fill/HoleFiller.h"
#include "Fill/LoopCorners.h"
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
  DeformOptions Deformation; ///< where the method is Deformation; these may be tuned live
  PoseOptions Frames;        ///< likewise: how the frames at the rims are turned further
};

/// A hole of a surface that was filled.
struct FilledHole
{
  int Number = 0;        ///< of the loop among those given
  std::vector<int> Loop; ///< points of the surface, with the fill to the left
  int FirstPoint = 0;    ///< of the fill's own, in the filled surface
  int Points = 0;
  int FirstTriangle = 0; ///< of the fill, in the filled surface
  int Triangles = 0;
  FillMethod Method = FillMethod::Fair; ///< never Automatic
  std::string Reason;                   ///< why this method: words
  double Nonplanarity = 0.0;    ///< the rim's farthest point from its plane, over its diameter
  double DeviationBefore = 0.0; ///< see HoleFill
  double DeviationAfter = 0.0;
  int SelfIntersections = 0; ///< triangles that meet where they share nothing: pairs with one of
                             ///< the fill's
};

struct FilledSurface
{
  /// The surface's points and triangles first, unchanged; then those of the fills, hole by hole.
  Mesh Surface;
  std::vector<FilledHole> Holes;
};

/**
 * A surface, or curves, prepared for having holes filled, again with other parameters: then only
 * what depends on them is computed anew.
 *
 * Hole filling as in Schmidt and Singh, "Drag-and-drop surface composition" (Graphics Interface
 * 2010), section 4.1, and by a fair surface, which is closer to spheres and the like by far. The
 * triangles of fills are as long as the rim's sides; points on rims and triangles beside them stay
 * as they are, so a manifold stays one, and becomes watertight where all of its loops are filled.
 */
class SurfaceFiller
{
public:
  /// loops: of the surface's points, with the surface to the left, as FindBoundaryLoops finds them;
  /// each of at least 3 points. Throws InvalidInput where an index is out of range or a point is
  /// not finite.
  SurfaceFiller(const shape::Surface& surface, const std::vector<std::vector<int>>& loops,
    const HoleFillerOptions& options = {});

  /// rims: of the surface's points, with the fill to the left; normals: n x 3, of the surface's
  /// points, zero for that of the membrane. The surface may have no triangles.
  SurfaceFiller(const shape::Surface& surface, const std::vector<std::vector<int>>& rims,
    const Eigen::MatrixXd& normals, const HoleFillerOptions& options = {});
  ~SurfaceFiller();

  /// Fills all of them; those of options.Filler do not count here. Throws InvalidInput where an
  /// option is out of its range, SolveFailure with the rim's first point, Aborted.
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

/// Fills holes of a surface, of any triangles: all of FindBoundaryLoops. Throws as SurfaceFiller.
FilledSurface FillHoles(
  const Surface& surface, const FillHolesOptions& options = {}, const Progress& progress = {});

/// Fills the loops given, with the surface to the left.
FilledSurface FillLoops(const Surface& surface, const std::vector<std::vector<int>>& loops,
  const FillHolesOptions& options = {}, const Progress& progress = {});

/// Where the fill of a hole has its data from.
struct FillSources
{
  std::vector<int> Points;    ///< of each of its points: the nearest one of the rim
  std::vector<int> Triangles; ///< of each triangle: one of the surface's at the rim, the nearest
};

/// Of each fill. surface: with the fills, whose triangles are behind all others. Neither is empty
/// where the fill is not; a triangle is -1 where the rim has none.
std::vector<FillSources> FindFillSources(const Mesh& surface, const std::vector<FilledHole>& holes);

/// Values of a fill's points (hole.Points x d) from those at its rim: smooth continuations
/// (SolveHarmonicValues). values: n x d, of all points; the others' rows mean nothing.
Eigen::MatrixXd ExtendValuesOntoFill(
  const Mesh& surface, const FilledHole& hole, const Eigen::MatrixXd& values);

} // namespace shape
