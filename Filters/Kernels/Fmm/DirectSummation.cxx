#include "Fmm/DirectSummation.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Fmm/Private/OpenCLSum.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace shape
{

namespace
{

constexpr double InverseFourPi = 0.25 / M_PI;
/// Number of points in a chunk: a few vectors of the widest processor.
constexpr int Grain = 64;
/// Number of sources in one pass, 200 kB: they stay in the L2 cache for all points of a chunk.
constexpr int Pass = 4096;

void Check(
  const Eigen::MatrixXd& sources, const Eigen::MatrixXd& charges, const Eigen::MatrixXd& points)
{
  if (sources.cols() != 3 || points.cols() != 3 || charges.rows() != sources.rows())
  {
    throw InvalidInput("there are " + std::to_string(charges.rows()) + " rows of charges for " +
      std::to_string(sources.rows()) +
      " sources, or positions do not have three coordinates; give one row of charges for each "
      "source, and three coordinates for each position");
  }
}

/// Returns the power of two that scales the sources' largest coordinate to about one; it is exact.
double ScaleFor(const Eigen::MatrixXd& sources)
{
  const double largest = sources.size() > 0 ? sources.cwiseAbs().maxCoeff() : 0.0;
  return largest > 0.0 && std::isfinite(largest) ? std::ldexp(1.0, -std::ilogb(largest)) : 1.0;
}

/// Adds the sums over one to three columns of charges on the processor. packed: x, y, z and the
/// charges of each source.
void AddOnProcessor(const Eigen::MatrixXd& packed, const Eigen::MatrixXd& positions,
  Eigen::Ref<Eigen::MatrixXd> values, bool gradient, RootError error, const Progress& progress)
{
  const int m = static_cast<int>(packed.cols());
  const int n = static_cast<int>(positions.rows());
  ParallelFor(
    n, Grain,
    [&](int begin, int end)
    {
      // Every point adds its terms in the order of the sources.
      for (int first = 0; first < m; first += Pass)
      {
        const SourceSpan span{ first, std::min(first + Pass, m) };
        InverseDistanceSum sum;
        sum.Sources = packed.data();
        sum.Columns = static_cast<int>(packed.rows()) - 3;
        sum.Spans = &span;
        sum.SpanCount = 1;
        sum.Points = positions.data() + begin;
        sum.PointStride = n;
        sum.PointCount = end - begin;
        sum.Values = values.data() + begin;
        sum.ValueStride = n;
        sum.Error = error;
        gradient ? AddGradients(sum) : AddPotentials(sum);
      }
    },
    progress);
}

/// Computes the same sums on an OpenCL device; returns false if it fails.
bool SetOnDevice(const Eigen::MatrixXd& packed, const Eigen::MatrixXd& positions,
  Eigen::Ref<Eigen::MatrixXd> values, bool gradient, const SumDevice& device,
  const Progress& progress)
{
  OpenCLSum sum{ packed, positions, gradient };
  sum.Spans = { { 0, static_cast<int>(packed.cols()) } };
  sum.AddBlocks(0, static_cast<int>(positions.rows()), 0, 1);
  const std::optional<Eigen::MatrixXd> sums = SumByOpenCL(sum, device, progress);
  if (sums)
  {
    values = *sums;
  }
  return sums.has_value();
}

/// Sums potentials, or with `gradient` three derivatives for each column of the charges.
Eigen::MatrixXd Sum(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& charges,
  const Eigen::MatrixXd& points, bool gradient, RootError error, const Progress& progress,
  const SumDevice& device)
{
  Check(sources, charges, points);
  const double scale = ScaleFor(sources);
  // Back from scaled coordinates: 1 / r takes the scale as a factor, its gradient the square.
  const double factor = InverseFourPi * (gradient ? scale * scale : scale);
  const Eigen::MatrixXd positions = scale * points;
  const Eigen::Index m = sources.rows();
  const int k = static_cast<int>(charges.cols());
  const int valuesPerColumn = gradient ? 3 : 1;
  const bool onDevice =
    ChooseOpenCL(device, static_cast<double>(m) * static_cast<double>(positions.rows()));
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(positions.rows(), valuesPerColumn * k);
  Eigen::MatrixXd packed;
  // InverseDistanceSum takes up to three columns of charges.
  for (int column = 0; column < k; column += 3)
  {
    const int columns = std::min(3, k - column);
    packed.resize(3 + columns, m);
    packed.topRows(3) = scale * sources.transpose();
    packed.bottomRows(columns) = factor * charges.middleCols(column, columns).transpose();
    auto to = values.middleCols(valuesPerColumn * column, valuesPerColumn * columns);
    const Progress part =
      progress.Part(static_cast<double>(column) / k, static_cast<double>(column + columns) / k);
    if (!onDevice || !SetOnDevice(packed, positions, to, gradient, device, part))
    {
      AddOnProcessor(packed, positions, to, gradient, error, part);
    }
  }
  return values;
}

} // namespace

Eigen::MatrixXd SumPotentialsDirectly(const Eigen::MatrixXd& sources,
  const Eigen::MatrixXd& charges, const Eigen::MatrixXd& points, RootError error,
  const Progress& progress, const SumDevice& device)
{
  return Sum(sources, charges, points, false, error, progress, device);
}

Eigen::MatrixXd SumGradientsDirectly(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& charges,
  const Eigen::MatrixXd& points, const Progress& progress, const SumDevice& device)
{
  return Sum(sources, charges, points, true, RootError::Rounding, progress, device);
}

} // namespace shape
