#pragma once

#include "Base/Progress.h"
#include "Correspondence/Conformal/Private/MoebiusMap.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// A discrete conformal map of a closed surface of genus 0 onto the complex plane and infinity: z =
/// exp(2 pi (Harmonic + i Conjugate)). `From` goes to 0, and `To` to infinity.
struct MidEdgeMap
{
  /// m x 3: the edge from corner k of triangle t to the next corner
  Eigen::MatrixXi EdgeOf;
  ///@{
  /// e values: at the midpoint of each edge. The conjugate function changes by 1 or -1
  /// around `To`, so it is defined up to integers.
  Eigen::VectorXd Harmonic, Conjugate;
  ///@}
  /// n x 2: the places of the surface's points, as points of the complex projective line
  ComplexPoints Points;
};

/**
 * Maps the midpoints of a surface's edges conformally to the plane (Lipman and Funkhouser, "Moebius
 * voting for surface correspondence", 2009, section 4; Pinkall and Polthier, "Computing discrete
 * minimal surfaces and their conjugates", 1993).
 *
 * The harmonic function has a source at the point `to` and a sink at the point `from`, each of
 * strength 1: cotangent Laplacian times function = 1 at `to`, -1 at `from` and 0 elsewhere. On each
 * triangle, the gradient of the conjugate function is that of the harmonic function, turned by 90
 * degrees. Such functions fit together at the midpoints of edges, where both are continuous. So
 * each triangle between the midpoints of a triangle's edges is mapped by a similarity. The paper
 * leaves out a triangle, and the image is a strip around a slit. Here no triangle is left out:
 * around the source, the conjugate function grows by the whole flux, and the exponential function
 * closes the strip.
 *
 * A point's place is the mean of the midpoints of its edges, before exp. Places are defined up to
 * a Moebius map, which depends on `from` and `to`.
 *
 * surface: a closed, consistently oriented 2-manifold of one component and genus 0, with a triangle
 * at each point. from, to: different points. Throws InvalidInput if they are equal; SolveFailure;
 * Aborted.
 */
MidEdgeMap FlattenMidEdges(const Surface& surface, int from, int to, const Progress& progress = {});

} // namespace shape
