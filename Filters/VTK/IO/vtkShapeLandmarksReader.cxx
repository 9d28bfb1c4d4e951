#include "vtkShapeLandmarksReader.h"

#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

vtkStandardNewMacro(vtkShapeLandmarksReader);

std::string vtkShapeLandmarksReader::GetOutputType()
{
  return "vtkPolyData";
}

void vtkShapeLandmarksReader::ReadContent(
  std::string content, vtkDataObject* output, const shape::Progress& progress)
{
  const shape::LandmarkFile file = shape::ReadLandmarks(content, this->Options);
  vtkNew<vtkPoints> points;
  points->SetData(vtkShapeConvert::ToArray(file.Points, "Points"));
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Number");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    vertices->InsertNextCell(1, &i);
    names->InsertNextValue(file.Names[static_cast<std::size_t>(i)]);
    numbers->InsertNextValue(static_cast<int>(i) + 1);
  }
  auto* landmarks = vtkPolyData::SafeDownCast(output);
  landmarks->SetPoints(points);
  landmarks->SetVerts(vertices);
  landmarks->GetPointData()->AddArray(names);
  landmarks->GetPointData()->AddArray(numbers);
  if (file.Targets.rows() > 0)
  {
    landmarks->GetPointData()->AddArray(vtkShapeConvert::ToArray(file.Targets, "TargetPosition"));
  }
  if (!file.CoordinateSystem.empty())
  {
    vtkShapeConvert::AddFact(output, "LandmarksReader.CoordinateSystem", file.CoordinateSystem);
  }
  progress(1.0);
}
