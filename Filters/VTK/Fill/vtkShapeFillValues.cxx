#include "vtkShapeFillValues.h"

#include "vtkShapeCarry.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Fill/FillHoles.h"
#include "Geometry/VertexNormals.h"

#include <numeric>

namespace
{

std::vector<int> Consecutive(vtkIdType first, Eigen::Index count)
{
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), static_cast<int>(first));
  return numbers;
}

/// All arrays of a fill at once: its equations are solved once.
void ContinueValues(const shape::Mesh& surface, const shape::FilledHole& hole,
  const std::vector<vtkDataArray*>& arrays, int components)
{
  Eigen::MatrixXd values(hole.Loop.size(), components);
  Eigen::Index column = 0;
  for (vtkDataArray* array : arrays)
  {
    const int width = array->GetNumberOfComponents();
    values.middleCols(column, width) = vtkShapeCarry::GetTuples(array, hole.Loop);
    column += width;
  }
  const Eigen::MatrixXd own = shape::ExtendValuesOntoFill(surface, hole, values);
  const std::vector<int> points = Consecutive(hole.FirstPoint, hole.Points);
  column = 0;
  for (vtkDataArray* array : arrays)
  {
    const int width = array->GetNumberOfComponents();
    vtkShapeCarry::SetTuples(own.middleCols(column, width), points, array);
    column += width;
  }
}

} // namespace

void vtkShapeFillValues::Continue(const shape::Mesh& surface,
  const std::vector<shape::FilledHole>& holes, vtkIdType firstCell, vtkPolyData* output)
{
  vtkPointData* points = output->GetPointData();
  vtkDataArray* normals = vtkShapeCarry::GetNormals(points);
  std::vector<vtkDataArray*> arrays;
  int components = 0;
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = points->GetArray(i);
    if (array && array != normals && vtkShapeCarry::AreValues(array))
    {
      arrays.push_back(array);
      components += array->GetNumberOfComponents();
    }
  }
  const Eigen::MatrixXd pointNormals = normals
    ? shape::ComputeVertexNormals(surface, shape::NormalWeight::Max)
    : Eigen::MatrixXd(0, 3);
  for (const shape::FilledHole& hole : holes)
  {
    if (hole.Points > 0 && components > 0)
    {
      ContinueValues(surface, hole, arrays, components);
    }
    if (normals)
    {
      vtkShapeCarry::SetTuples(pointNormals.middleRows(hole.FirstPoint, hole.Points),
        Consecutive(hole.FirstPoint, hole.Points), normals);
    }
  }
  vtkDataArray* cellNormals = vtkShapeCarry::GetNormals(output->GetCellData());
  if (cellNormals && !holes.empty())
  {
    const Eigen::Index count = surface.Triangles.rows() - holes.front().FirstTriangle;
    vtkShapeCarry::SetTuples(
      shape::ComputeAreaVectors(surface).bottomRows(count).rowwise().normalized(),
      Consecutive(firstCell, count), cellNormals);
  }
}
