#pragma once

#include <Eigen/Core>

namespace shape
{

struct MapCertificateOptions
{
  /// Edge of the smallest boxes / longest side of the domain's box: 1e-5 to 0.5. A box that is not
  /// decided is divided until its edge would be smaller. A box with a witness is divided until its
  /// edge is at most 1/256.
  double Tolerance = 1.0 / 4096.0;
  /// Maximum number of boxes that are examined; >= 1. Then the remaining boxes stay undecided.
  int MaximumBoxes = 1000000;
};

/// Cubes that cover a domain, and what is proven about the Jacobian determinant in each.
struct MapCertificate
{
  enum class BoxState
  {
    Inverted = -1, ///< det J <= 0 at a position in the box: the witness, or the whole box
    Undecided = 0,
    Certified = 1 ///< det J > 0 at every position of the domain in the box
  };
  Eigen::MatrixXd Centres; ///< k x 3
  Eigen::VectorXd Edges;   ///< k
  Eigen::VectorXi States;  ///< k: BoxState
  Eigen::VectorXd Volumes; ///< k: of the part of the box inside the domain
  /// k values. Of a certified box: a lower bound of det J, > 0. Of an inverted box: det J at its
  /// witness or, without one, an upper bound; <= 0. Of an undecided box: 0.
  Eigen::VectorXd Determinants;
  Eigen::MatrixXd Witnesses;           ///< w x 3: positions in the domain where det J <= 0
  Eigen::VectorXd WitnessDeterminants; ///< w: det J there
  // Shares of the domain's volume, which sum to 1.
  double CertifiedShare = 0.0, InvertedShare = 0.0, UndecidedShare = 0.0;
  int ExaminedBoxes = 0;
  bool Complete = true; ///< false: MaximumBoxes ended the division of boxes
  /// Pairs of triangles of the boundary's image that cross or touch, and triangles without area.
  int BoundaryCrossings = 0;
  /// Whether the boundary's image has no crossings, and its components bound a solid in the same
  /// way as those of the boundary.
  bool BoundaryInjective = false;
  /// Whether the boundary's image encloses a negative volume, as that of a mirrored solid does. The
  /// integral of det J is this volume, so det J < 0 somewhere, whatever the map is inside.
  bool BoundaryReversed = false;
  /// Whether every box is certified and the boundary is injective.
  bool Bijective = false;
};

} // namespace shape
