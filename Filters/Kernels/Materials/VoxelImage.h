#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace shape
{

/**
 * An image of numbers, which is interpolated trilinearly between its samples.
 *
 * Sample (i, j, k) lies at Origin + Axes (i, j, k)^T. Its value in a channel is
 * Channels[channel][IndexOf(i, j, k)]. The image covers the box of its samples.
 */
struct VoxelImage
{
  std::array<int, 3> Size = { 0, 0, 0 };
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();
  /// The steps from a sample to the next along i, j and k, as columns: the spacings times the
  /// directions. They may be left-handed.
  Eigen::Matrix3d Axes = Eigen::Matrix3d::Identity();
  std::vector<std::vector<double>> Channels;

  std::size_t IndexOf(int i, int j, int k) const
  {
    return static_cast<std::size_t>(i) +
      static_cast<std::size_t>(this->Size[0]) *
      (static_cast<std::size_t>(j) +
        static_cast<std::size_t>(this->Size[1]) * static_cast<std::size_t>(k));
  }
  std::size_t Count() const ///< number of samples
  {
    return this->IndexOf(0, 0, this->Size[2]);
  }
};

/// Throws InvalidInput if the image has fewer than two samples along an axis, if its axes are not
/// finite and independent, or if a value is not finite.
void RequireVoxelImage(const VoxelImage& image);

/// Returns positions (n x 3) in units of voxels: sample (i, j, k) has the index (i, j, k).
Eigen::MatrixXd ToIndices(const VoxelImage& image, const Eigen::MatrixXd& points);

} // namespace shape
