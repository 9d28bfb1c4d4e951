#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfaceCut.h"
#include "Parameterize/OrbifoldTile.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A closed surface, cut open and laid out on the tile of an orbifold.
struct OrbifoldImage
{
  CutSurface Cut;           ///< along the path through the cones
  Eigen::MatrixXd Points;   ///< of the cut surface's points, k x 2
  std::vector<int> Cones;   ///< points of the uncut surface
  OrbifoldTile Tile;        ///< whose cones have these positions in the image
  int FlippedTriangles = 0; ///< of the image: 0, else it throws
};

/**
 * Euclidean orbifold Tutte embedding (Aigerman and Lipman 2015): every point but the cones is the
 * weighted mean of its neighbours, where across the cut a neighbour is seen moved by the leg's
 * motion. So the image and its images under the group cover the plane once without a flip: the
 * position of the cut does not show, and with three cones neither does its course. Weights are
 * cotangents, of which those below a hundredth are raised to it, so that all are positive.
 *
 * cones: GetConeCount(type) different points; of Square the second one has the angle pi, of
 * Triangle the first pi / 3, the second 2 pi / 3, the third pi.
 *
 * Throws InvalidInput if the surface is not closed, has several components, genus > 0 or points
 * that no triangle uses, if cones are too many, too few or not different, or if the mesh is
 * too coarse for a path between them; SolveFailure if triangles are too small to tell their
 * orientation: an extremity shrinks exponentially with its length over its girth. The factorisation
 * is one library call that cannot be interrupted. Throws Aborted.
 */
OrbifoldImage MapToOrbifold(const Surface& surface, const std::vector<int>& cones,
  OrbifoldType type, const Progress& progress = {});

/// Of an image on a Rectangle: stretched and sheared to the parallelogram on which it is most
/// conformal, of the same area, its first two cones along y as they were. Any linear map keeps what
/// the image is, since it commutes with the group's half turns.
Eigen::MatrixXd FitToBestParallelogram(const OrbifoldImage& image);

} // namespace shape
