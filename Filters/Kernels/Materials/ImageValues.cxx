#include "Materials/ImageValues.h"

#include "Base/Errors.h"
#include "Materials/Private/CellSampling.h"
#include "Materials/Private/TabulatedLaw.h"
#include "Materials/Private/TrilinearWeights.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>

namespace shape
{
namespace
{

/// The sums over a part of a cell. The sums of the channels follow in the same column.
enum Row
{
  Volume,
  Covered,
  Density,
  Modulus,
  Bad,      ///< number of samples without a valid modulus
  BadValue, ///< the value of the image at one of them
  RowCount
};

struct Laws
{
  TabulatedLaw Density, Modulus;

  Laws(const MaterialLaws& laws, double minimum, double maximum)
    : Density(minimum, maximum, laws.Density)
    , Modulus(minimum, maximum, [&](double value) { return laws.Modulus(laws.Density(value)); })
  {
  }
};

std::unique_ptr<Laws> Tabulate(const MaterialLaws& laws)
{
  if (laws.Values.empty())
  {
    return nullptr;
  }
  const auto [minimum, maximum] = std::minmax_element(laws.Values.begin(), laws.Values.end());
  return std::make_unique<Laws>(laws, *minimum, *maximum);
}

void AddLaws(const Laws& laws, double value, double volume, Eigen::Ref<Eigen::VectorXd> sums)
{
  const double density = laws.Density(value), modulus = laws.Modulus(value);
  if (std::isfinite(density) && std::isfinite(modulus) && modulus >= 0.0)
  {
    sums(Density) += volume * density;
    sums(Modulus) += volume * modulus;
  }
  else
  {
    sums(Bad) += 1.0;
    sums(BadValue) = value;
  }
}

/// Returns the sums over each cell: a column for each.
Eigen::MatrixXd SumOverCells(const CellSampling& sampling, Eigen::Index cells,
  const VoxelImage& image, const MaterialLaws& given, const Progress& progress)
{
  const std::unique_ptr<Laws> laws = Tabulate(given);
  const auto channels = static_cast<Eigen::Index>(image.Channels.size());
  Eigen::MatrixXd parts = Eigen::MatrixXd::Zero(RowCount + channels, sampling.Count());
  sampling.Run(
    [&](int task)
    {
      auto sums = parts.col(task);
      sampling.ForEachSample(task,
        [&](const Eigen::RowVector3d& index, double volume, bool isInside)
        {
          sums(Volume) += volume;
          if (!isInside)
          {
            return;
          }
          sums(Covered) += volume;
          const TrilinearWeights weights(image, index);
          for (Eigen::Index channel = 0; channel < channels; ++channel)
          {
            sums(RowCount + channel) += volume * weights.Interpolate(image.Channels[channel]);
          }
          if (laws)
          {
            AddLaws(*laws, weights.Interpolate(given.Values), volume, sums);
          }
        });
    },
    progress);
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(parts.rows(), cells);
  for (int task = 0; task < sampling.Count(); ++task)
  {
    auto ofCell = sums.col(sampling.GetCell(task));
    const double bad = parts(Bad, task) > 0.0 ? parts(BadValue, task) : ofCell(BadValue);
    ofCell += parts.col(task);
    ofCell(BadValue) = bad;
  }
  return sums;
}

std::string CountCells(Eigen::Index count, Eigen::Index first)
{
  return std::to_string(count) + (count == 1 ? " cell" : " cells") + " (first cell " +
    std::to_string(first) + ")";
}

/// Throws InvalidInput with the count and the first of the cells that are marked.
template <typename Marks>
void RequireNone(const Marks& marks, const std::string& fact, const std::string& remedy)
{
  const Eigen::Index count = marks.count();
  if (count > 0)
  {
    Eigen::Index first = 0;
    while (!marks(first))
    {
      ++first;
    }
    throw InvalidInput(fact + CountCells(count, first) + "; " + remedy);
  }
}

void RequireVolumes(const Cells& cells, const Eigen::ArrayXd& volumes)
{
  constexpr double rounding = 1e-14; // of the volume of the cell's bounding cube
  Eigen::Array<bool, Eigen::Dynamic, 1> isFlat(volumes.size());
  for (Eigen::Index cell = 0; cell < volumes.size(); ++cell)
  {
    const int first = cells.Offsets(cell), count = cells.Offsets(cell + 1) - first;
    const Eigen::MatrixXd corners =
      cells.Points(cells.Corners.segment(first, count).array(), Eigen::all);
    const double size = (corners.colwise().maxCoeff() - corners.colwise().minCoeff()).maxCoeff();
    isFlat(cell) = !(volumes(cell) > rounding * size * size * size);
  }
  RequireNone(isFlat, "the Input has no volume in ", "remove these cells");
}

void RequireModulus(const Eigen::MatrixXd& sums, const MaterialLaws& laws)
{
  const Eigen::Array<bool, Eigen::Dynamic, 1> bad = sums.row(Bad).transpose().array() > 0.0;
  if (bad.any())
  {
    Eigen::Index first = 0;
    while (!bad(first))
    {
      ++first;
    }
    const double value = sums(BadValue, first), density = laws.Density(value);
    std::ostringstream words;
    words << "the modulus is negative or not finite in " << CountCells(bad.count(), first)
          << ": the image's value " << value << " gives the density " << density
          << " and the modulus " << laws.Modulus(density)
          << "; limit Density, as in max(0.01, ...), or correct ModulusLaw";
    throw InvalidInput(words.str());
  }
  const Eigen::Array<bool, Eigen::Dynamic, 1> zero = sums.row(Modulus).transpose().array() <= 0.0;
  RequireNone(zero, "the modulus is 0 in all of ",
    "limit Density, as in max(0.01, ...), or correct ModulusLaw");
}

} // namespace

void RequireInRange(const ImageValuesOptions& options)
{
  RequireOption(options.SamplingStep >= 0.05 && options.SamplingStep <= 10.0, "SamplingStep",
    options.SamplingStep, "from 0.05 to 10");
  RequireOption(options.BoundaryLayers >= 0 && options.BoundaryLayers <= 20, "BoundaryLayers",
    options.BoundaryLayers, "from 0 to 20");
  RequireOption(options.Materials >= 1 && options.Materials <= 10000, "Materials",
    options.Materials, "from 1 to 10000");
}

ImageValuesResult ComputeImageValues(const Cells& cells, const VoxelImage& image,
  const MaterialLaws& laws, const ImageValuesOptions& options, const Progress& progress)
{
  RequireInRange(options);
  RequireVoxelImage(image);
  const Eigen::Index count = cells.Kinds.size();
  const CellSampling sampling(cells, image, options.SamplingStep);
  const Eigen::MatrixXd sums = SumOverCells(sampling, count, image, laws, progress);
  const Eigen::ArrayXd volumes = sums.row(Volume).transpose(),
                       covered = sums.row(Covered).transpose();
  const double voxel = std::abs(image.Axes.determinant());
  RequireVolumes(cells, volumes * voxel);

  ImageValuesResult result;
  result.Volumes = volumes * voxel;
  result.Coverage = (covered / volumes).min(1.0);
  const Eigen::ArrayXd divisors = (covered > 0.0).select(covered, 1.0);
  result.Means = sums.bottomRows(sums.rows() - RowCount).transpose().array().colwise() / divisors;
  if (!laws.Values.empty())
  {
    RequireNone((covered == 0.0).eval(), "the Image does not contain any part of ",
      "use an image of the entire Input, or leave Density empty and remove the cells whose "
      "Coverage is 0 with Threshold");
    RequireModulus(sums, laws);
    result.Density = sums.row(Density).transpose().array() / divisors;
    result.Modulus = sums.row(Modulus).transpose().array() / divisors;
  }
  return result;
}

} // namespace shape
