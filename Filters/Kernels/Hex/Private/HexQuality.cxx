#include "Hex/Private/HexQuality.h"

#include "Hex/Fit/HexFit.h"

#include <algorithm>
#include <cmath>

namespace shape
{
bool IsGoodGrid(const HexFit& fit, double diagonal)
{
  constexpr double minimum = 0.55;
  return fit.Inverted == 0 && fit.MinimumScaledJacobian >= minimum &&
    fit.Distance <= AcceptedDistance * diagonal;
}

bool IsGoodPolycube(const HexFit& fit, double diagonal, double nearCreases)
{
  return fit.CreasesKept && fit.MinimumScaledJacobian >= AcceptedScaledJacobian &&
    fit.Distance <= AcceptedDistance * diagonal && fit.Creases.Distance <= nearCreases;
}

bool IsBetter(const HexFit& one, const HexFit& other, double nearCreases)
{
  if ((one.Inverted > 0) != (other.Inverted > 0))
  {
    return one.Inverted == 0;
  }
  if (one.CreasesKept != other.CreasesKept)
  {
    return one.CreasesKept;
  }
  if (const double own = ComputeLength(one.Followed), others = ComputeLength(other.Followed);
      std::abs(own - others) > 1e-9 * std::max(own, others))
  {
    return own > others;
  }
  const bool isNear = one.Creases.Distance <= nearCreases;
  if (isNear != (other.Creases.Distance <= nearCreases) &&
    (isNear ? one : other).MinimumScaledJacobian >= AcceptedScaledJacobian)
  {
    return isNear;
  }
  // Quality divided by distance: twice the scaled Jacobian makes up for twice the distance.
  return one.MinimumScaledJacobian / std::max(one.Distance, 1e-300) >
    other.MinimumScaledJacobian / std::max(other.Distance, 1e-300);
}

} // namespace shape
