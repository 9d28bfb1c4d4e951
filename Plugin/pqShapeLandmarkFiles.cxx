#include "pqShapeLandmarkFiles.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkPVSession.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"

#include "pqActiveObjects.h"
#include "pqServer.h"

#include <QFile>
#include <QTextStream>

#include <cstddef>

namespace pqShapeLandmarkFiles
{

bool Read(const QString& path, pqShapeLandmarkTable& table)
{
  // The reader runs in the window, which has the plugin, too.
  vtkSmartPointer<vtkSMProxy> proxy;
  proxy.TakeReference(pqActiveObjects::instance().activeServer()->proxyManager()->NewProxy(
    "internal_sources", "ShapeLandmarksReaderCore"));
  proxy->SetLocation(vtkPVSession::CLIENT);
  vtkSMPropertyHelper(proxy, "FileName").Set(path.toUtf8().data());
  proxy->UpdateVTKObjects();
  auto* reader = vtkAlgorithm::SafeDownCast(proxy->GetClientSideObject());
  reader->Update();
  auto* points = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
  if (points->GetNumberOfPoints() == 0)
  {
    return false;
  }
  table = {};
  vtkDataArray* targets = points->GetPointData()->GetArray("TargetPosition");
  auto* names = vtkStringArray::SafeDownCast(points->GetPointData()->GetAbstractArray("Name"));
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const double* position = points->GetPoint(i);
    table.Points.insert(table.Points.end(), position, position + 3);
    if (targets)
    {
      const double* target = targets->GetTuple3(i);
      table.TargetPoints.insert(table.TargetPoints.end(), target, target + 3);
    }
    // A name that is only the number is the default.
    const std::string name = names ? names->GetValue(i) : std::string();
    table.Names.push_back(name == std::to_string(i + 1) ? "" : name);
  }
  return true;
}

bool Write(const QString& path, const pqShapeLandmarkTable& table)
{
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly | QIODevice::Text))
  {
    return false;
  }
  QTextStream stream(&file);
  stream.setCodec("UTF-8");
  stream.setRealNumberPrecision(17); // every bit
  const bool isPaired = !table.TargetPoints.empty();
  stream << (isPaired ? "x,y,z,tx,ty,tz,name\n" : "x,y,z,name\n");
  for (std::size_t i = 0; 3 * i < table.Points.size(); ++i)
  {
    for (const std::vector<double>* values : { &table.Points, &table.TargetPoints })
    {
      for (std::size_t k = 3 * i; k < 3 * i + 3 && !values->empty(); ++k)
      {
        stream << (*values)[k] << ',';
      }
    }
    QString name = i < table.Names.size() ? QString::fromStdString(table.Names[i]) : QString();
    name = name.isEmpty() ? QString::number(i + 1) : name;
    stream << '"' << name.replace('"', "\"\"") << "\"\n";
  }
  stream.flush();
  return stream.status() == QTextStream::Ok;
}

} // namespace pqShapeLandmarkFiles
