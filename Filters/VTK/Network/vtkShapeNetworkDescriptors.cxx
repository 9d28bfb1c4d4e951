#include "vtkShapeNetworkDescriptors.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFileContent.h"
#include "vtkShapeList.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include "vtkDataArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkShapeNetworkDescriptors);

void vtkShapeNetworkDescriptors::SetNumberOfInputArrays(int count)
{
  vtkShapeList::Resize(this, this->InputArrays, count);
}

void vtkShapeNetworkDescriptors::SetInputArrays(int index, const std::string& name)
{
  vtkShapeList::Set(this, "Input Arrays", this->InputArrays, index, { name });
}

vtkShapeNetworkDescriptors::vtkShapeNetworkDescriptors()
{
  this->DeclareInput("Input", PortData::WholePolygons, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutputLikeInput();
  this->DeclareMemoryRemedy("lower Number Of Eigenpairs, or use a smaller network");
}

Eigen::MatrixXd vtkShapeNetworkDescriptors::ReadArrays(vtkPolyData* surface) const
{
  Eigen::MatrixXd values(surface->GetNumberOfPoints(), 0);
  for (const std::string& name : this->InputArrays)
  {
    if (vtkShapeConvert::IsChosen(name))
    {
      vtkDataArray* given = surface->GetPointData()->GetArray(name.c_str());
      const Eigen::MatrixXd array = vtkShapeConvert::ToPointArray(surface, name,
        given ? given->GetNumberOfComponents() : 1, "the surface", "choose an array of its points");
      shape::RequireFinite(array, "the array '" + name + "'");
      values.conservativeResize(Eigen::NoChange, values.cols() + array.cols());
      values.rightCols(array.cols()) = array;
    }
  }
  return values;
}

/// Every process computes the same descriptors from the gathered surface, and keeps those of its
/// own points.
void vtkShapeNetworkDescriptors::Execute(const shape::Progress& progress)
{
  if (this->FileName.empty())
  {
    throw shape::InvalidInput("File Name is empty; choose an ONNX file");
  }
  if (this->ArrayName.empty())
  {
    throw shape::InvalidInput("Array Name is empty; give the new array a name");
  }
  this->RepairInput(0, 0, false);
  const GatheredInput& whole = this->GetGatheredInput(0);
  const shape::Surface surface = vtkShapeConvert::ToMesh(whole.Data, "the surface");
  const Eigen::MatrixXd descriptors =
    shape::ComputeNetworkDescriptors(surface, vtkShapeFileContent::Read(this->FileName),
      this->ReadArrays(whole.Data), this->Options, progress);
  vtkShapeComposite::AddPointFields(this->GetInputDataObject(0, 0), this->GetOutputDataObject(0),
    { { this->ArrayName, vtkShapeConvert::Rows(descriptors, whole.OwnPoints) } });
}
