#include "pqShapeFetch.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkPVDataInformation.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"

namespace pqShapeFetch
{

vtkSmartPointer<vtkSMSourceProxy> NewFilter(const char* name, vtkSMSourceProxy* input, int port)
{
  vtkSmartPointer<vtkSMProxy> proxy;
  proxy.TakeReference(input->GetSessionProxyManager()->NewProxy("filters", name));
  vtkSMPropertyHelper(proxy, "Input").Set(input, static_cast<unsigned int>(port));
  return vtkSMSourceProxy::SafeDownCast(proxy);
}

vtkSmartPointer<vtkDataObject> Fetch(vtkSMSourceProxy* source, int port, double time)
{
  const vtkSmartPointer<vtkSMSourceProxy> gathered = NewFilter("ReductionFilter", source, port);
  const bool composite =
    source->GetDataInformation(static_cast<unsigned int>(port))->IsCompositeDataSet();
  vtkSMPropertyHelper(gathered, "PostGatherHelperName")
    .Set(composite ? "vtkMultiBlockDataGroupFilter" : "vtkAppendPolyData");
  gathered->UpdateVTKObjects();
  gathered->UpdatePipeline(time);
  vtkPVDataInformation* information = gathered->GetDataInformation(0);
  const vtkSmartPointer<vtkSMSourceProxy> moved = NewFilter("ClientServerMoveData", gathered, 0);
  vtkSMPropertyHelper(moved, "OutputDataType")
    .Set(composite ? information->GetCompositeDataSetType() : information->GetDataSetType());
  moved->UpdateVTKObjects();
  moved->UpdatePipeline(time);
  auto* algorithm = vtkAlgorithm::SafeDownCast(moved->GetClientSideObject());
  return algorithm ? algorithm->GetOutputDataObject(0) : nullptr;
}

} // namespace pqShapeFetch
