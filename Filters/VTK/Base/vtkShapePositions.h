#pragma once

#include <Eigen/Core>

#include <vector>

/// The value of a repeatable property of positions: three numbers for each position.
namespace vtkShapePositions
{

/// Sets the number of positions; new ones are 0 0 0. Returns whether the number changed.
bool Resize(std::vector<double>& values, int count);

/// Sets a position, and appends positions if there are too few. Returns whether a value changed; a
/// negative index changes nothing.
bool Set(std::vector<double>& values, int index, double x, double y, double z);

/// Returns the positions as rows (n x 3).
Eigen::MatrixXd ToRows(const std::vector<double>& values);

} // namespace vtkShapePositions
