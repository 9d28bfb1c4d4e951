// Maps a point inside a closed surface into the unit ball, and back, by a harmonic volume map.
// MapPointIntoBall SURFACE.vtp
#include "vtkShapeHarmonicTransform.h"
#include "vtkShapeHarmonicVolumeMap.h"
#include "vtkShapeParameterize.h"

#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  vtkNew<vtkXMLPolyDataReader> surface;
  surface->SetFileName(argc > 1 ? argv[1] : "");
  vtkNew<vtkShapeParameterize> sphere;
  sphere->SetInputConnection(surface->GetOutputPort());
  vtkNew<vtkShapeHarmonicVolumeMap> map;
  map->SetInputConnection(0, surface->GetOutputPort());
  map->SetInputConnection(1, sphere->GetOutputPort());

  // Output 1 is the map itself, by which any point can be transformed.
  vtkNew<vtkShapeHarmonicTransform> transform;
  transform->SetChargeSetConnection(map->GetOutputPort(1));
  transform->Update();
  const double start[3] = { 0.3, 0.2, -0.1 };
  double image[3], back[3];
  transform->TransformPoint(start, image);
  transform->Inverse();
  transform->TransformPoint(image, back);

  const double error = std::sqrt(vtkMath::Distance2BetweenPoints(start, back));
  std::cout << "(0.3, 0.2, -0.1) goes to (" << image[0] << ", " << image[1] << ", " << image[2]
            << ") and comes back within " << error << "\n";
  const bool moved = std::sqrt(vtkMath::Distance2BetweenPoints(start, image)) > 1e-3;
  return moved && vtkMath::Norm(image) < 1.0 && error < 1e-9 ? EXIT_SUCCESS : EXIT_FAILURE;
}
