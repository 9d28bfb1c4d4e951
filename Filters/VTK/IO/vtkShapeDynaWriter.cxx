#include "vtkShapeDynaWriter.h"

#include "vtkObjectFactory.h"

#include "IO/DynaWriter.h"

vtkStandardNewMacro(vtkShapeDynaWriter);

void vtkShapeDynaWriter::WriteText(
  std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress)
{
  shape::WriteDyna(file, sets, progress);
}
