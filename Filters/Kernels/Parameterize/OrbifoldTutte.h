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
  std::vector<int> Cones; ///< the cones as points of the uncut surface
  OrbifoldTile Tile;      ///< the tile; it contains the images of the cones
  /// flipped triangles of the image: always 0, otherwise the function throws
  int FlippedTriangles = 0;
};

/**
 * Computes the Euclidean orbifold Tutte embedding (Aigerman and Lipman 2015). Every point except
 * the cones is the weighted mean of its neighbours; a neighbour across the cut is first moved by
 * the leg's isometry. So the images of the tile under the group cover the plane once without a
 * flip. The embedding does not depend on the exact position of the cut; with three cones it does
 * not depend on the course of the path either. Weights are cotangents; those below 0.01 are raised
 * to 0.01, so all are positive.
 *
 * cones: GetConeCount(type) different points. For Square the second has the angle pi; for Triangle
 * the first has pi / 3, the second 2 pi / 3, the third pi.
 *
 * Throws InvalidInput if the surface is not closed, has several components, genus > 0 or unused
 * points. Throws InvalidInput, too, if the number of cones is wrong, two are the same, or the mesh
 * is too coarse for a path between them. Throws SolveFailure if triangles are too small to
 * determine their orientation: an extremity shrinks exponentially with its length over its girth.
 * The factorisation is one library call that cannot be interrupted. Throws Aborted.
 */
OrbifoldImage MapToOrbifold(const Surface& surface, const std::vector<int>& cones,
  OrbifoldType type, const Progress& progress = {});

/// Returns the points of an image on a Rectangle, mapped linearly to the parallelogram of the same
/// area on which the image is most conformal. The first two cones stay on a line along y. A linear
/// map commutes with the group's half turns, so the result is again an orbifold embedding.
Eigen::MatrixXd FitToBestParallelogram(const OrbifoldImage& image);

} // namespace shape
