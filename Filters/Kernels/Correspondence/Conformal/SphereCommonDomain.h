#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <vector>

namespace shape
{

struct SphereCommonDomainOptions
{
  int Steps = 16;            ///< in which landmarks move to their goals if nothing flips; >= 1
  int RelaxationSweeps = 20; ///< of all other points, when the landmarks are there; >= 0
};

struct SphereCommonDomainResult
{
  SurfacePoints AToB; ///< of the points of A, on triangles of B
  SurfacePoints BToA;
  Eigen::MatrixXd SphereA; ///< n x 3: A on the unit sphere, its landmarks where those of B are
  Eigen::MatrixXd SphereB; ///< k x 3: the map of B as it is
};

/**
 * The map between two closed surfaces of genus 0 that takes any number of landmarks to landmarks:
 * one to one, orientation kept. Both go to the unit sphere (MapToSphere), A is rotated so that the
 * sum of squared distances of its landmarks from B's is minimal, and then warped: its points flow
 * along a smooth field that takes the landmarks on, sums of Gaussians around them, as wide as the
 * landmarks are apart; each step is halved until no spherical triangle flips. In the end points
 * that are no landmarks are relaxed towards the shapes that their triangles have on A
 * (RelaxOnSphere).
 *
 * a, b: both facing outwards, or both inwards. landmarksA, landmarksB: different points, as many of
 * the one as of the other, at least one.
 * Throws InvalidInput if they are not, and as MapToSphere; SolveFailure if the steps become so
 * small that the landmarks do not arrive: then their order around some point differs too much.
 * Aborted.
 */
SphereCommonDomainResult MapThroughSphere(const Surface& a, const std::vector<int>& landmarksA,
  const Surface& b, const std::vector<int>& landmarksB,
  const SphereCommonDomainOptions& options = {}, const Progress& progress = {});

/// Where directions (n x 3, not 0) hit a closed surface around the origin whose triangles all face
/// outwards and cover the sphere once. Throws Aborted.
SurfacePoints LocateDirections(
  const Surface& sphere, const Eigen::MatrixXd& directions, const Progress& progress = {});

} // namespace shape
