#include "vtkShapeSymmetry.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeRepair.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkShapeSymmetry);

namespace
{

/// The outputs after the surface.
constexpr int FixedPort = 1, ElementsPort = 2, CompositionPort = 3;

/// Returns, for each cell, the value that most of its corners have, or the smallest of these.
vtkSmartPointer<vtkIntArray> MostFrequent(
  vtkDataSet* data, const Eigen::VectorXi& ofPoints, const std::string& name)
{
  Eigen::VectorXi values(data->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < values.size(); ++cell)
  {
    data->GetCellPoints(cell, ids);
    std::map<int, int> times;
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      ++times[ofPoints(ids->GetId(k))];
    }
    const auto most = std::max_element(
      times.begin(), times.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    values(cell) = most == times.end() ? 0 : most->first;
  }
  return vtkShapeConvert::ToIntegers(values, name);
}

} // namespace

vtkShapeSymmetry::vtkShapeSymmetry()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutputLikeInput();
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkTable");
  this->DeclareOutput("vtkTable");
  this->DeclareFacts();
  this->DeclareShown(0, { "Copy" });
  this->DeclareMemoryRemedy("lower Coarse Points");
}

void vtkShapeSymmetry::WriteSurface(
  const shape::SymmetryResult& result, const shape::Surface& surface)
{
  const GatheredInput& whole = this->GetGatheredInput(0);
  const Eigen::MatrixXi& triangles = surface.Triangles();
  const auto own = [&](const Eigen::MatrixXd& values)
  { return vtkShapeConvert::Rows(values, whole.OwnPoints); };
  const int last = static_cast<int>(result.Elements.size()) - 1;
  const shape::SurfacePoints& map = result.Elements[std::min(this->Element, last)].Map;
  // Cell ids of polygons follow those of vertices and lines.
  const auto before =
    static_cast<double>(whole.Given->GetNumberOfVerts() + whole.Given->GetNumberOfLines());
  const Eigen::VectorXi cells = vtkShapeRepaired::ToGiven(whole.GivenTriangles, map.Triangles);
  std::vector<vtkShapeComposite::PointField> fields = {
    { "TargetPosition", own(shape::PullBack(map, triangles, surface.Points())) },
    { "TargetCell", own(cells.cast<double>().array() + before), true },
    { "TargetBarycentric", own(map.Barycentrics) },
    { "Orbit", own(result.Orbits.cast<double>()), true }
  };
  int generator = 0;
  for (const shape::Symmetry& element : result.Elements)
  {
    if (element.Generator)
    {
      fields.push_back({ "Generator" + std::to_string(++generator),
        own(shape::PullBack(element.Map, triangles, surface.Points())) });
    }
  }
  if (vtkShapeConvert::IsChosen(this->Array))
  {
    vtkDataArray* chosen = whole.Data->GetPointData()->GetArray(this->Array.c_str());
    const Eigen::MatrixXd values = vtkShapeConvert::ToPointArray(whole.Data, this->Array,
      chosen ? chosen->GetNumberOfComponents() : 1, "the Input", "choose another Array");
    shape::RequireFinite(values, "the array '" + this->Array + "' of the Input");
    fields.push_back({ "Symmetrized", own(shape::Symmetrize(result, triangles, values)) });
  }
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeComposite::AddPointFields(this->GetInputDataObject(0, 0), output, fields);
  const Eigen::VectorXi copies = own(result.Copies.cast<double>()).col(0).cast<int>();
  vtkIdType first = 0;
  for (vtkDataSet* leaf : vtkShapeComposite::Of(output))
  {
    const vtkIdType count = leaf->GetNumberOfPoints();
    leaf->GetCellData()->AddArray(MostFrequent(leaf, copies.segment(first, count), "Copy"));
    first += count;
  }
}

void vtkShapeSymmetry::WriteGroup(const shape::SymmetryResult& result)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  std::vector<int> owners;
  const auto order = static_cast<int>(result.Elements.size());
  Eigen::VectorXi numbers = Eigen::VectorXi::LinSpaced(order, 0, order - 1), orders(order),
                  reversing(order), generators(order);
  Eigen::VectorXd distortions(order);
  for (int i = 0; i < order; ++i)
  {
    const shape::Symmetry& element = result.Elements[i];
    orders(i) = element.Order;
    reversing(i) = element.Reversing ? 1 : 0;
    generators(i) = element.Generator ? 1 : 0;
    distortions(i) = element.Distortion;
    for (const auto& segment : element.Fixed)
    {
      const vtkIdType ids[] = { points->InsertNextPoint(segment[0].data()),
        points->InsertNextPoint(segment[1].data()) };
      lines->InsertNextCell(2, ids);
      owners.push_back(i);
    }
  }
  auto* curves = vtkPolyData::SafeDownCast(this->GetOutputDataObject(FixedPort));
  curves->SetPoints(points);
  curves->SetLines(lines);
  curves->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(
    Eigen::Map<const Eigen::VectorXi>(owners.data(), static_cast<Eigen::Index>(owners.size())),
    "Element"));

  auto* elements = vtkTable::SafeDownCast(this->GetOutputDataObject(ElementsPort));
  elements->AddColumn(vtkShapeConvert::ToIntegers(numbers, "Element"));
  elements->AddColumn(vtkShapeConvert::ToIntegers(orders, "Order"));
  elements->AddColumn(vtkShapeConvert::ToIntegers(reversing, "Reversing"));
  elements->AddColumn(vtkShapeConvert::ToIntegers(generators, "Generator"));
  elements->AddColumn(vtkShapeConvert::ToArray(distortions, "Distortion"));
  auto* composition = vtkTable::SafeDownCast(this->GetOutputDataObject(CompositionPort));
  for (int j = 0; j < order; ++j)
  {
    composition->AddColumn(
      vtkShapeConvert::ToIntegers(result.Composition.col(j), "Element" + std::to_string(j)));
  }
}

// Every process computes the same symmetries, and writes the rows of its own points.
void vtkShapeSymmetry::Execute(const shape::Progress& progress)
{
  shape::RequireOption(this->Element >= 0, "Element", this->Element, "at least 0");
  const shape::Surface surface =
    vtkShapeConvert::ToMesh(this->GetGatheredInput(0).Data, "the Input");
  const shape::SymmetryResult result = shape::FindSymmetries(surface, this->Options, progress);
  this->WriteSurface(result, surface);
  double largest = 0.0, generators = 0.0, reversing = 0.0;
  for (const shape::Symmetry& element : result.Elements)
  {
    largest = std::max(largest, element.Distortion);
    generators += element.Generator ? 1.0 : 0.0;
    reversing += element.Reversing ? 1.0 : 0.0;
  }
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeConvert::AddFact(output, "Symmetry.Order", static_cast<double>(result.Elements.size()));
  vtkShapeConvert::AddFact(output, "Symmetry.Generators", generators);
  vtkShapeConvert::AddFact(output, "Symmetry.Reversing", reversing);
  vtkShapeConvert::AddFact(output, "Symmetry.Distortion", largest);
  vtkShapeConvert::AddFact(output, "Symmetry.Bound", result.Bound);
  vtkShapeConvert::AddFact(
    output, "Symmetry.Rejected", std::isfinite(result.Rejected) ? result.Rejected : -1.0);
  if (!this->GetController() || this->GetController()->GetLocalProcessId() == 0)
  {
    this->WriteGroup(result);
  }
}
