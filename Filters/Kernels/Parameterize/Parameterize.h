#pragma once

#include "Base/Progress.h"
#include "Distortion/InjectiveRefinement.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfaceCut.h"
#include "Parameterize/DiskMap.h"
#include "Parameterize/OrbifoldTile.h"

#include <string>

namespace shape
{

struct ParameterizeOptions
{
  /// The domain onto which the surface is mapped.
  enum class DomainType
  {
    Disk = 0,         ///< a disk or square, for a surface with one boundary loop: shape::MapToDisk
    Sphere = 1,       ///< the unit sphere, for a closed surface of genus 0: shape::MapToSphere
    FreeBoundary = 2, ///< the plane, for a surface with boundary loops: shape::MapWithFreeBoundary
    Orbifold = 3      ///< an orbifold's tile, for a closed surface of genus 0: shape::MapToOrbifold
  };
  DomainType Domain = DomainType::Sphere;
  /// Disk: the weights with which each point is the mean of its neighbours.
  CombinationWeights Weights = DiskMapOptions().Weights;
  /// Disk: the image of the boundary loop.
  DiskOutline Outline = DiskMapOptions().Outline;
  /// Disk and FreeBoundary: whether shape::RefineInjectively lowers the distortion of the image,
  /// and by which measure (shape::Distortion). The Disk's outline is fixed.
  RefineType Refine = RefineType::None;
  /// Exponent of ExponentialSymmetricDirichlet and AMIPS; > 0. The larger it is, the more the worst
  /// triangles count.
  double RefineExponent = InjectiveRefinementOptions().Exponent;
  /// Orbifold: the tile for three landmarks; Rhombus treats the three alike. With four landmarks,
  /// the tile is a parallelogram whatever this option says, and with more it is hyperbolic.
  OrbifoldType Tile = OrbifoldType::Rhombus;
  /// Sphere: the weight of equal areas relative to equal angles; >= 0. With 0, only angles matter,
  /// and an extremity shrinks exponentially with the ratio of its length to its girth.
  double AreaWeight = 0.0;
};

struct ParameterizeResult
{
  /// n x 3: the image of each point; for Orbifold, a point on the cut has several images, of which
  /// this is one
  Eigen::MatrixXd Positions;
  /// Orbifold: the surface cut open, on which the map is defined; else empty
  CutSurface Cut;
  Eigen::MatrixXd CutPositions; ///< Orbifold: the image of each point of the cut surface
  std::string Method;           ///< name of the method that computed the image, in one word
  /// number of iterations of the method; 0 if it solves one linear system; for a hyperbolic
  /// Orbifold, Newton steps
  int Iterations = 0;
  /// Sphere: number of points that were reinserted to repair flipped triangles
  int ReinsertedPoints = 0;
  /// number of flipped triangles in the image: always 0, because Parameterize throws otherwise
  int FlippedTriangles = 0;
  /// Disk, FreeBoundary: length of the longest boundary loop, in the surface's units
  double LoopLength = 0.0;
  /// Area-weighted mean of the measure of Refine before and after the refinement; 0 without it. An
  /// exponential measure is lowered from the result with SymmetricDirichlet.
  double MeasureBefore = 0.0, MeasureAfter = 0.0;
  double ConformalDistortion = 1.0; ///< area-weighted mean; 1 if every angle is preserved
  /// Area-weighted mean of the symmetric Dirichlet energy; its minimum is 4, for an isometry. For
  /// Disk and Orbifold, the surface is first scaled to the image's area. The value is at most
  /// LargestMeasure. It is 0 for the Sphere.
  double Energy = 0.0;
};

/**
 * Maps a surface onto a simple domain without flipping a triangle. The map preserves orientation: a
 * closed surface that faces inwards has an image that faces inwards.
 *
 * landmarks: k x 3. For the Orbifold, these are three or more positions; the points of the surface
 * nearest to them become its cones, in this order. With five or more, the orbifold is hyperbolic
 * (MapToHyperbolicOrbifold), and its image is in the Poincare disk, of radius 1. For other domains,
 * landmarks is empty.
 *
 * Throws InvalidInput if the surface or the landmarks do not fit the domain, or RefineExponent is
 * not positive. Throws SolveFailure if a triangle would be flipped or an exponential measure
 * exceeds the range of double, and Aborted.
 */
ParameterizeResult Parameterize(const Surface& surface, const Eigen::MatrixXd& landmarks,
  const ParameterizeOptions& options = {}, const Progress& progress = {});

/// Parameterizes without landmarks.
ParameterizeResult Parameterize(
  const Surface& surface, const ParameterizeOptions& options = {}, const Progress& progress = {});

} // namespace shape
