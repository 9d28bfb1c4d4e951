#include "Geometry/IsoSurface.h"

#include "Geometry/PolyData.h"

#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace shape
{

Mesh IsoSurface(const SampledGrid& grid, double value)
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
  Mesh mesh = MeshFromPolyData(contour->GetOutput());
  // VTK's triangles are counter-clockwise seen from the lower values.
  mesh.Triangles.col(1).swap(mesh.Triangles.col(2));
  return mesh;
}

} // namespace shape
