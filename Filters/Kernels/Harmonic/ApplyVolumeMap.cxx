#include "Harmonic/ApplyVolumeMap.h"

#include "Base/Errors.h"

namespace shape
{

MovedPoints ApplyVolumeMap(
  const PiecewiseHarmonicMap& map, const Eigen::MatrixXd& points, const Progress& progress)
{
  MovedPoints moved;
  moved.OutsideDomain = FindPointsOutsideDomain(map.Domain(), points, map.Farthest(),
    progress.Part(0.0, 0.5, "finding points outside the domain"));
  const Eigen::MatrixXd values =
    map.Evaluate(points, progress.Part(0.5, 1.0, "evaluating the map"));
  // The map is not valid outside its domain: those points keep their positions.
  moved.Points = moved.OutsideDomain.replicate(1, 3).array().select(points, values);
  if (!moved.Points.allFinite())
  {
    throw SolveFailure("the map is not finite at a point inside its domain; move the charges away "
                       "with a larger OffsetDistance");
  }
  return moved;
}

} // namespace shape
