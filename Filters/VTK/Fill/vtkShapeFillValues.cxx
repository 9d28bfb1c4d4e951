#include "vtkShapeFillValues.h"

#include "vtkShapeConvert.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

#include "Fill/FillHoles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{

/// Returns a component of an array.
using Column = std::pair<vtkDataArray*, int>;

/// Colours are bytes, from 0 to 255.
double ValueFor(const vtkDataArray* array, double value)
{
  return array->GetDataType() == VTK_UNSIGNED_CHAR ? std::clamp(std::round(value), 0.0, 255.0)
                                                   : value;
}

/// values: has a row for each point of the surface.
void ContinueColumns(const shape::Mesh& surface, const shape::FilledHole& hole,
  const std::vector<Column>& columns, Eigen::MatrixXd& values)
{
  for (Eigen::Index column = 0; column < values.cols(); ++column)
  {
    const auto& [array, component] = columns[column];
    for (const int point : hole.Loop)
    {
      values(point, column) = array->GetComponent(point, component);
    }
  }
  const Eigen::MatrixXd own = shape::ExtendValuesOntoFill(surface, hole, values);
  for (Eigen::Index column = 0; column < own.cols(); ++column)
  {
    const auto& [array, component] = columns[column];
    for (int i = 0; i < hole.Points; ++i)
    {
      array->SetComponent(hole.FirstPoint + i, component, ValueFor(array, own(i, column)));
    }
  }
}

} // namespace

void vtkShapeFillValues::Continue(const shape::Mesh& surface,
  const std::vector<shape::FilledHole>& holes, vtkDataSetAttributes* points,
  const vtkDataArray* leftOut)
{
  std::vector<Column> columns;
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = points->GetArray(i);
    if (array && array != leftOut && vtkShapeConvert::AreValues(array))
    {
      for (int k = 0; k < array->GetNumberOfComponents(); ++k)
      {
        columns.emplace_back(array, k);
      }
    }
  }
  const auto width = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(width > 0 ? surface.Points.rows() : 0, width);
  for (const shape::FilledHole& hole : holes)
  {
    if (width > 0 && hole.Points > 0)
    {
      ContinueColumns(surface, hole, columns, values);
    }
  }
}
