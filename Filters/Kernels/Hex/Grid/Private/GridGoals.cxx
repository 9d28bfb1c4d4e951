#include "Hex/Grid/Private/GridGoals.h"

#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <limits>

namespace shape
{
namespace
{

/// The accepted distance as a fraction of the surface's diagonal.
constexpr double AcceptedShare = 0.01;
/// NearDistance as a multiple of AcceptedDistance.
constexpr double NearFactor = 2.0;

/// What creases add to the score where hexahedra follow nearly all of them: less than for all.
constexpr double PartlyKept = 0.5;

/// Returns the distance that the search reduces.
double DistanceThatCounts(const GridHexesResult& result)
{
  return result.InnerCreasesKept ? std::max(result.Fit.Distance, result.Fit.InnerDistance)
                                 : result.Fit.Distance;
}

} // namespace

GridGoals::GridGoals(const GridHexesOptions& options, double diagonal)
  : ScaledJacobian(options.WantedScaledJacobian)
  , Distance(options.WantedDistance * diagonal)
  , CreaseDistance(options.WantedCreaseDistance * diagonal)
  , AcceptedDistance(AcceptedShare * diagonal)
  , NearDistance(NearFactor * this->AcceptedDistance)
  , SnapFrom(options.Snap ? this->Distance : std::numeric_limits<double>::infinity())
{
}

bool Reaches(const GridHexesResult& result, double scaledJacobian, double distance)
{
  return result.Fit.MinimumScaledJacobian >= scaledJacobian &&
    DistanceThatCounts(result) <= distance;
}

bool IsAsWanted(const GridHexesResult& result, const GridGoals& goals)
{
  return Reaches(result, goals.ScaledJacobian, goals.Distance) &&
    result.Fit.Creases.Distance <= goals.CreaseDistance;
}

bool IsAccepted(const GridHexesResult& result, const GridGoals& goals)
{
  return Reaches(result, AcceptedScaledJacobian, goals.AcceptedDistance) ||
    (Reaches(result, 0.0, goals.AcceptedDistance) &&
      result.Fit.Creases.Distance <= goals.CreaseDistance &&
      FindMinimumScaledJacobianAwayFrom(result.Fit.Creases.CornerPoints, result.Fit.Solid) >=
        AcceptedScaledJacobian);
}

bool IsNear(const GridHexesResult& result, const GridGoals& goals)
{
  return Reaches(result, 0.0, goals.NearDistance);
}

double Score(const GridHexesResult& result, const GridGoals& goals)
{
  const HexFit& fit = result.Fit;
  if (fit.Inverted > 0)
  {
    return -fit.Inverted;
  }
  const bool accepted = Reaches(result, AcceptedScaledJacobian, goals.AcceptedDistance);
  return std::min(fit.MinimumScaledJacobian / goals.ScaledJacobian, 1.0) +
    std::min(goals.Distance / DistanceThatCounts(result), 1.0) +
    std::min(goals.CreaseDistance / fit.Creases.Distance, 1.0) + (accepted ? 1.0 : 0.0) +
    (fit.CreasesKept ? 1.0 : PartlyKept * result.FollowedShare);
}

} // namespace shape
