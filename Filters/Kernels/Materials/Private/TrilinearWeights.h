#pragma once

#include "Materials/VoxelImage.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shape
{

/// The eight samples around a position in the image, and their weights in trilinear interpolation.
struct TrilinearWeights
{
  std::array<std::size_t, 8> Samples;
  std::array<double, 8> Weights;

  /// index: in units of voxels, inside the image up to rounding.
  TrilinearWeights(const VoxelImage& image, const Eigen::RowVector3d& index)
  {
    int base[3];
    double upper[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      base[axis] = std::clamp(static_cast<int>(std::floor(index(axis))), 0, image.Size[axis] - 2);
      upper[axis] = std::clamp(index(axis) - base[axis], 0.0, 1.0);
    }
    const std::size_t first = image.IndexOf(base[0], base[1], base[2]);
    for (int corner = 0; corner < 8; ++corner)
    {
      const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
      this->Samples[corner] = first + image.IndexOf(i, j, k);
      this->Weights[corner] = (i != 0 ? upper[0] : 1.0 - upper[0]) *
        (j != 0 ? upper[1] : 1.0 - upper[1]) * (k != 0 ? upper[2] : 1.0 - upper[2]);
    }
  }

  double Interpolate(const std::vector<double>& values) const
  {
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
      sum += this->Weights[corner] * values[this->Samples[corner]];
    }
    return sum;
  }
};

} // namespace shape
