#include "vtkShapeMeditReader.h"

#include "vtkShapeFileContent.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include "IO/MeditReader.h"

vtkStandardNewMacro(vtkShapeMeditReader);

std::string vtkShapeMeditReader::GetOutputType()
{
  return "vtkUnstructuredGrid";
}

void vtkShapeMeditReader::ReadContent(
  std::string content, vtkDataObject* output, const shape::Progress& progress)
{
  vtkShapeFileContent::ToGrid(
    shape::ReadMedit(content, progress), vtkUnstructuredGrid::SafeDownCast(output));
}
