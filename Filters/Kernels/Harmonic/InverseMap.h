#pragma once

#include "Distance/SignedDistance.h"
#include "Harmonic/PointCharges.h"

#include <optional>

namespace shape
{

struct InverseMapOptions
{
  double Tolerance = 1e-11;   ///< maximum of |f(x) - y| / longest side of the image's box; > 0
  int MaximumIterations = 50; ///< maximum number of Newton steps from one start; >= 1
  int SeedsAcross = 16;       ///< number of seeds along the longest side of the domain; >= 1
};

/**
 * Inverts the map f of a charge set: for each point y it finds a preimage x, f(x) = y, in the
 * domain bounded by a closed surface. It uses Newton's method with the analytic derivative. Each
 * step is halved until it decreases |f(x) - y|.
 *
 * The seeds are the points of a lattice inside the domain. The first start is the seed or the
 * boundary position whose image is nearest to y. If Newton's method fails, x follows a path whose
 * image is the straight line from f(start) to y. The first path starts at the boundary position
 * whose image is nearest to y, so no other boundary image lies on the line. The second path starts
 * at the nearest seed. Finally, Newton's method is tried from further seeds. Where f folds, a point
 * has several preimages. Find returns only one of them, the same one in each call.
 *
 * A point is Outside without a search if two conditions hold. First, it lies outside the boundary's
 * image by more than 4 times the tolerance of ComputeDomainTolerances. Second, the determinant of
 * the derivative has the same sign at all seeds, boundary points and random boundary positions. The
 * object copies its input and can be used from several threads.
 */
class InverseMap
{
public:
  /// domain: closed and consistently oriented (checked by the caller). farthest: the maximum
  /// distance of a preimage outside the domain (FindPointsOutsideDomain). Throws InvalidInput if an
  /// option is out of range or the map is not finite on the boundary; Aborted.
  InverseMap(const ChargeSet& map, const Surface& domain, double farthest,
    const InverseMapOptions& options = {}, const Progress& progress = {});

  enum class State
  {
    Found = 0,
    Outside = 1, ///< outside the image, or so close to its boundary that the preimage is outside
    Missed = 2   ///< inside the boundary's image, but no start led to a preimage in the domain
  };
  struct Result
  {
    Eigen::MatrixXd Points; ///< n x 3: the preimage, or the point itself if none was found
    Eigen::VectorXi States; ///< n: the State of each point
  };

  /// Finds the preimages of points (n x 3, finite). Throws Aborted.
  Result Find(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// Returns the position where the search for the preimage of `point` starts, or nothing if the
  /// point is found to be Outside without a search.
  std::optional<Eigen::RowVector3d> Start(const Eigen::RowVector3d& point) const;

  /// Whether the determinant of the derivative changes sign or vanishes among the sampled
  /// positions.
  bool Folds() const { return this->DeterminantChangesSign; }

private:
  PointCharges Map;
  InverseMapOptions Options;
  double Farthest;
  SignedDistance Domain;
  SignedDistance Image; ///< distance to the image of the domain's boundary
  Eigen::MatrixXd Seeds;
  Eigen::MatrixXd SeedImages;
  bool DeterminantChangesSign = false;
};

} // namespace shape
