#include "vtkShapeComplete.h"

#include "vtkShapeAlgorithm.h"
#include "vtkShapeComposite.h"
#include "vtkShapeGather.h"
#include "vtkShapeTriangulation.h"

#include "vtkAbstractArray.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"

#include <algorithm>
#include <vector>

namespace
{

void RequireTuples(
  vtkDataSetAttributes* data, vtkIdType count, const std::string& kind, const std::string& name)
{
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = data->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != count)
    {
      throw shape::InvalidInput("the " + kind + " array '" +
        (array->GetName() ? array->GetName() : "(unnamed)") + "' of the input '" + name + "' has " +
        std::to_string(array->GetNumberOfTuples()) + " tuples for " + std::to_string(count) + " " +
        kind + "s; remove it with Pass Arrays, or write one tuple for each " + kind);
    }
  }
}

} // namespace

/// A process that has no connection would not take part in the collective calls for it.
void vtkShapeComplete::RequireConnections(vtkShapeAlgorithm& filter)
{
  const int ports = filter.GetNumberOfInputPorts();
  std::vector<double> fewest(ports);
  for (int port = 0; port < ports; ++port)
  {
    fewest[port] = filter.GetNumberOfInputConnections(port);
  }
  std::vector<double> most = fewest;
  vtkShapeGather::Reduce(
    filter.GetController(), fewest.data(), ports, vtkShapeGather::Reduction::Minimum);
  vtkShapeGather::Reduce(
    filter.GetController(), most.data(), ports, vtkShapeGather::Reduction::Maximum);
  for (int port = 0; port < ports; ++port)
  {
    const std::string name = filter.GetInputName(port);
    if (filter.IsInputRequired(port) && most[port] == 0.0)
    {
      throw shape::InvalidInput(name + " is not connected; choose it under Inputs");
    }
    if (fewest[port] != most[port])
    {
      throw shape::InvalidInput(name + " has " + std::to_string(static_cast<int>(fewest[port])) +
        " connections on one process and " + std::to_string(static_cast<int>(most[port])) +
        " on another; connect it on every process, with empty data where there is no piece");
    }
  }
}

void vtkShapeComplete::RequireArrays(vtkDataObject* data, const std::string& name)
{
  for (vtkDataSet* leaf : vtkShapeComposite::Of(data))
  {
    RequireTuples(leaf->GetPointData(), leaf->GetNumberOfPoints(), "point", name);
    RequireTuples(leaf->GetCellData(), leaf->GetNumberOfCells(), "cell", name);
  }
}

void vtkShapeComplete::RequireNoPointCloud(
  vtkPolyData* data, const std::string& name, const std::string& reason)
{
  if (data->GetNumberOfPolys() + data->GetNumberOfStrips() + data->GetNumberOfLines() == 0)
  {
    throw shape::InvalidInput(name + " has " + std::to_string(data->GetNumberOfPoints()) +
      " points and no polygons: " + reason +
      "; connect the points first, with Delaunay 2D, or with Delaunay 3D and Extract Surface");
  }
}

std::string vtkShapeComplete::DescribeShortSides(vtkPolyData* surface, const std::string& name)
{
  vtkIdType found = 0, first = -1;
  vtkNew<vtkIdList> corners;
  vtkCellArray* polygons = surface->GetPolys();
  for (vtkIdType cell = 0; cell < polygons->GetNumberOfCells(); ++cell)
  {
    // Triangles are used as they are.
    if (polygons->GetCellSize(cell) > 3)
    {
      polygons->GetCellAtId(cell, corners);
      const std::vector<bool> repeated = vtkShapeTriangulation::FindRepeated(surface, corners);
      if (std::find(repeated.begin(), repeated.end(), true) != repeated.end())
      {
        first = found++ == 0 ? cell : first;
      }
    }
  }
  return found == 0 ? ""
                    : "the input '" + name + "' has " + std::to_string(found) +
      (found == 1 ? " polygon" : " polygons") + " with a side of almost no length (first polygon " +
      std::to_string(first) +
      "), whose repeated corners give triangles without area; Clean merges "
      "them";
}
