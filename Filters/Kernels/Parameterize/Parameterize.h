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
  /// What the surface is mapped onto.
  enum class DomainType
  {
    Disk = 0,         ///< of a surface with one boundary loop: shape::MapToDisk
    Sphere = 1,       ///< of a closed surface of genus 0, the unit sphere: shape::MapToSphere
    FreeBoundary = 2, ///< of a surface with boundary loops, the plane: shape::MapWithFreeBoundary
    Orbifold = 3      ///< of a closed surface of genus 0, cut open: shape::MapToOrbifold
  };
  DomainType Domain = DomainType::Sphere;
  /// Disk: by which weights a point is the mean of its neighbours.
  CombinationWeights Weights = DiskMapOptions().Weights;
  /// Disk: what the boundary loop becomes.
  DiskOutline Outline = DiskMapOptions().Outline;
  /// Disk and FreeBoundary: whether the image is made less distorted.
  enum class RefineType
  {
    None = 0,
    SymmetricDirichlet = 1 ///< shape::RefineInjectively, the Disk's outline fixed
  };
  RefineType Refine = RefineType::None;
  /// Orbifold with three landmarks; with four it is a parallelogram. Rhombus treats them alike.
  OrbifoldType Tile = OrbifoldType::Rhombus;
  /// Sphere: equal areas against equal angles: 0 = angles alone (an extremity shrinks exponentially
  /// with its length over its girth), larger = areas count more; >= 0.
  double AreaWeight = 0.0;
};

struct ParameterizeResult
{
  Eigen::MatrixXd Positions;    ///< n x 3: where each point goes; of a point on the cut: itself
  CutSurface Cut;               ///< Orbifold: the surface that has the image; else empty
  Eigen::MatrixXd CutPositions; ///< Orbifold: where each point of the cut surface goes
  std::string Method;           ///< what gave every point its position, in one word
  int Iterations = 0;           ///< of that method; 0 where it solves one linear system
  int ReinsertedPoints = 0;     ///< points that needed a second method
  int FlippedTriangles = 0;     ///< of the image: 0, else it throws
  double LoopLength =
    0.0; ///< Disk, FreeBoundary: of the longest boundary loop, in the surface's units
  double ConformalDistortion = 1.0; ///< mean over the surface's area; 1 keeps every angle
  /// Mean symmetric Dirichlet energy over the surface's area: 4, the minimum, if lengths stay.
  /// Disk and Orbifold: of the surface scaled to the image's area. At most LargestMeasure; 0 on the
  /// Sphere.
  double Energy = 0.0;
};

/**
 * Maps a surface onto a simple domain without flipping a triangle. The image of a closed surface
 * that faces inwards faces inwards, too: the map mirrors nothing.
 *
 * landmarks: k x 3, for the Orbifold three or four positions near different points of the surface,
 * which become its cones in this order; for other domains none.
 *
 * Throws InvalidInput if the surface is not of the kind that the domain needs, or the landmarks
 * are not; SolveFailure if a triangle would be flipped, Aborted.
 */
ParameterizeResult Parameterize(const Surface& surface, const Eigen::MatrixXd& landmarks,
  const ParameterizeOptions& options = {}, const Progress& progress = {});

/// The same without landmarks.
ParameterizeResult Parameterize(
  const Surface& surface, const ParameterizeOptions& options = {}, const Progress& progress = {});

} // namespace shape
