#pragma once

#include "Distance/SignedDistance.h"
#include "Harmonic/PointCharges.h"

#include <optional>

namespace shape
{

struct InverseMapOptions
{
  double Tolerance = 1e-11;   ///< of |f(x) - y| / the longest side of the image; > 0
  int MaximumIterations = 50; ///< of Newton's method from one start; >= 1
  int SeedsAcross = 16;       ///< places tried as starts along the longest side of the domain; >= 1
};

/**
 * The preimages of points under a charge set's map f, inside the domain that a closed surface
 * bounds: x with f(x) = y, by Newton's method with the analytic derivative, each step halved until
 * it comes closer.
 *
 * It starts from the seed whose image is nearest: a lattice of places in the domain, and the place
 * on the boundary whose image is closest to y. Where that fails, the way is walked in steps: x
 * follows as its image moves in a straight line from the start's to y, first from the boundary,
 * along which no other boundary point's image comes in between, then from the nearest inner seed;
 * at last, from the next seeds.
 * Where f folds, a point has several preimages: one of them is found, always the same.
 *
 * A point is outside the image where it lies outside the boundary's image (by more than the
 * edges there) and the derivative's determinant has one sign at all seeds, boundary points and
 * random places on the boundary; otherwise it is searched for. Keeps copies; used from any thread.
 */
class InverseMap
{
public:
  /// domain: closed and consistently oriented (the caller has checked). farthest: how far outside
  /// it a preimage may lie, see FindPointsOutsideDomain. Throws InvalidInput for options out of
  /// range or a map that is not finite on the boundary; Aborted.
  InverseMap(const ChargeSet& map, const Surface& domain, double farthest,
    const InverseMapOptions& options = {}, const Progress& progress = {});

  enum class State
  {
    Found = 0,
    Outside = 1, ///< of the image, or so close to its boundary that there is no preimage inside
    Missed = 2   ///< inside the boundary's image, but no start led to a preimage in the domain
  };
  struct Result
  {
    Eigen::MatrixXd Points; ///< n x 3: the preimage; the point itself where none was found
    Eigen::VectorXi States; ///< n: a State
  };

  /// points: n x 3, finite. Throws Aborted.
  Result Find(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// Where the search for the preimage of a point begins; none where it is Outside by its distance
  /// to the image alone.
  std::optional<Eigen::RowVector3d> Start(const Eigen::RowVector3d& point) const;

  /// Whether the determinant of the derivative changes its sign, or vanishes, where it was sampled.
  bool Folds() const { return this->DeterminantChangesSign; }

private:
  PointCharges Map;
  InverseMapOptions Options;
  double Farthest;
  SignedDistance Domain;
  SignedDistance Image; ///< of the domain's boundary
  Eigen::MatrixXd Seeds;
  Eigen::MatrixXd SeedImages;
  bool DeterminantChangesSign = false;
};

} // namespace shape
