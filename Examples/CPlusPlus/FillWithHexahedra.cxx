// Fills the solid inside a surface with hexahedra, and writes them for Gmsh.
// FillWithHexahedra SURFACE.vtp HEXAHEDRA.mesh
#include "vtkShapeHexRemesh.h"
#include "vtkShapeMeditWriter.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataReader.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "FillWithHexahedra SURFACE.vtp HEXAHEDRA.mesh\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkXMLPolyDataReader> surface;
  surface->SetFileName(argv[1]);
  vtkNew<vtkShapeHexRemesh> remesh;
  remesh->SetInputConnection(surface->GetOutputPort());
  remesh->SetCellSize(0.2);

  vtkNew<vtkShapeMeditWriter> writer;
  writer->SetInputConnection(remesh->GetOutputPort());
  writer->SetFileName(argv[2]);
  if (!writer->Write()) // VTK has reported why
  {
    return EXIT_FAILURE;
  }
  auto* solid = vtkUnstructuredGrid::SafeDownCast(remesh->GetOutputDataObject(0));
  const double worst = solid->GetCellData()->GetArray("ScaledJacobian")->GetRange()[0];
  std::cout << solid->GetNumberOfCells() << " hexahedra, scaled Jacobian at least " << worst
            << "\n";
  return worst > 0.0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
