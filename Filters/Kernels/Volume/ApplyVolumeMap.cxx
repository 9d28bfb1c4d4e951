#include "Volume/ApplyVolumeMap.h"

#include "Core/Errors.h"
#include "Volume/OutsideDomain.h"

namespace shape
{

MovedPoints ApplyVolumeMap(const ChargeSet& map, const SignedDistance& boundary, double farthest,
  const Eigen::MatrixXd& points, const Progress& progress)
{
  MovedPoints moved;
  moved.OutsideDomain = OutsideDomain(boundary, points, farthest, progress.Part(0.0, 0.5));
  const Eigen::MatrixXd values = Evaluate(map, points, progress.Part(0.5, 1.0));
  moved.Points = moved.OutsideDomain.replicate(1, 3).array().select(points, values);
  if (!moved.Points.allFinite())
  {
    throw SolveFailure("the map is not finite at a point inside its domain; move the charges away "
                       "with a larger OffsetDistance");
  }
  return moved;
}

} // namespace shape
