#include "Materials/VoxelImage.h"

#include "Base/Errors.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{

void RequireVoxelImage(const VoxelImage& image)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (image.Size[axis] < 2)
    {
      throw InvalidInput("the Image has " + std::to_string(image.Size[axis]) +
        " sample along its axis " + std::string(1, "ijk"[axis]) +
        "; use an image with two or more layers along each axis");
    }
  }
  const double volume = std::abs(image.Axes.determinant());
  const double product =
    image.Axes.col(0).norm() * image.Axes.col(1).norm() * image.Axes.col(2).norm();
  if (!image.Axes.allFinite() || !image.Origin.allFinite() || !(volume > 1e-9 * product))
  {
    throw InvalidInput("the Image has a spacing of 0 or directions in one plane; correct its "
                       "spacing and its direction matrix");
  }
  for (const std::vector<double>& values : image.Channels)
  {
    const auto bad = std::count_if(
      values.begin(), values.end(), [](double value) { return !std::isfinite(value); });
    if (bad > 0)
    {
      throw InvalidInput("the Image has " + std::to_string(bad) +
        (bad == 1 ? " value that is" : " values that are") +
        " not finite near the Input; replace them with Calculator, or remove the array");
    }
  }
}

Eigen::MatrixXd ToIndices(const VoxelImage& image, const Eigen::MatrixXd& points)
{
  return (points.rowwise() - image.Origin) * image.Axes.inverse().transpose();
}

} // namespace shape
