#include "vtkShapeOFFReader.h"

#include "vtkShapeFileContent.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "IO/OFFReader.h"

vtkStandardNewMacro(vtkShapeOFFReader);

std::string vtkShapeOFFReader::GetOutputType()
{
  return "vtkPolyData";
}

void vtkShapeOFFReader::ReadContent(
  std::string content, vtkDataObject* output, const shape::Progress& progress)
{
  vtkShapeFileContent::ToPolyData(
    shape::ReadOFF(content, progress), vtkPolyData::SafeDownCast(output));
}
