#pragma once

#include "Base/Progress.h"
#include "Harmonic/CertificateTypes.h"
#include "Harmonic/ChargeSet.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * Proves that a harmonic map is locally injective, det J > 0 at every position of a domain, or
 * finds where it is not.
 *
 * The domain is covered by cubes. In the box around the part of each cube inside the domain, the
 * map is expanded into its Taylor polynomial around the centre, with a bound of the remainder
 * (TaylorExpansion.h). With J(centre) = U S V', the factors L = S^-1/2 U' and R = V S^-1/2, and
 * every position x of the box,
 *
 *   L J(x) R = P(x) + E(x),  P of degree 3, |E(x)| <= |L| (bounds of higher terms, remainders) |R|.
 *
 * If the symmetric part of L J(x) R is positive definite for all x, det J has the sign of det L R
 * in the box. P is in the convex hull of its control matrices in Bernstein's basis. The smallest
 * eigenvalue of the symmetric part is concave, so the control matrices suffice; the sums of the
 * rows of |E| are subtracted from the diagonal. |det J| >= det(symmetric part) / |det L R|
 * (Ostrowski and Taussky, "On the variation of the determinant of a positive definite matrix",
 * 1951). Other cubes are divided into eight, those with the largest part inside first. Sampling
 * with Lipschitz bounds is by Chien, Chen and Weber, "Bounded distortion harmonic shape
 * interpolation" (2016), in the plane.
 *
 * Charges are outside the domain, at a positive distance, so cubes near the surface can be decided
 * when they are small compared with this distance. Rounding errors are part of all bounds. Eight
 * neighbours with the same state become one box again.
 *
 * If every box is certified, the map is a local homeomorphism of the closed domain. If it is
 * injective on the boundary, too, every position of the image has one preimage: the number of
 * preimages is the degree of the map, which is constant between the boundary's images, is 0
 * outside, and changes by one across each. Bijective assumes this for the triangles between the
 * images of the boundary's points: it does not see crossings smaller than their distance from the
 * curved image. The map is that of the charges, whose boundary values differ from the prescribed
 * ones by the error of their fit.
 *
 * domain: closed, not crossing itself, facing out of the solid (OrientByNesting). Throws
 * InvalidInput if an option is out of range; Aborted.
 */
MapCertificate CertifyMap(const ChargeSet& map, const Surface& domain,
  const MapCertificateOptions& options = {}, const Progress& progress = {});

/// Returns the number of pairs of triangles that cross or touch in the image of a boundary. If
/// there are triangles without area, returns their number. Throws Aborted.
int CountCrossings(const Surface& image, const Progress& progress = {});

} // namespace shape
