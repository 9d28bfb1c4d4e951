#pragma once

#include "Base/Progress.h"
#include "Distance/HausdorffDistance.h"
#include "Geometry/FeatureAngle.h"
#include "Hex/Features/LostCreases.h"
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

/// How far the creases of hexahedra deviate from the creases of a surface.
struct FeatureDeviation
{
  /// The larger one-sided Hausdorff distance between the surface's curves and the edges between
  /// quads of different patches, sampled along both. If the boundary has a single patch, it is the
  /// maximum distance from the curves to the boundary. It is 0 if the surface has no curves.
  double Distance = 0.0;
  std::vector<int> CornerPoints; ///< boundary points that coincide with a corner of the surface
};

/// Compares the creases of a surface with the creases of a quad mesh. quads (q x 4): indices of
/// points. patchOf: the patch of each quad.
FeatureDeviation CompareCreases(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf);

/// Samples positions along the surface's curves. Returns the distance of each position to the
/// nearest edge between quads of different patches, or to the boundary if it has a single patch.
SampledDistances ComputeDistancesToCurves(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf);

/// The options shared by all methods that build hexahedra.
struct HexMeshOptions
{
  /// The size of the cells, in the surface's units, or 0 to choose it automatically. Smaller cells
  /// are used if cells of this size cannot have the solid's topology.
  double CellSize = 0.0;
  int MaximumHexahedra = 200000; ///< upper bound on the number of hexahedra; >= 1
  int PaddingLayers = 1;         ///< layers of hexahedra along the surface; >= 1
  /// An edge is a crease if the normals of its triangles differ by more than this angle; in
  /// degrees, in (0, 180].
  double FeatureAngle = DefaultFeatureAngle;
  /// If not empty: the patch given for each triangle of the surface. The creases are then the
  /// borders between these patches, whatever their angle.
  Eigen::VectorXi Patches = {};
  /// Whether a draft is enough: valid hexahedra of the first grid that has the topology, after few
  /// sweeps, in a fraction of the time. Their scaled Jacobians are smaller, and their distance from
  /// the surface is larger. Cells may be coarser, because more choices of the cells at the boundary
  /// are tried (VoxelRule::Any). It requires the cells of a grid.
  bool Draft = false;
};

/// Throws InvalidInput if one of the options is out of its range.
void RequireInRange(const HexMeshOptions& options);

/// Finds the creases that hexahedra of this cell size can follow: the creases around patches at
/// least as large as 4 cell faces. With a cell size of 0 it finds all.
SurfaceFeatures FindFeatures(
  const Surface& surface, const HexMeshOptions& options, double cellSize);

struct HexFit;

/// Returns the fraction of the length of the features' curves that the hexahedra follow; 1 if there
/// are no curves.
double ComputeFollowedShare(
  const HexFit& fit, const Mesh& surface, const SurfaceFeatures& features);

/// Updates the figures that depend on the hexahedra alone: scaled Jacobians and Inverted.
void Judge(HexFit& fit);

struct HexFitOptions
{
  int PaddingLayers = 1; ///< layers of hexahedra around the core; >= 1
  /// Creases are dropped if the layers that they need raise the number of hexahedra above this
  /// number.
  int MaximumHexahedra = std::numeric_limits<int>::max();
  /// Creases are dropped if the minimum scaled Jacobian with them is at most this value and is
  /// better without them.
  double MinimumWithFeatures = 0.2;
  /// Number of fits that may follow, each without the creases at the hexahedra that are too bad;
  /// >= 0. Where another mesh is the remedy, none is worth its time.
  int FurtherFits = 2;
  /// Whether hexahedra without all creases are of no use: no crease is given up.
  bool NeedsCreases = false;
  /// If the minimum scaled Jacobian is below this value, no further sweeps try to raise it.
  /// ImproveWorst can raise it later.
  double RaisedFrom = 0.0;
  bool Draft = false; ///< whether few sweeps are enough (HexMeshOptions)
};

