#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfaceCut.h"
#include "Parameterize/DiskMap.h"
#include "Parameterize/OrbifoldTile.h"

#include <string>

namespace shape
{

struct ParameterizeOptions
{
  /// The target of the map.
  enum class DomainType
  {
    Disk = 0,         ///< a disk, for a surface with one boundary loop: shape::MapToDisk
    Sphere = 1,       ///< the unit sphere, for a closed surface of genus 0: shape::MapToSphere
    FreeBoundary = 2, ///< the plane, for a surface with boundary loops: shape::MapWithFreeBoundary
    Orbifold = 3      ///< an orbifold's tile, for a closed surface of genus 0: shape::MapToOrbifold
  };
  DomainType Domain = DomainType::Sphere;
  /// Disk: weights by which a point is the mean of its neighbours.
  CombinationWeights Weights = DiskMapOptions().Weights;
  /// Disk: image of the boundary loop.
  DiskOutline Outline = DiskMapOptions().Outline;
  /// Disk and FreeBoundary: whether the distortion of the image is lowered.
  enum class RefineType
  {
    None = 0,
    SymmetricDirichlet = 1 ///< shape::RefineInjectively; the Disk's outline is fixed
  };
  RefineType Refine = RefineType::None;
  /// Orbifold with three landmarks; Rhombus treats them alike. Four landmarks give a parallelogram.
  OrbifoldType Tile = OrbifoldType::Rhombus;
  /// Sphere: weight of equal areas relative to equal angles; >= 0. With 0 only angles matter, and
  /// an extremity shrinks exponentially with its length over its girth.
  double AreaWeight = 0.0;
};

struct ParameterizeResult
{
  /// n x 3: image of each point; Orbifold: for a point on the cut one of its images
  Eigen::MatrixXd Positions;
  CutSurface Cut;               ///< Orbifold: the cut surface, which is mapped; else empty
  Eigen::MatrixXd CutPositions; ///< Orbifold: image of each point of the cut surface
  std::string Method;           ///< name of the method that computed the image, in one word
  int Iterations = 0;           ///< number of its iterations; 0 if it solves one linear system
  int ReinsertedPoints = 0;     ///< number of points that needed a second method
  /// flipped triangles of the image: always 0, otherwise the function throws
  int FlippedTriangles = 0;
  double LoopLength =
    0.0; ///< Disk, FreeBoundary: of the longest boundary loop, in the surface's units
  double ConformalDistortion = 1.0; ///< mean over the surface's area; 1 if every angle is preserved
  /// Mean symmetric Dirichlet energy over the surface's area; the minimum, 4, is an isometry. For
  /// Disk and Orbifold the surface is first scaled to the image's area. At most LargestMeasure; 0
  /// on the Sphere.
  double Energy = 0.0;
};

/**
 * Maps a surface onto a simple domain without flipping a triangle. The map preserves orientation: a
 * closed surface that faces inwards has an image that faces inwards.
 *
 * landmarks: k x 3. For the Orbifold, three or four positions near different points of the surface,
 * which become its cones in this order; empty for other domains.
 *
 * Throws InvalidInput if the surface or the landmarks do not fit the domain, SolveFailure if a
 * triangle would be flipped, and Aborted.
 */
ParameterizeResult Parameterize(const Surface& surface, const Eigen::MatrixXd& landmarks,
  const ParameterizeOptions& options = {}, const Progress& progress = {});

/// Parameterizes without landmarks.
ParameterizeResult Parameterize(
  const Surface& surface, const ParameterizeOptions& options = {}, const Progress& progress = {});

} // namespace shape
