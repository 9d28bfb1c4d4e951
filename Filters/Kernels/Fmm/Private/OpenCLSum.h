#pragma once

#include "Base/Progress.h"
#include "Fmm/InverseDistance.h"
#include "Fmm/SumDevice.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace shape
{

/// Points [PointBegin, PointEnd) that sum over the same ranges of sources, [SpanBegin, SpanEnd).
/// The device computes them together, one work-item for each point.
struct OpenCLBlock
{
  static constexpr int Size = 64; ///< maximum number of points
  int PointBegin = 0, PointEnd = 0, SpanBegin = 0, SpanEnd = 0;
};

/// Arguments of SumByOpenCL.
struct OpenCLSum
{
  const Eigen::MatrixXd& Sources; ///< (3 + k) x m: x, y, z and k <= 3 charges of each source
  const Eigen::MatrixXd& Points;  ///< n x 3
  bool Gradients = false;
  std::vector<SourceSpan> Spans = {};
  std::vector<OpenCLBlock> Blocks = {}; ///< no two of them have a point in common
  /// Number of sources that a launch may add to each point; a launch of a few blocks takes far less
  /// than half a second.
  int Pass = 16384;

  /// Adds blocks of the points [begin, end), which sum over the spans [spanBegin, spanEnd).
  void AddBlocks(int begin, int end, int spanBegin, int spanEnd);
};

/**
 * Computes the sums of AddPotentials or AddGradients (InverseDistance.h) on the device that
 * ChooseOpenCL has found. Each point adds its terms in a fixed order, accurate to rounding, so
 * its bits do not depend on the other points. Sums at a point that coincides with a
 * source are not finite.
 *
 * Returns n x k potentials or n x 3k gradients, zero at points without a block. If the device
 * fails, calls device.Warn and returns nothing. Throws SolveFailure if there is no Warn; Aborted.
 */
std::optional<Eigen::MatrixXd> SumByOpenCL(
  const OpenCLSum& sum, const SumDevice& device, const Progress& progress);

} // namespace shape
