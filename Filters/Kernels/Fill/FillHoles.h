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
  DeformOptions Deformation; ///< for the method Deformation; these may be tuned live
  PoseOptions Frames;        ///< likewise: a further rotation of the frames at the loops
};

/// A hole of a surface that was filled.
struct FilledHole
{
  int Number = 0;        ///< of the loop among the given ones
  std::vector<int> Loop; ///< points of the surface, with the fill to the left
  int FirstPoint = 0;    ///< of the new ones, in the filled surface
  int Points = 0;
  int FirstTriangle = 0; ///< of the fill, in the filled surface
  int Triangles = 0;
  FillMethod Method = FillMethod::Fair; ///< never Automatic
  std::string Reason;                   ///< why this method: words
  double Nonplanarity = 0.0;            ///< see ComputeNonplanarity, of the loop
  double DeviationBefore = 0.0;         ///< see HoleFill
  double DeviationAfter = 0.0;
  int SelfIntersections = 0; ///< pairs of triangles that intersect where they share nothing, one
                             ///< of them in the fill
};

struct FilledSurface
{
  /// The surface's points and triangles first, unchanged; then those of the fills, hole by hole.
  Mesh Surface;
  std::vector<FilledHole> Holes;
  /// From the surface. A point of a fill takes its data from the nearest point of the loop, a
  /// triangle from a triangle of the surface at the loop; for smooth values see
  /// ExtendValuesOntoFill.
  shape::Provenance Provenance;
};

/**
 * Fills holes of a surface, or between curves, once or again with other parameters: then it only
 * recomputes what depends on them.
 *
 * Hole filling as in Schmidt and Singh, "Drag-and-drop surface composition" (Graphics Interface
 * 2010), section 4.1, and by a fair surface, which is much closer to spheres and other round
 * shapes. The edges of a fill are as long as those of its loop. Points on loops and triangles
 * beside them are unchanged: so a manifold stays one, and becomes watertight if all of its loops
 * are filled.
 */
class SurfaceFiller
{
public:
  /// loops: of the surface's points, with the surface to the left, as FindBoundaryLoops finds them;
  /// each of at least 3 points. Throws InvalidInput if an index is out of range or a point is not
  /// finite.
  SurfaceFiller(const shape::Surface& surface, const std::vector<std::vector<int>>& loops,
    const HoleFillerOptions& options = {});

  /// rims: loops of the surface's points with the fill to the left; normals: n x 3, of the
  /// surface's points, zero for that of the membrane. The surface may have no triangles.
  SurfaceFiller(const shape::Surface& surface, const std::vector<std::vector<int>>& rims,
    const Eigen::MatrixXd& normals, const HoleFillerOptions& options = {});
  ~SurfaceFiller();

  /// Fills all of them; options.Filler is ignored here. Throws InvalidInput if an option is out of
  /// range, SolveFailure with the loop's first point, Aborted.
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

/// Fills all holes of a surface of any triangles (FindBoundaryLoops). Throws as SurfaceFiller does.
FilledSurface FillHoles(
  const Surface& surface, const FillHolesOptions& options = {}, const Progress& progress = {});

/// Fills the given loops, which have the surface to the left.
FilledSurface FillLoops(const Surface& surface, const std::vector<std::vector<int>>& loops,
  const FillHolesOptions& options = {}, const Progress& progress = {});

/// Values at a fill's points (hole.Points x d): the harmonic ones with those given at its loop
/// (SolveHarmonicValues). values: of the points of hole.Loop, in order.
Eigen::MatrixXd ExtendValuesOntoFill(
  const Mesh& surface, const FilledHole& hole, const Eigen::MatrixXd& values);

} // namespace shape
