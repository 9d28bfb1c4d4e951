#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace shape
{

/**
 * An image whose samples are labels: integers that name the region at a position. Label 0 is the
 * outside, and so is everything beyond the image.
 *
 * Sample (i, j, k) lies at Origin + Axes (i, j, k)^T. Its label is
 * Labels[i + Size[0] (j + Size[1] k)].
 */
struct LabelImage
{
  std::array<int, 3> Size = { 0, 0, 0 };
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();
  /// The steps from a sample to the next along i, j and k, as columns: the spacings times the
  /// directions. The columns are linearly independent; they may be left-handed.
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity();
  std::vector<int> Labels;
  /// The grey values of the samples, if the labels come from thresholds (MakeLabels); else empty.
  std::vector<float> Values;
  std::vector<double> Thresholds; ///< ascending

  std::size_t IndexOf(int i, int j, int k) const
  {
    return static_cast<std::size_t>(i) +
      static_cast<std::size_t>(this->Size[0]) *
      (static_cast<std::size_t>(j) +
        static_cast<std::size_t>(this->Size[1]) * static_cast<std::size_t>(k));
  }
};

/// Sets the label of each sample to the number of `thresholds` that its grey value reaches. NaN is
/// the outside. thresholds: ascending. Throws InvalidInput if they are not.
void MakeLabels(LabelImage& image, const std::vector<double>& thresholds);

/// The position of the interface between two neighbouring samples, from 0 at the first to 1 at the
/// second: where the grey value, interpolated linearly, is the threshold between them, or the mean
/// of several. One half without grey values, or if islands have changed the labels.
double FindCrossing(const LabelImage& image, std::size_t first, std::size_t second);

} // namespace shape
