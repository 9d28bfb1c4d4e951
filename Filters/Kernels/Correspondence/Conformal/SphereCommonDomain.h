#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <vector>

namespace shape
{

struct SphereCommonDomainOptions
{
  int Steps = 16; ///< steps in which the landmarks move to their targets if no triangle flips; >= 1
  int RelaxationSweeps = 20; ///< relaxation sweeps over all other points afterwards; >= 0
};

struct SphereCommonDomainResult
{
  SurfacePoints AToB; ///< one for each point of A, on triangles of B
  /// one for each point of B, on triangles of A
  SurfacePoints BToA;
  Eigen::MatrixXd SphereA; ///< n x 3: A on the unit sphere, its landmarks at those of B
  Eigen::MatrixXd SphereB; ///< k x 3: B on the unit sphere, as MapToSphere maps it
};

/**
 * Computes the map between two closed surfaces of genus 0 that takes any number of landmarks to
 * landmarks. The map is one to one and keeps orientation.
 *
 * Both surfaces are mapped to the unit sphere (MapToSphere). A is rotated to minimise the sum of
 * squared distances between its landmarks and those of B. Then A is warped: its points flow along a
 * smooth field that takes the landmarks to their targets. The field is a sum of Gaussians around
 * the landmarks, as wide as the distance between these. Each step is halved until no spherical
 * triangle flips. Finally all points except the landmarks are relaxed towards the shapes that their
 * triangles have on A (RelaxOnSphere).
 *
 * a, b: both facing outwards, or both inwards. landmarksA, landmarksB: equally many distinct
 * points, at least one on each surface. Throws InvalidInput if they are not, and what MapToSphere
 * throws. Throws SolveFailure if the steps become too small for the landmarks to arrive, which
 * means that their order around some point differs too much. Throws Aborted.
 */
SphereCommonDomainResult MapThroughSphere(const Surface& a, const std::vector<int>& landmarksA,
  const Surface& b, const std::vector<int>& landmarksB,
  const SphereCommonDomainOptions& options = {}, const Progress& progress = {});

/// Returns where directions (n x 3, not 0) hit a closed surface around the origin. Its triangles
/// all face outwards and cover the sphere once. Throws Aborted.
SurfacePoints LocateDirections(
  const Surface& sphere, const Eigen::MatrixXd& directions, const Progress& progress = {});

} // namespace shape
