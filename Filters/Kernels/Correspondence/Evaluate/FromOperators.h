#pragma once

#include "Base/Progress.h"
#include "Correspondence/Evaluate/MetricEmbedding.h"
#include "Correspondence/Evaluate/MetricRecovery.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// The difference operators of MapDifference, each k x k.
struct SurfaceOperators
{
  Eigen::MatrixXd Area, Conformal;
  /// Between the offset surfaces at OffsetDistance (OffsetSurface), or empty.
  Eigen::MatrixXd OffsetArea, OffsetConformal;
  double OffsetDistance = 0.0; ///< in the model's units; not 0 if there are operators at it
};

struct FromOperatorsOptions
{
  MetricRecoveryOptions Metric;
  MetricEmbeddingOptions Embedding;
};

struct RecoveredSurface
{
  RecoveredMetric Metric;
  /// m x 3, or empty without the operators of offset surfaces: the normal curvature along the edge
  /// opposite each corner, positive where the surface is convex. It is the second fundamental form
  /// of the edge, divided by the square of its length: (l' / l - 1) / OffsetDistance, for the
  /// length l' of the edge on the offset surface.
  Eigen::MatrixXd Curvatures;
  EmbeddedMetric Embedded;
};

/// Recovers the surface that has the given difference operators to `first`: its metric and that of
/// its offset surface (RecoverMetric), then positions (EmbedMetric). Throws what these and
/// OffsetSurface throw.
RecoveredSurface RecoverFromOperators(const Surface& first, const SurfaceOperators& operators,
  const FromOperatorsOptions& options = {}, const Progress& progress = {});

} // namespace shape
