#include "vtkShapeCADReader.h"

#include "vtkShapeConvert.h"
#include "vtkShapeFileContent.h"

#include "vtkFieldData.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkShapeCADReader);

vtkShapeCADReader::vtkShapeCADReader()
{
  this->SetNumberOfOutputPorts(2);
}

std::string vtkShapeCADReader::GetOutputType()
{
  return "vtkPolyData";
}

void vtkShapeCADReader::ReadContent(
  std::string content, vtkDataObject* output, const shape::Progress& progress)
{
  const shape::CADModel model = shape::ReadCAD(content, this->Options, progress);
  vtkShapeFileContent::ToPolyData(
    model, vtkPolyData::SafeDownCast(output), vtkPolyData::SafeDownCast(this->GetFurtherOutput(1)));
  if (!model.Unit.empty())
  {
    vtkShapeConvert::AddFact(output, "CADReader.Unit", model.Unit);
  }
  vtkShapeConvert::AddFact(output, "CADReader.Deflection", model.Deflection);
  vtkShapeConvert::AddFact(output, "CADReader.Distance", model.Distance);
  vtkShapeConvert::AddFact(output, "CADReader.OpenEdges", model.OpenEdges);
}
