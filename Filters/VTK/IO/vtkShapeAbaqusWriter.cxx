#include "vtkShapeAbaqusWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkShapeAbaqusWriter);

void vtkShapeAbaqusWriter::WriteText(
  std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress)
{
  shape::WriteAbaqus(file, sets, this->Options, progress);
}
