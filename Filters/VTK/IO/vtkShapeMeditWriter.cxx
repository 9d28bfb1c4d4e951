#include "vtkShapeMeditWriter.h"

#include "vtkObjectFactory.h"

#include "IO/MeditWriter.h"

vtkStandardNewMacro(vtkShapeMeditWriter);

void vtkShapeMeditWriter::WriteText(
  std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress)
{
  shape::WriteMedit(file, sets, progress);
}
