#include "pqShapePlacement.h"

#include "vtkActor.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"

#include "pqApplicationCore.h"
#include "pqDataRepresentation.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"

#include <functional>
#include <vector>

namespace pqShapePlacement
{

pqPipelineSource* FindSource(vtkSMProperty* input)
{
  return input
    ? pqApplicationCore::instance()->getServerManagerModel()->findItem<pqPipelineSource*>(
        vtkSMPropertyHelper(input).GetAsProxy())
    : nullptr;
}

pqDataRepresentation* FindShown(vtkSMProperty* input, pqView* view)
{
  pqPipelineSource* source = FindSource(input);
  pqOutputPort* port = source
    ? source->getOutputPort(static_cast<int>(vtkSMPropertyHelper(input).GetOutputPort()))
    : nullptr;
  pqDataRepresentation* representation = port && view ? port->getRepresentation(view) : nullptr;
  return representation && representation->isVisible() ? representation : nullptr;
}

Eigen::Affine3d FindTransform(pqDataRepresentation* representation)
{
  vtkNew<vtkActor> actor; // VTK's own order of the transformations
  vtkNew<vtkMatrix4x4> user;
  const auto read = [representation](const char* name, std::size_t count,
                      const std::function<void(const double*)>& use)
  {
    vtkSMProperty* property =
      representation ? representation->getProxy()->GetProperty(name) : nullptr;
    const std::vector<double> values =
      property ? vtkSMPropertyHelper(property).GetDoubleArray() : std::vector<double>();
    if (values.size() == count)
    {
      use(values.data());
    }
  };
  read("Position", 3, [&](const double* v) { actor->SetPosition(v[0], v[1], v[2]); });
  read("Scale", 3, [&](const double* v) { actor->SetScale(v[0], v[1], v[2]); });
  read("Orientation", 3, [&](const double* v) { actor->SetOrientation(v[0], v[1], v[2]); });
  read("Origin", 3, [&](const double* v) { actor->SetOrigin(v[0], v[1], v[2]); });
  read("UserTransform", 16, [&](const double* v) { user->DeepCopy(v); });
  actor->SetUserMatrix(user);
  Eigen::Affine3d transform;
  transform.matrix() =
    Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(actor->GetMatrix()->GetData());
  return transform;
}

pqShapeDisplay::Ray Transform(const Eigen::Affine3d& transform, const pqShapeDisplay::Ray& ray)
{
  const Eigen::Vector3d direction = transform.linear() * ray.Direction;
  return { transform * ray.Near, direction.normalized(), ray.First * direction.norm() };
}

} // namespace pqShapePlacement
