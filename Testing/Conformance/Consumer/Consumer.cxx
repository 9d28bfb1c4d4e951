#include "vtkShapeParameterize.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <cmath>
#include <iostream>

// Maps an octahedron to the sphere; succeeds where the image's points are unit vectors.
int main()
{
  vtkNew<vtkPoints> points;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -1.0, 1.0 })
    {
      double point[3] = { 0.1, 0.2, -0.1 };
      point[axis] += (axis + 1) * side;
      points->InsertNextPoint(point);
    }
  }
  vtkNew<vtkCellArray> triangles;
  for (int octant = 0; octant < 8; ++octant)
  {
    const int x = octant & 1, y = 2 + (octant >> 1 & 1), z = 4 + (octant >> 2 & 1);
    const bool turned = (x + y + z) % 2 == 0;
    triangles->InsertNextCell({ x, turned ? z : y, turned ? y : z });
  }
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(points);
  surface->SetPolys(triangles);

  vtkNew<vtkShapeParameterize> sphere;
  sphere->SetInputDataObject(surface);
  sphere->Update();
  auto* image = vtkPolyData::SafeDownCast(sphere->GetOutputDataObject(1));
  double worst = image->GetNumberOfPoints() == 6 ? 0.0 : 1.0;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    worst = std::max(worst, std::abs(std::hypot(p[0], p[1], p[2]) - 1.0));
  }
  std::cout << sphere->GetLabel() << ": off the sphere by " << worst << "\n";
  return worst < 1e-12 ? 0 : 1;
}
