#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"
#include "Parameterize/HyperbolicOrbifold.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Maps each point of a surface to the point of another surface with the same place on the
 * hyperbolic orbifold on which both are laid out. a, b: their images, with equally many cones. The
 * first cones correspond, and so do the paths. From there on, places are found by walks from each
 * triangle to the next, both along surface A and, in the Klein model, through the triangles of
 * surface B. Where a walk crosses a cut, the isometry of the leg is applied. This finds the same
 * point as a search through all images of the tile, whose number grows exponentially with the
 * distance.
 *
 * Inside a triangle, a place is the combination of the corners on the hyperboloid, which isometries
 * do not change. So the result does not depend on the cut. A weight below 1e-9 is rounding, and
 * becomes 0. Of triangles too small for the digits of positions, one at most a thousandth of its
 * size away is taken. Throws SolveFailure if a walk does not end, because triangles are too small;
 * Aborted.
 */
SurfacePoints MapBetweenHyperbolicImages(const Surface& surfaceA, const HyperbolicImage& a,
  const Surface& surfaceB, const HyperbolicImage& b, const Progress& progress = {});

/**
 * Computes the seamless map between two closed surfaces of genus 0 through their images on one
 * hyperbolic orbifold, whose cones are five or more landmarks (Aigerman and Lipman 2016). The map
 * is one to one, keeps orientation, and takes each landmark exactly to its partner.
 *
 * Both surfaces are cut along a path through the landmarks in the same order. For any two such
 * paths there is a map of the surfaces that takes one to the other, so the order is all that must
 * agree. The order is that of the shortest path (FindShortestOrder), which does not depend on the
 * numbering of the landmarks. What can differ between the surfaces is the side on which a leg
 * passes other landmarks. The map then winds around them: it is still one to one, but stretched.
 * Therefore each leg on A is the shortest path along edges, and the leg on B follows it: edges
 * count the longer the more the distances of their ends from the landmarks differ from those along
 * the leg on A (EmbedByLandmarks). The map is unique among those that are deformations of each
 * other with the landmarks fixed. Deforming both paths does not change it.
 *
 * conesA, conesB: corresponding points, equally many, >= 5. Throws the exceptions of
 * MapToHyperbolicOrbifold, with the surface's name (A or B) in the message; Aborted.
 */
SurfaceMaps MapThroughHyperbolicOrbifold(const Surface& a, const std::vector<int>& conesA,
  const Surface& b, const std::vector<int>& conesB, const Progress& progress = {});

/// Returns the order of n points in which the path through all of them is as short as nearest
/// neighbours from each point, and then exchanges of two legs and moves of a point, can make it.
/// distances: n x n, symmetric. The same points in another numbering give the same path, unless
/// distances are equal.
std::vector<int> FindShortestOrder(const Eigen::MatrixXd& distances);

} // namespace shape
