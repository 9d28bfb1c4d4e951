#include "vtkShapePositions.h"

#include <algorithm>
#include <cstddef>

namespace vtkShapePositions
{

bool Resize(std::vector<double>& values, int count)
{
  const std::size_t size = 3 * static_cast<std::size_t>(std::max(count, 0));
  const bool changed = size != values.size();
  values.resize(size, 0.0);
  return changed;
}

bool Set(std::vector<double>& values, int index, double x, double y, double z)
{
  if (index < 0)
  {
    return false;
  }
  const auto first = 3 * static_cast<std::size_t>(index);
  const std::vector<double> before = values;
  values.resize(std::max(values.size(), first + 3), 0.0);
  values[first] = x;
  values[first + 1] = y;
  values[first + 2] = z;
  return values != before;
}

Eigen::MatrixXd ToRows(const std::vector<double>& values)
{
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>>(
    values.data(), static_cast<Eigen::Index>(values.size() / 3), 3);
}

} // namespace vtkShapePositions
