#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfaceCut.h"
#include "Parameterize/OrbifoldTile.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A closed surface, cut open and mapped to the tile of an orbifold.
struct OrbifoldImage
{
  CutSurface Cut;         ///< the surface cut along the path through the cones
  Eigen::MatrixXd Points; ///< k x 2: images of the cut surface's points
  std::vector<int> Cones; ///< the cones, as point numbers of the uncut surface
  OrbifoldTile Tile;      ///< the tile, with the positions of the cones
  /// number of flipped triangles in the image: always 0, because MapToOrbifold throws otherwise
  int FlippedTriangles = 0;
};

/**
 * Computes the Euclidean orbifold Tutte embedding (Aigerman and Lipman 2015). Every point except
 * the cones is the weighted mean of its neighbours. In this mean, a neighbour across the cut is
 * moved by the leg's isometry. So the images of the tile under the group cover the plane once
 * without a flip. Deforming the cut without crossing a cone does not change the embedding. With
 * three cones, the embedding does not depend on the cut at all. Weights are cotangents; those below
 * 0.01 are raised to 0.01, so all are positive.
 *
 * cones: GetConeCount(type) different points. For Square, the second cone has the total angle pi.
 * For Triangle, the angles are pi / 3, 2 pi / 3 and pi, in this order.
 *
 * Throws InvalidInput if the surface is not closed, or has several components, genus > 0 or unused
 * points. Also throws InvalidInput if the number of cones is wrong, two cones are the same, or the
 * mesh is too coarse for a path through them. Throws SolveFailure if triangles are too small to
 * determine their orientation. An extremity shrinks exponentially with the ratio of its length to
 * its girth. Throws Aborted.
 */
OrbifoldImage MapToOrbifold(const Surface& surface, const std::vector<int>& cones,
  OrbifoldType type, const Progress& progress = {});

/// Maps the points of an image of type Rectangle linearly to the parallelogram of the same area on
/// which the image is most conformal. Returns the new points (k x 2). The line through the first
/// two cones stays parallel to y. A linear map commutes with the group's half turns, so the result
/// is again an orbifold embedding.
Eigen::MatrixXd FitToBestParallelogram(const OrbifoldImage& image);

} // namespace shape
