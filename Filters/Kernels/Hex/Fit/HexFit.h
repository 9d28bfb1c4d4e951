#pragma once

#include "Base/Progress.h"
#include "Distance/HausdorffDistance.h"
#include "Geometry/FeatureAngle.h"
#include "Hex/Fit/InnerInterfaces.h"
#include "Hex/Fit/Snapping.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <limits>
#include <memory>
#include <vector>

namespace shape
{

/// The deviation of the hexahedra's creases and corners from those of a surface.
struct FeatureDeviation
{
  /// The larger one-sided Hausdorff distance between the surface's curves and the edges between
  /// quads of different patches, sampled along both. If the boundary has a single patch, the
  /// distance from the curves to the whole boundary. 0 if the surface has no curves.
  double Distance = 0.0;
  std::vector<int> CornerPoints; ///< boundary points that coincide with a corner of the surface
};

/// Compares the creases of a surface with those of a quad mesh. quads: q x 4 indices into points;
/// patchOf: q.
FeatureDeviation CompareCreases(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf);

/// Samples positions along the surface's curves. Returns the distance of each to the edges between
/// quads of different patches, or to the whole boundary if it has a single patch.
SampledDistances ComputeDistancesToCurves(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf);

/// The options shared by all methods that build hexahedra.
struct HexMeshOptions
{
  /// The size of the cells, in the surface's units. Smaller cells are used if these cannot have the
  /// solid's topology. 0: automatic.
  double CellSize = 0.0;
  int MaximumHexahedra = 200000; ///< the largest number of hexahedra that cells may give
  int PaddingLayers = 1;         ///< layers of hexahedra along the surface; >= 1
  /// Angle between normals above which an edge is a crease; degrees.
  double FeatureAngle = DefaultFeatureAngle;
};

/// Throws InvalidInput if one of the options is out of its range.
void RequireInRange(const HexMeshOptions& options);

/// Finds the creases that hexahedra of this cell size can follow: those around patches of the area
/// of at least 4 cell faces.
SurfaceFeatures FindFeatures(
  const Surface& surface, const HexMeshOptions& options, double cellSize);

struct HexFitOptions
{
  int PaddingLayers = 1; ///< layers of hexahedra around the core; >= 1
  /// Creases are dropped if their layers exceed this number of hexahedra.
  int MaximumHexahedra = std::numeric_limits<int>::max();
  /// If the scaled Jacobian with creases is below this and better without them, they are dropped.
  double MinimumWithFeatures = 0.2;
  /// If the worst scaled Jacobian is below this, no further time is spent on it; ImproveWorst may
  /// do so later.
  double RaisedFrom = 0.0;
};

/// Hexahedra whose boundary lies on a surface.
struct HexFit
{
  HexMesh Solid;
  Eigen::MatrixXi Quads;              ///< q x 4: the boundary, counter-clockwise from outside
  Eigen::VectorXi PatchOf;            ///< q: the patch of the surface that each quad lies on
  double MinimumScaledJacobian = 0.0; ///< positive if no hexahedron is inverted
  double MeanScaledJacobian = 0.0;
  int Inverted = 0; ///< hexahedra with a scaled Jacobian <= 0
  /// The larger one-sided Hausdorff distance between the surface and the boundary.
  double Distance = 0.0;
  /// Whether the hexahedra follow every curve and corner of the features; if false, they follow
  /// none.
  bool CreasesKept = false;
  FeatureDeviation Creases; ///< how far the hexahedra's creases are from the surface's
  Eigen::VectorXi RegionOf; ///< m: the region of each hexahedron (RegionCells); 0 without regions
  std::vector<Eigen::MatrixXi>
    Interfaces;               ///< the quads on each inner surface, counter-clockwise from outside
  double InnerDistance = 0.0; ///< the largest distance of an interface to its inner surface
  int Released = 0; ///< points that no longer need to lie on the surface (RelaxBoundaryAroundBad)
  /// The constraint on the points; null if solids were joined.
  std::shared_ptr<const PointConstraint> Constraint;
};

/**
 * Puts the boundary of hexahedra on a nearby surface. Layers of hexahedra are added around the
 * core: their outer points lie on the surface, its creases become chains of edges, and its corners
 * become points. Then all points are moved to maximise the worst scaled Jacobian
 * (OptimizeHexahedra).
 *
 * If the hexahedra are too coarse for the creases, or bad with them, the creases are dropped and
 * the boundary becomes a single patch.
 *
 * Interfaces get layers on both sides, too, and their points lie on the inner surfaces, whose
 * creases are not kept.
 *
 * core: its boundary is a manifold. surface: closed and consistently oriented. features: those of
 * the surface. Throws Aborted.
 */
HexFit FitHexahedra(const HexMesh& core, const Surface& surface, const SurfaceFeatures& features,
  const HexFitOptions& options = {}, const Progress& progress = {},
  const InnerInterfaces& interfaces = {});

/**
 * Moves points of the boundary to parts of the surface that are farther from it than wanted
 * (SnapToFarPositions); creases are not changed.
 *
 * fit: from FitHexahedra with the same surface. Throws Aborted.
 */
void SnapToSurface(HexFit& fit, const Surface& surface, const SnappingOptions& options,
  const Progress& progress = {});

/**
 * Spends more sweeps on the worst hexahedra if they are not good enough.
 *
 * fit: from FitHexahedra with the same surface; none is inverted. Throws Aborted.
 */
void ImproveWorst(HexFit& fit, const Surface& surface, const Progress& progress = {});

/**
 * Lets points around bad hexahedra leave the surface: first around inverted ones
 * (RelaxBoundaryOfInverted), then around the worst if they are not good enough
 * (RelaxBoundaryOfWorst). The second step keeps the distance to the surface below maximumDistance
 * or 1.05 times its value before, whichever is larger.
 *
 * fit: from FitHexahedra with the same surface. Throws Aborted.
 */
void RelaxBoundaryAroundBad(
  HexFit& fit, const Surface& surface, double maximumDistance, const Progress& progress = {});

} // namespace shape
