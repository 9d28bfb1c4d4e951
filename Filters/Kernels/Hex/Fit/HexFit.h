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

/// How well the boundary of hexahedra has the creases and corners of a surface.
struct FeatureDeviation
{
  /// The larger one-sided Hausdorff distance between the surface's curves and the edges between
  /// quads of different patches, at positions along both; to the whole boundary where it is of one
  /// patch. 0 where the surface has no curves.
  double Distance = 0.0;
  std::vector<int> CornerPoints; ///< of the boundary, those exactly at a corner of the surface
};

/// quads: q x 4, of points. patchOf: q.
FeatureDeviation CompareCreases(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf);

/// Positions along the surface's curves, and how far each is from the edges between quads of
/// different patches; from the whole boundary where it is of one patch.
SampledDistances ComputeDistancesToCurves(const Mesh& surface, const SurfaceFeatures& features,
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const Eigen::VectorXi& patchOf);

/// What every way to hexahedra has in common.
struct HexMeshOptions
{
  /// Of the cells, in the surface's units; smaller ones are used if these cannot have the solid's
  /// topology. 0: automatic.
  double CellSize = 0.0;
  int MaximumHexahedra = 200000; ///< no smaller cells are tried than give this many
  int PaddingLayers = 1;         ///< of hexahedra along the surface; >= 1
  /// Between normals, in degrees: what is sharper is a crease.
  double FeatureAngle = DefaultFeatureAngle;
};

/// Throws InvalidInput if one of the options is out of its range.
void RequireInRange(const HexMeshOptions& options);

/// The creases that hexahedra of cells of this size can have: those around patches at least 4 faces
/// of a cell large.
SurfaceFeatures FindFeatures(
  const Surface& surface, const HexMeshOptions& options, double cellSize);

struct HexFitOptions
{
  int PaddingLayers = 1; ///< of hexahedra around what is given; >= 1
  /// Creases whose layers make more are given up.
  int MaximumHexahedra = std::numeric_limits<int>::max();
  /// The scaled Jacobian below which creases are given up, if the hexahedra are better without.
  double MinimumWithFeatures = 0.2;
  /// The worst scaled Jacobian below which no more time is spent on it (ImproveWorst may, later).
  double RaisedFrom = 0.0;
};

/// Hexahedra whose boundary lies on a surface.
struct HexFit
{
  HexMesh Solid;
  Eigen::MatrixXi Quads;              ///< q x 4: its boundary, counter-clockwise seen from outside
  Eigen::VectorXi PatchOf;            ///< q: the patch of the surface that a quad lies on
  double MinimumScaledJacobian = 0.0; ///< positive where no hexahedron is inverted
  double MeanScaledJacobian = 0.0;
  int Inverted = 0; ///< hexahedra with a scaled Jacobian of 0 or less
  /// The larger one-sided Hausdorff distance between the surface and the boundary.
  double Distance = 0.0;
  /// Whether every curve and corner of the features is one of the hexahedra; where not, none is.
  bool CreasesKept = false;
  FeatureDeviation Creases; ///< how far the surface's and the hexahedra's are apart
  Eigen::VectorXi RegionOf; ///< m: of each hexahedron, see RegionCells; 0 without inner surfaces
  std::vector<Eigen::MatrixXi>
    Interfaces;               ///< the quads on each inner surface, seen from outside it
  double InnerDistance = 0.0; ///< the largest between an interface and its surface
  int Released = 0; ///< points that need not be on the surface any more (RelaxBoundaryAroundBad)
  /// What points keep to; none where solids were joined.
  std::shared_ptr<const PointConstraint> Constraint;
};

/**
 * Puts the boundary of hexahedra on a surface near it: layers of hexahedra around them, whose outer
 * points lie on the surface, its creases on chains of edges and its corners on points; then all
 * points are moved so that the worst scaled Jacobian is as good as it can be (OptimizeHexahedra).
 *
 * Where the hexahedra are too coarse for the creases, or bad with them, there is one patch.
 *
 * With interfaces, there are layers on both sides of these, too, and their points lie on the inner
 * surfaces; creases of theirs are not kept.
 *
 * core: its boundary is a manifold. surface: closed, oriented consistently. features: of it. Throws
 * Aborted.
 */
HexFit FitHexahedra(const HexMesh& core, const Surface& surface, const SurfaceFeatures& features,
  const HexFitOptions& options = {}, const Progress& progress = {},
  const InnerInterfaces& interfaces = {});

/**
 * Puts points of the boundary on what of the surface is farther from it than wanted
 * (SnapToFarPositions); creases stay as they are.
 *
 * fit: of FitHexahedra, and surface: what it was given. Throws Aborted.
 */
void SnapToSurface(HexFit& fit, const Surface& surface, const SnappingOptions& options,
  const Progress& progress = {});

/**
 * Spends more time on the worst hexahedra where they are not good enough.
 *
 * fit: of FitHexahedra, none inverted, and surface: what it was given. Throws Aborted.
 */
void ImproveWorst(HexFit& fit, const Surface& surface, const Progress& progress = {});

/**
 * Frees points around hexahedra of the surface: around those that are inverted
 * (RelaxBoundaryOfInverted), then around the worst where they are not good enough
 * (RelaxBoundaryOfWorst), as long as the distance stays below a most one, or grows by less than a
 * twentieth.
 *
 * fit: of FitHexahedra, and surface: what it was given. Throws Aborted.
 */
void RelaxBoundaryAroundBad(
  HexFit& fit, const Surface& surface, double maximumDistance, const Progress& progress = {});

} // namespace shape
