#include "Cases/ModelFile.h"

#include "Driver/BenchmarkData.h"

#include "Base/Errors.h"

#include "vtkAbstractPolyDataReader.h"
#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkObject.h"
#include "vtkPLYReader.h"
#include "vtkPolyData.h"
#include "vtkSTLReader.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cctype>

namespace benchmark
{
namespace
{

/// Returns the extension of a file's name in lower case, with its point.
std::string ExtensionOf(const std::string& path)
{
  std::string extension = path.substr(std::min(path.size(), path.rfind('.')));
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

vtkSmartPointer<vtkAbstractPolyDataReader> MakeReader(const std::string& extension)
{
  if (extension == ".stl")
  {
    return vtkSmartPointer<vtkSTLReader>::New();
  }
  if (extension == ".ply")
  {
    return vtkSmartPointer<vtkPLYReader>::New();
  }
  if (extension == ".obj")
  {
    return vtkSmartPointer<vtkOBJReader>::New();
  }
  return nullptr;
}

} // namespace

shape::Mesh ReadModel(const std::string& path)
{
  if (ExtensionOf(path) == ".off")
  {
    return ReadOff(path, false);
  }
  const auto reader = MakeReader(ExtensionOf(path));
  if (!reader)
  {
    throw shape::InvalidInput("there is no reader for " + path);
  }
  reader->SetFileName(path.c_str());
  vtkObject::GlobalWarningDisplayOff(); // what VTK cannot read has no polygons
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(reader->GetOutputPort());
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkPolyData* data = triangles->GetOutput();
  if (data->GetNumberOfPolys() == 0)
  {
    throw shape::InvalidInput(path + " has no polygons");
  }
  shape::Mesh mesh{ Eigen::MatrixXd(data->GetNumberOfPoints(), 3),
    Eigen::MatrixXi(data->GetNumberOfPolys(), 3) };
  for (Eigen::Index point = 0; point < mesh.Points.rows(); ++point)
  {
    Eigen::RowVector3d position;
    data->GetPoint(point, position.data());
    mesh.Points.row(point) = position;
  }
  vtkNew<vtkIdList> corners;
  for (Eigen::Index triangle = 0; triangle < mesh.Triangles.rows(); ++triangle)
  {
    data->GetPolys()->GetCellAtId(triangle, corners);
    for (int k = 0; k < 3; ++k)
    {
      mesh.Triangles(triangle, k) = static_cast<int>(corners->GetId(k));
    }
  }
  ScaleToUnitBox(mesh);
  return mesh;
}

} // namespace benchmark
