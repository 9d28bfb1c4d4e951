#include "Solids/IsoSurface.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace shape
{
namespace
{

Mesh ToMesh(vtkPolyData* data)
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

} // namespace

Mesh ExtractIsoSurface(const SampledGrid& grid, double value)
{
  vtkNew<vtkDoubleArray> values;
  // VTK reads the samples where they are and does not free them.
  values->SetArray(const_cast<double*>(grid.Values.data()), grid.Values.size(), 1);
  vtkNew<vtkImageData> image;
  image->SetOrigin(grid.Origin(0), grid.Origin(1), grid.Origin(2));
  image->SetSpacing(grid.Spacing, grid.Spacing, grid.Spacing);
  image->SetDimensions(grid.Counts(0), grid.Counts(1), grid.Counts(2));
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, value);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  Mesh mesh = ToMesh(contour->GetOutput());
  // VTK's triangles are counter-clockwise seen from the lower values.
  mesh.Triangles.col(1).swap(mesh.Triangles.col(2));
  return mesh;
}

} // namespace shape
