#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <vector>

namespace shape
{

struct SphereCommonDomainOptions
{
  /// Number of steps in which the landmarks move to their targets; >= 1. If a step would flip a
  /// triangle, more and smaller steps are used.
  int Steps = 16;
  int RelaxationSweeps = 20; ///< sweeps over all other points after the last step; >= 0
};

struct SphereCommonDomainResult
{
  SurfacePoints AToB; ///< the image of each point of A, on triangles of B
  /// The image of each point of B, on triangles of A.
  SurfacePoints BToA;
  Eigen::MatrixXd SphereA; ///< n x 3: A on the unit sphere; its landmarks lie at B's landmarks
  Eigen::MatrixXd SphereB; ///< k x 3: B on the unit sphere, as MapToSphere maps it
};

/**
 * Computes a one-to-one map between two closed surfaces of genus 0 that takes any number of
 * landmarks to their partners. The map keeps orientation.
 *
 * Both surfaces are mapped to the unit sphere (MapToSphere). A is rotated to minimise the sum of
 * squared distances between its landmarks and their partners. Then A is warped: its points flow
 * along a smooth field that takes the landmarks to their targets. The field is a sum of Gaussians
 * around the landmarks. Their width is the minimum distance between two landmarks. Each step is
 * halved until no spherical triangle flips. Finally, RelaxOnSphere moves all points except the
 * landmarks, which brings the shapes of the spherical triangles closer to the shapes of A's
 * triangles.
 *
 * a, b: closed surfaces of genus 0, both facing outwards or both inwards. landmarksA, landmarksB:
 * indices of points, at least one and equally many on both surfaces. No point occurs twice. Throws
 * InvalidInput if the input is not as required, and the exceptions of MapToSphere. Throws
 * SolveFailure if the steps become too small for the landmarks to arrive, usually because the order
 * of the landmarks around some point differs between the surfaces. Throws Aborted.
 */
SphereCommonDomainResult MapThroughSphere(const Surface& a, const std::vector<int>& landmarksA,
  const Surface& b, const std::vector<int>& landmarksB,
  const SphereCommonDomainOptions& options = {}, const Progress& progress = {});

/// Returns the point at which each ray from the origin hits a closed surface around it. sphere: a
/// surface that each ray hits once, with all triangles facing outwards. directions: n x 3, each not
/// 0. Throws Aborted.
SurfacePoints LocateDirections(
  const Surface& sphere, const Eigen::MatrixXd& directions, const Progress& progress = {});

} // namespace shape
