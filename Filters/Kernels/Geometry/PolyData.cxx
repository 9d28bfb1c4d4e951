#include "Geometry/PolyData.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace shape
{

vtkPolyData* NewPolyData(const Mesh& mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(mesh.Points.rows());
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    points->SetPoint(i, mesh.Points(i, 0), mesh.Points(i, 1), mesh.Points(i, 2));
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(mesh.Triangles.rows(), 3 * mesh.Triangles.rows());
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const vtkIdType corners[3] = { mesh.Triangles(t, 0), mesh.Triangles(t, 1),
      mesh.Triangles(t, 2) };
    cells->InsertNextCell(3, corners);
  }
  vtkPolyData* data = vtkPolyData::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

Mesh MeshFromPolyData(vtkPolyData* data)
{
  Mesh mesh{ Eigen::MatrixXd(data->GetNumberOfPoints(), 3),
    Eigen::MatrixXi(data->GetPolys()->GetNumberOfCells(), 3) };
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    double point[3];
    data->GetPoint(i, point);
    mesh.Points.row(i) << point[0], point[1], point[2];
  }
  Eigen::Index triangles = 0;
  const auto cells = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCurrentCell(size, corners);
    if (size == 3)
    {
      mesh.Triangles.row(triangles++) << static_cast<int>(corners[0]), static_cast<int>(corners[1]),
        static_cast<int>(corners[2]);
    }
  }
  mesh.Triangles.conservativeResize(triangles, 3);
  return mesh;
}

} // namespace shape
