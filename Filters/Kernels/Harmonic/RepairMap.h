#pragma once

#include "Base/Progress.h"
#include "Harmonic/Certificate.h"
#include "Harmonic/PiecewiseHarmonicMap.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <string>

namespace shape
{

struct RepairMapOptions
{
  /// Approximate number of tetrahedra that fill the solid; > 0. There are more if the boundary has
  /// many triangles.
  int Tetrahedra = 200000;
  /// Maximum number of times that the core is untangled; >= 1. In between its parts with inverted
  /// tetrahedra grow by 1, 2, 4, ... layers. The repair ends sooner after two times without a new
  /// best result.
  int MaximumRounds = 8;
  /// If a larger share of the volume stays inverted, the map is replaced everywhere; >= 0. With
  /// 1e-4, about one cell in a mesh of 10,000 may be inverted by the map that is kept.
  double MaximumInvertedShare = 1e-4;
  /// Of the map before the repair. A few boxes find the folds.
  MapCertificateOptions Certificate = { MapCertificateOptions().Tolerance, 200000 };
};

struct RepairMapResult
{
  MapRepair Repair; ///< without tetrahedra if the map folds nowhere
  // Shares of the solid's volume, which sum to 1, before and after the repair (MapCertificate).
  double CertifiedBefore = 0.0, InvertedBefore = 0.0, UndecidedBefore = 0.0;
  double CertifiedShare = 0.0, InvertedShare = 0.0, UndecidedShare = 0.0;
  double CoreShare = 0.0; ///< share of the volume in which the map is replaced
  double RingShare = 0.0; ///< share of the volume in which it is blended
  int Rounds = 0;         ///< see MaximumRounds
  /// Of the boundary's image (CountCrossings), if tetrahedra stay inverted; else 0. If there are
  /// any, every map of the solid folds or is not one to one.
  int ImageCrossings = 0;
  /// Why the solid could not be filled with tetrahedra, so that the map stays as it is; else empty.
  std::string Unfilled;
};

/**
 * Replaces a harmonic map f where it folds, and proves that the result does not fold.
 *
 * 1. CertifyMap covers the solid with boxes. The solid is filled with tetrahedra. Those that meet a
 *    box that is not certified are the core, with all that share a point with them.
 * 2. The ring are the other tetrahedra that share a point with the core. In the ring the result is
 *    g = h + phi (f - h) (MapRepair): h is linear between the values of f at the corners, and phi
 *    is 0 at the core and 1 elsewhere. det J_g > 0 is proven by bounds in cubes. Where this fails,
 *    the core grows, until the whole ring is certified. It also grows where its boundary touches
 *    itself, and where the image of its boundary crosses itself, if that may help.
 * 3. In the core g = h. Points between core and ring keep their images by f; the others on the
 * boundary get the prescribed images. Inner points near inverted tetrahedra start at a harmonic
 * map between those around, if it inverts only a few, or much fewer, and Untangle moves the
 * points. Each connected part of the core is untangled by itself. If tetrahedra stay inverted, the
 * image of the part is filled with new ones, which are mapped to the part. The parts that still
 * have inverted tetrahedra grow, up to the whole solid, unless the prescribed image of their
 * boundary crosses itself. The best of these repairs is returned.
 *
 * 4. If more than MaximumInvertedShare is still inverted, and the image of the boundary does not
 *    cross itself, the map is replaced everywhere by one that is linear in tetrahedra as large as
 *    the boundary permits (RepairWhole), unless that inverts some, too.
 *
 * A tetrahedron of the core is certified if it and its image are positive by exact predicates.
 * Outside core and ring, f is unchanged, and all boxes are certified. The images as given, with
 * rounding, are those of the repair, so the proof is about the map that is stored. If everything is
 * certified and the map is injective on the boundary, it is bijective (CertifyMap).
 *
 * The work is bounded by counts, and that of Tetrahedralize, too. It may add points on the
 * triangles; only if that fails, it may not. If that fails, too, the map stays as it is.
 *
 * domain: closed, facing out of the solid. targets: n x 3, the images of its points, for the core;
 * empty: the images by f. Throws InvalidInput if an option is out of range, the number of targets
 * is wrong or the domain crosses itself; the exceptions of CertifyMap, FillWithElements and
 * Untangle.
 */
RepairMapResult RepairMap(const ChargeSet& map, const Surface& domain,
  const Eigen::MatrixXd& targets = {}, const RepairMapOptions& options = {},
  const Progress& progress = {});

} // namespace shape
