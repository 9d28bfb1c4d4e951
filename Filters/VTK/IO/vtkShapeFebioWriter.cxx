#include "vtkShapeFebioWriter.h"

#include "vtkObjectFactory.h"

#include "IO/FebioWriter.h"

vtkStandardNewMacro(vtkShapeFebioWriter);

void vtkShapeFebioWriter::WriteText(
  std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress)
{
  shape::WriteFebio(file, sets, progress);
}
