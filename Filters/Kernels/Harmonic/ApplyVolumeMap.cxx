#include "Harmonic/ApplyVolumeMap.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"

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

MovedPoints ApplyVolumeMap(
  const FiniteElementMap& map, const Eigen::MatrixXd& points, const Progress& progress)
{
  constexpr double tolerance = 1e-6;
  const FiniteElementMap::Values values =
    map.Evaluate(points, progress, tolerance * ComputeLongestBoxEdge(map.Elements().Points));
  MovedPoints moved;
  moved.OutsideDomain = (values.Cells.array() < 0).cast<int>();
  moved.Points = moved.OutsideDomain.replicate(1, 3).array().select(points, values.Images);
  return moved;
}

} // namespace shape
