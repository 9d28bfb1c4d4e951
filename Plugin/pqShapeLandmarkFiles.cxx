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

#include <QSaveFile>
#include <QStringList>
#include <QTextStream>

#include <cstddef>
#include <functional>

namespace
{

QString FindName(const pqShapeLandmarkTable& table, std::size_t i)
{
  const QString name = i < table.Names.size() ? QString::fromStdString(table.Names[i]) : QString();
  return name.isEmpty() ? QString::number(i + 1) : name;
}

/// Writes three numbers for each landmark. before, after: for each one, what is around its numbers.
void WriteRows(QTextStream& stream, const std::vector<const std::vector<double>*>& columns,
  const char* separator, const std::function<QString(std::size_t)>& before,
  const std::function<QString(std::size_t)>& after)
{
  for (std::size_t i = 0; 3 * i < columns.front()->size(); ++i)
  {
    QStringList numbers;
    for (const std::vector<double>* values : columns)
    {
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
      {
        numbers << QString::number((*values)[k], 'g', 17); // every bit
      }
    }
    stream << before(i) << numbers.join(separator) << after(i) << '\n';
  }
}

QString Nothing(std::size_t)
{
  return {};
}

void WriteCSV(QTextStream& stream, const pqShapeLandmarkTable& table)
{
  const bool isPaired = !table.TargetPoints.empty();
  stream << (isPaired ? "x,y,z,tx,ty,tz,name\n" : "x,y,z,name\n");
  std::vector<const std::vector<double>*> columns{ &table.Points };
  if (isPaired)
  {
    columns.push_back(&table.TargetPoints);
  }
  WriteRows(stream, columns, ",", Nothing,
    [&](std::size_t i) { return ",\"" + FindName(table, i).replace('"', "\"\"") + '"'; });
}

void WritePTS(QTextStream& stream, const pqShapeLandmarkTable& table)
{
  stream << "Version 1.0\n" << table.Points.size() / 3 << '\n';
  // A name is one word.
  WriteRows(
    stream, { &table.Points }, " ",
    [&](std::size_t i) { return FindName(table, i).simplified().replace(' ', '_') + ' '; },
    Nothing);
}

void WriteTPS(QTextStream& stream, const pqShapeLandmarkTable& table)
{
  int number = 0;
  for (const std::vector<double>* points : { &table.Points, &table.TargetPoints })
  {
    if (!points->empty())
    {
      stream << "LM3=" << points->size() / 3 << '\n';
      WriteRows(stream, { points }, " ", Nothing, Nothing);
      stream << "ID=" << ++number << '\n';
    }
  }
}

} // namespace

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

QString Write(const QString& path, const pqShapeLandmarkTable& table)
{
  const bool isPTS = path.endsWith(".pts", Qt::CaseInsensitive);
  if (isPTS && !table.TargetPoints.empty())
  {
    return QObject::tr("A .pts file has no pairs; save as .csv or .tps.");
  }
  QSaveFile file(path); // replaces an older file only when it is complete
  const QString failure = QObject::tr("Cannot write %1; choose another folder.").arg(path);
  if (!file.open(QIODevice::WriteOnly | QIODevice::Text))
  {
    return failure;
  }
  QTextStream stream(&file);
  stream.setCodec("UTF-8");
  isPTS                                          ? WritePTS(stream, table)
    : path.endsWith(".tps", Qt::CaseInsensitive) ? WriteTPS(stream, table)
                                                 : WriteCSV(stream, table);
  stream.flush();
  return stream.status() == QTextStream::Ok && file.commit() ? QString() : failure;
}

} // namespace pqShapeLandmarkFiles
