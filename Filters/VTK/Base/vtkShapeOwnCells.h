#pragma once

#include <Eigen/Core>

class vtkDataSet;

namespace vtkShapeOwnCells
{

/// Returns, for each cell, 1, or 0 if it belongs to another process or is hidden.
Eigen::VectorXi Find(vtkDataSet* data);

} // namespace vtkShapeOwnCells
