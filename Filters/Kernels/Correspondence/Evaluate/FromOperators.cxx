#include "Correspondence/Evaluate/FromOperators.h"

namespace shape
{

RecoveredSurface RecoverFromOperators(const Surface& first, const SurfaceOperators& operators,
  const FromOperatorsOptions& options, const Progress& progress)
{
  const bool hasOffset = operators.OffsetArea.size() > 0;
  RecoveredSurface result;
  result.Metric = RecoverMetric(first, operators.Area, operators.Conformal, options.Metric,
    progress.Part(0.0, hasOffset ? 0.35 : 0.7));
  Eigen::MatrixXd beyond;
  if (hasOffset)
  {
    beyond = RecoverMetric(OffsetSurface(first, operators.OffsetDistance, "the Input"),
      operators.OffsetArea, operators.OffsetConformal, options.Metric, progress.Part(0.35, 0.7))
               .Sides;
    result.Curvatures =
      (beyond.array() / result.Metric.Sides.array() - 1.0) / operators.OffsetDistance;
  }
  result.Embedded = EmbedMetric(first, result.Metric.Sides, beyond, operators.OffsetDistance,
    options.Embedding, progress.Part(0.7, 1.0, "embedding the lengths"));
  return result;
}

} // namespace shape
