#include "pqShapeSaveData.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqFileDialog.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqProxyWidgetDialog.h"
#include "pqSaveDataReaction.h"
#include "pqServer.h"
#include "vtkPVXMLElement.h"
#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMPropertyIterator.h"
#include "vtkSMProxyManager.h"
#include "vtkSMSessionProxyManager.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSMTrace.h"
#include "vtkSMVectorProperty.h"
#include "vtkSMWriterFactory.h"
#include "vtkSmartPointer.h"
#include "vtkVariant.h"

#include <QAction>
#include <QApplication>
#include <QFileInfo>
#include <QStringList>
#include <QWidget>

namespace
{

vtkSMWriterFactory* Factory()
{
  return vtkSMProxyManager::GetProxyManager()->GetWriterFactory();
}

vtkSMSourceProxy* SourceOf(pqOutputPort* port)
{
  return vtkSMSourceProxy::SafeDownCast(port->getSource()->getProxy());
}

/// Returns the names of the writers of a port and extension, in the order of ParaView's search. If
/// `type` is given, only the writers of that entry of the dialog.
QStringList FindWriters(pqOutputPort* port, const QString& extension, const QString& type = {})
{
  QStringList found;
  vtkSMSessionProxyManager* manager = port->getServer()->proxyManager();
  const QString names = Factory()->GetSupportedWriterProxies(SourceOf(port), port->getPortNumber());
  for (const QString& name : names.split(';'))
  {
    vtkPVXMLElement* hints = manager->GetProxyHints("writers", name.toUtf8().data());
    vtkPVXMLElement* entry = hints ? hints->FindNestedElementByName("WriterFactory") : nullptr;
    const QString extensions = entry ? entry->GetAttributeOrEmpty("extensions") : "";
    const QString description = entry ? entry->GetAttributeOrEmpty("file_description") : "";
    if (extensions.split(' ').contains(extension) &&
      (type.isEmpty() || type.startsWith(description + "(")))
    {
      found << name;
    }
  }
  return found;
}

/// Returns the Python call that writes the same file.
QString ToPython(pqOutputPort* port, vtkSMProxy* writer)
{
  QString input = "FindSource('" + port->getSource()->getSMName() + "')";
  if (port->getPortNumber() > 0)
  {
    input = "OutputPort(" + input + ", " + QString::number(port->getPortNumber()) + ")";
  }
  QString call = QString(writer->GetXMLName()) + "(Input=" + input;
  vtkSmartPointer<vtkSMPropertyIterator> properties;
  properties.TakeReference(writer->NewPropertyIterator());
  for (properties->Begin(); !properties->IsAtEnd(); properties->Next())
  {
    vtkSMProperty* property = properties->GetProperty();
    if (vtkSMVectorProperty::SafeDownCast(property) && !property->IsValueDefault() &&
      vtkSMPropertyHelper(property).GetNumberOfElements() == 1)
    {
      const QString quote = vtkSMStringVectorProperty::SafeDownCast(property) ? "'" : "";
      const std::string value = vtkSMPropertyHelper(property).GetAsVariant(0).ToString();
      call += QString(", ") + properties->GetKey() + "=" + quote + value.c_str() + quote;
    }
  }
  return call + ").UpdatePipeline()";
}

} // namespace

pqShapeSaveData::pqShapeSaveData(QObject* parent)
  : QObject(parent)
{
}

pqShapeSaveData::~pqShapeSaveData() = default;

void pqShapeSaveData::startup()
{
  this->connect(pqApplicationCore::instance(), &pqApplicationCore::clientEnvironmentDone, this,
    &pqShapeSaveData::FindActions);
  this->FindActions();
}

void pqShapeSaveData::shutdown()
{
}

/// The reaction of ParaView remains: it enables the action.
void pqShapeSaveData::FindActions()
{
  for (QWidget* window : QApplication::topLevelWidgets())
  {
    for (auto* reaction : window->findChildren<pqSaveDataReaction*>())
    {
      auto* action = qobject_cast<QAction*>(reaction->parent());
      // Nothing is left to disconnect if the action was found before.
      if (action && QObject::disconnect(action, nullptr, reaction, nullptr))
      {
        this->connect(action, &QAction::triggered, this, [] { Save(); });
      }
    }
  }
}

void pqShapeSaveData::Save()
{
  pqOutputPort* port = pqActiveObjects::instance().activePort();
  const QString types =
    port ? Factory()->GetSupportedFileTypes(SourceOf(port), port->getPortNumber()) : nullptr;
  if (types.isEmpty())
  {
    pqSaveDataReaction::saveActiveData(); // says why not
    return;
  }
  static QString extension = "pvd"; // of the last file
  pqFileDialog dialog(port->getServer(), pqCoreUtilities::mainWidget(), tr("Save File:"), QString(),
    types,
    /*groupFiles=*/false);
  dialog.setObjectName("FileSaveDialog");
  dialog.setRecentlyUsedExtension(extension);
  dialog.setFileMode(pqFileDialog::AnyFile);
  if (dialog.exec() != QDialog::Accepted)
  {
    return;
  }
  const QString path = dialog.getSelectedFiles()[0];
  extension = QFileInfo(path).suffix();
  const QString type = types.split(";;").value(dialog.getSelectedFilterIndex());
  const QStringList chosen = FindWriters(port, extension, type);
  if (chosen.isEmpty() || chosen[0] == FindWriters(port, extension).value(0))
  {
    pqSaveDataReaction::saveActiveData(path);
  }
  else
  {
    Write(port, chosen[0], path);
  }
}

void pqShapeSaveData::Write(pqOutputPort* port, const QString& name, const QString& path)
{
  vtkSmartPointer<vtkSMProxy> proxy;
  proxy.TakeReference(Factory()->CreateWriter(
    name.toUtf8().data(), SourceOf(port), port->getPortNumber(), /*proxybyname=*/true));
  auto* writer = vtkSMSourceProxy::SafeDownCast(proxy);
  vtkSMPropertyHelper(writer, "FileName").Set(path.toUtf8().data());
  pqProxyWidgetDialog dialog(writer, pqCoreUtilities::mainWidget());
  dialog.setObjectName("WriterSettingsDialog");
  dialog.setApplyChangesImmediately(true);
  dialog.setWindowTitle(tr("Configure Writer (%1)").arg(writer->GetXMLLabel()));
  if (dialog.hasVisibleWidgets() && dialog.exec() != QDialog::Accepted)
  {
    return;
  }
  writer->UpdateVTKObjects();
  writer->UpdatePipeline();
  SM_SCOPED_TRACE(TraceText)
    .arg(ToPython(port, writer).toUtf8().data())
    .arg("comment", "save data");
}
