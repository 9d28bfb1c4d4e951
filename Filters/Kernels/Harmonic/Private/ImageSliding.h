#pragma once

#include "Base/Progress.h"
#include "Harmonic/Private/HarmonicDistortion.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Slides the images of boundary points on a surface to lower the mean symmetric Dirichlet energy of
 * the harmonic map that they determine. The images are the only unknowns: the map is linear in
 * them, by linear finite elements (FiniteElementMap.h).
 *
 * The gradient is that of HarmonicDistortion. Steps follow the limited-memory BFGS method (Nocedal
 * and Wright, "Numerical optimization", 2006, algorithm 7.4) in the tangent planes of the target;
 * images are projected back onto it. The first approximation of the inverse Hessian is that of the
 * Dirichlet energy: (K + M / l^2)^-1 restricted to the boundary, where M are the lumped volumes and
 * l is the longest side. The determinant in the energy is regularised as in EllipticEnergy, so that
 * inverted tetrahedra can become positive. If there are some at the start, the images first slide
 * to lower the elliptic energy.
 *
 * solid: scaled so that solid and target have the same volume. images: k x 3. Returns the images
 * after sliding, on the target. Throws SolveFailure if tetrahedra are so flat that the matrices
 * cannot be factorised; Aborted.
 */
Eigen::MatrixXd SlideImages(const FilledSolid& solid, const Eigen::MatrixXd& images,
  const Surface& target, const Progress& progress = {});

} // namespace shape
