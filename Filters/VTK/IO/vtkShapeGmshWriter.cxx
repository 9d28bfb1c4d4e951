#include "vtkShapeGmshWriter.h"

#include "vtkObjectFactory.h"

#include "IO/GmshWriter.h"

vtkStandardNewMacro(vtkShapeGmshWriter);

void vtkShapeGmshWriter::WriteText(
  std::ostream& file, const shape::MeshSets& sets, const shape::Progress& progress)
{
  shape::WriteGmsh(file, sets, progress);
}