/// Hexahedra whose boundary lies on a surface.
struct HexFit
{
  HexMesh Solid;
  /// The cells before layers were added. Layers keep the points of boundaries and interfaces, so
  /// that these are points of Solid.
  Eigen::MatrixXi Core;
  Eigen::MatrixXi Quads;              ///< q x 4: the boundary, counter-clockwise seen from outside
  Eigen::VectorXi PatchOf;            ///< for each quad: the patch of the surface that it lies on
  double MinimumScaledJacobian = 0.0; ///< positive if no hexahedron is inverted
  double MeanScaledJacobian = 0.0;
  int Inverted = 0; ///< hexahedra with a scaled Jacobian <= 0
  /// The larger one-sided Hausdorff distance between the surface and the boundary.
  double Distance = 0.0;
  /// Whether the hexahedra follow all curves and corners of the surface's features.
  bool CreasesKept = false;
  /// The curves of the features that they follow: chains of edges lie on them.
  std::vector<CreaseLine> Followed;
  FeatureDeviation Creases; ///< how far the hexahedra's creases are from the surface's
  Eigen::VectorXi RegionOf; ///< m: the region of each hexahedron (RegionCells)
  std::vector<Eigen::MatrixXi>
    Interfaces; ///< for each inner surface: its quads, counter-clockwise seen from outside
  /// If regions touch: for each quad of the boundary and then of Interfaces, the regions on its two
  /// sides, of which 0 is the outside; its normal leaves the first. Otherwise empty.
  Eigen::MatrixXi QuadRegions;
  double InnerDistance = 0.0; ///< see ComputeInterfaceDistance
  int Released = 0; ///< number of points that may leave the surface (RelaxBoundaryAroundBad)
  /// The constraint on the points; null if solids were joined.
  std::shared_ptr<const PointConstraint> Constraint;
};

/**
 * Fits the boundary of hexahedra to a nearby surface. Layers of hexahedra are added around the
 * core. Their outer points lie on the surface, whose creases become chains of edges and whose
 * corners become points. Then all points are moved to maximise the minimum scaled Jacobian
 * (OptimizeHexahedra).
 *
 * If the hexahedra are too coarse for a crease, it is given up (WithoutCurves), and they follow the
 * others. If hexahedra are too bad, the creases nearest to them are given up (FurtherFits). If they
 * stay too bad, all creases are dropped: the boundary is then a single patch.
 *
 * Layers are also added on both sides of each interface. The points of an interface lie on its
 * inner surface, whose creases are not kept.
 *
 * core: hexahedra whose boundary is a manifold. surface: closed and consistently oriented.
 * features: the features of the surface. Throws SolveFailure if NeedsCreases and a crease would be
 * given up; Aborted.
 */
HexFit FitHexahedra(const HexMesh& core, const Surface& surface, const SurfaceFeatures& features,
  const HexFitOptions& options = {}, const Progress& progress = {},
  const InnerInterfaces& interfaces = {});

/**
 * Moves boundary points to parts of the surface that are farther from the boundary than wanted
 * (SnapToFarPositions). Points on creases are not moved there.
 *
 * fit: from FitHexahedra with the same surface. Throws Aborted.
 */
void SnapToSurface(HexFit& fit, const Surface& surface, const SnappingOptions& options,
  const Progress& progress = {});

/**
 * Spends more sweeps on the worst hexahedra if the minimum scaled Jacobian is below 0.55.
 *
 * fit: from FitHexahedra with the same surface; no hexahedron is inverted. Throws Aborted.
 */
void ImproveWorst(HexFit& fit, const Surface& surface, const Progress& progress = {});

/**
 * Lets points around bad hexahedra leave the surface. The first step releases points around
 * inverted hexahedra (RelaxBoundaryOfInverted). If none stays inverted, the second step releases
 * points around hexahedra with a scaled Jacobian below `wanted` (RelaxBoundaryOfWorst). The second
 * step lets the distance between boundary and surface grow to maximumDistance or to 1.05 times its
 * previous value, whichever is larger.
 *
 * fit: from FitHexahedra with the same surface. Throws Aborted.
 */
void RelaxBoundaryAroundBad(HexFit& fit, const Surface& surface, double maximumDistance,
  const Progress& progress = {}, double wanted = 0.55);

} // namespace shape
