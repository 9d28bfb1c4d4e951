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

Eigen::MatrixXi vtkShapeFiniteElements::ReadCorners(vtkDataArray* array)
{
  Eigen::MatrixXi tetrahedra(array->GetNumberOfTuples(), 4);
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      tetrahedra(t, k) = static_cast<int>(array->GetComponent(t, k));
    }
  }
  return tetrahedra;
}

vtkSmartPointer<vtkIntArray> vtkShapeFiniteElements::WriteCorners(
  const Eigen::MatrixXi& tetrahedra, const std::string& name)
{
  auto corners = vtkSmartPointer<vtkIntArray>::New();
  corners->SetName(name.c_str());
  corners->SetNumberOfComponents(4);
  corners->SetNumberOfTuples(tetrahedra.rows());
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      corners->SetTypedComponent(t, k, tetrahedra(t, k));
    }
  }
  return corners;
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
  elements.Tetrahedra = ReadCorners(corners);
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
  output->GetFieldData()->AddArray(WriteCorners(elements.Tetrahedra, TetrahedraArray));
}
