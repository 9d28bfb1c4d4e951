#include "vtkShapeFiniteElements.h"

#include "vtkShapeConvert.h"
#include "vtkShapeGather.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include <utility>

namespace
{

constexpr const char* TetrahedraArray = "Tetrahedra";

} // namespace

bool vtkShapeFiniteElements::Has(vtkPolyData* data)
{
  return data->GetFieldData()->HasArray(TetrahedraArray) != 0;
}

shape::FiniteElements vtkShapeFiniteElements::Read(vtkPolyData* data, const std::string& name)
{
  vtkDataArray* corners = data->GetFieldData()->GetArray(TetrahedraArray);
  if (!corners || corners->GetNumberOfComponents() != 4)
  {
    throw shape::InvalidInput(name +
      " has no field data array 'Tetrahedra' of 4 components; connect the output Charges of Shape "
      "Harmonic Volume Map");
  }
  shape::FiniteElements elements;
  elements.Points = vtkShapeConvert::ToPoints(data);
  elements.Images = vtkShapeConvert::ToPointArray(data, "TargetPosition", 3, name);
  shape::RequireFinite(elements.Points, name);
  shape::RequireFinite(elements.Images, "the images of " + name);
  elements.Tetrahedra.resize(corners->GetNumberOfTuples(), 4);
  for (Eigen::Index t = 0; t < elements.Tetrahedra.rows(); ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      elements.Tetrahedra(t, k) = static_cast<int>(corners->GetComponent(t, k));
    }
  }
  elements.Boundary = vtkShapeConvert::ToMesh(data, name).Triangles;
  return elements;
}

void vtkShapeFiniteElements::Share(
  vtkMultiProcessController* controller, shape::FiniteElements& elements)
{
  if (!controller || controller->GetNumberOfProcesses() == 1)
  {
    return;
  }
  // Indices are sent as doubles, which represent them exactly.
  Eigen::MatrixXd tetrahedra = elements.Tetrahedra.cast<double>();
  Eigen::MatrixXd boundary = elements.Boundary.cast<double>();
  for (Eigen::MatrixXd* matrix : { &elements.Points, &elements.Images, &tetrahedra, &boundary })
  {
    vtkShapeGather::Share(controller, *matrix);
  }
  elements.Tetrahedra = tetrahedra.cast<int>();
  elements.Boundary = boundary.cast<int>();
}

void vtkShapeFiniteElements::Write(const shape::FiniteElements& elements, vtkPolyData* output)
{
  vtkShapeConvert::FromMesh({ elements.Points, elements.Boundary }, output);
  output->GetPointData()->AddArray(vtkShapeConvert::ToArray(elements.Images, "TargetPosition"));
  output->GetPointData()->AddArray(
    vtkShapeConvert::ToArray(Eigen::MatrixXd::Zero(elements.Points.rows(), 3), "Charge"));
  vtkNew<vtkIntArray> corners;
  corners->SetName(TetrahedraArray);
  corners->SetNumberOfComponents(4);
  corners->SetNumberOfTuples(elements.Tetrahedra.rows());
  for (Eigen::Index t = 0; t < elements.Tetrahedra.rows(); ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      corners->SetTypedComponent(t, k, elements.Tetrahedra(t, k));
    }
  }
  output->GetFieldData()->AddArray(corners);
}
