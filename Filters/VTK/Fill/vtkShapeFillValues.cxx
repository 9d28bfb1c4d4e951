#include "vtkShapeFillValues.h"

#include "vtkShapeCarry.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Fill/FillHoles.h"
#include "Geometry/VertexNormals.h"

void vtkShapeFillValues::Continue(const shape::Mesh& surface,
  const std::vector<shape::FilledHole>& holes, vtkIdType firstCell, vtkPolyData* output)
{
  vtkPointData* points = output->GetPointData();
  vtkDataArray* normals = vtkShapeCarry::GetNormals(points);
  // All arrays side by side, so that the equations of a fill are solved once.
  std::vector<vtkDataArray*> arrays;
  Eigen::MatrixXd values(surface.Points.rows(), 0);
  for (int i = 0; i < points->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = points->GetArray(i);
    if (array && array != normals && vtkShapeCarry::AreValues(array))
    {
      const int width = array->GetNumberOfComponents();
      arrays.push_back(array);
      values.conservativeResize(Eigen::NoChange, values.cols() + width);
      values.rightCols(width) = vtkShapeCarry::GetTuples(array);
    }
  }
  const Eigen::MatrixXd pointNormals = normals
    ? shape::ComputeVertexNormals(surface, shape::NormalWeight::Max)
    : Eigen::MatrixXd(0, 3);
  for (const shape::FilledHole& hole : holes)
  {
    if (hole.Points > 0 && !arrays.empty())
    {
      const Eigen::MatrixXd own =
        shape::ExtendValuesOntoFill(surface, hole, values(hole.Loop, Eigen::all));
      Eigen::Index column = 0;
      for (vtkDataArray* array : arrays)
      {
        const int width = array->GetNumberOfComponents();
        vtkShapeCarry::SetTuples(own.middleCols(column, width), hole.FirstPoint, array);
        column += width;
      }
    }
    if (normals)
    {
      vtkShapeCarry::SetTuples(
        pointNormals.middleRows(hole.FirstPoint, hole.Points), hole.FirstPoint, normals);
    }
  }
  vtkDataArray* cellNormals = vtkShapeCarry::GetNormals(output->GetCellData());
  if (cellNormals && !holes.empty())
  {
    const Eigen::Index count = surface.Triangles.rows() - holes.front().FirstTriangle;
    vtkShapeCarry::SetTuples(
      shape::ComputeAreaVectors(surface).bottomRows(count).rowwise().normalized(), firstCell,
      cellNormals);
  }
}
