#include "vtkShapeExodusWriter.h"

#include "vtkObjectFactory.h"

#include "IO/ExodusWriter.h"

vtkStandardNewMacro(vtkShapeExodusWriter);

void vtkShapeExodusWriter::WriteText(
  std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress)
{
  shape::WriteExodus(file, sets, progress);
}
