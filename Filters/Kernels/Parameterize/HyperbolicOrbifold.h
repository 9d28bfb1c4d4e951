#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfaceCut.h"
#include "Parameterize/HyperbolicTile.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A closed surface, cut open and mapped to the tile of a hyperbolic orbifold.
struct HyperbolicImage
{
  CutSurface Cut; ///< the surface cut along the path through the cones
  /// k x 3: images of the cut surface's points on the hyperboloid (HyperbolicTile.h).
  Eigen::MatrixXd Points;
  std::vector<int> Cones; ///< the cones, as point numbers of the uncut surface
  HyperbolicTile Tile;    ///< the tile, with the positions of the cones
  /// For each half-edge of the surface: l + 1 if it lies on the forward path's leg l, -l - 1 if it
  /// lies on the leg's return path, and 0 if it is not cut. The triangle on the other side of a
  /// half-edge with l + 1 has its image beside this one after the inverse of Legs[l].
  std::vector<int> Cuts;
  double Energy = 0.0; ///< HyperbolicEnergy::Value, at its minimum
  int Iterations = 0;  ///< Newton steps
};

/**
 * Computes the hyperbolic orbifold Tutte embedding (Aigerman and Lipman 2016) of a surface with
 * n >= 5 cones, each of the total angle pi. The map is harmonic: it minimizes HyperbolicEnergy,
 * where a neighbour across the cut is moved by the leg's isometry. Weights are cotangents; those
 * below 0.01 are raised to 0.01. All are positive, so every point but the cones lies inside the
 * convex hull of its neighbours. Therefore the images of the tile under the group cover the
 * hyperbolic plane once without a flip, as in the theorem of Tutte.
 *
 * The minimum is unique. Deforming the cut without crossing a cone does not change the embedding.
 * Neither does closing the path by a leg from the last cone to the first, and opening it at another
 * leg: the embedding depends on the closed curve through the cones only, up to deformation. The
 * energy is minimized by Newton's method with backtracking, from the map of weighted means onto the
 * convex tile in the Klein model.
 *
 * cones: different points, in the order of the path. Throws InvalidInput if the surface is not
 * closed, or has several components, genus > 0 or unused points; if there are fewer than five
 * cones or two are the same; or if the mesh is too coarse for a path through them. Throws
 * SolveFailure if triangles are too small to determine their orientation. An extremity without a
 * cone shrinks exponentially with the ratio of its length to its girth. Throws Aborted.
 */
HyperbolicImage MapToHyperbolicOrbifold(
  const Surface& surface, const std::vector<int>& cones, const Progress& progress = {});

/// The same, cut along the given path, whose stops are the cones.
HyperbolicImage MapToHyperbolicOrbifold(
  const Surface& surface, const EdgePath& path, const Progress& progress = {});

} // namespace shape
