#include "pqShapeMenu.h"

#include "pqShapeNeeded.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqOutputPort.h"
#include "pqPVApplicationCore.h"
#include "pqProxyGroupMenuManager.h"
#include "pqServer.h"
#include "pqServerManagerModel.h"

#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDocumentation.h"
#include "vtkSMInputProperty.h"
#include "vtkSMProxy.h"
#include "vtkSMProxySelectionModel.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QTimer>

#include <algorithm>

namespace
{

const char* const Category = "ShapeMap";
const QStringList Tasks = { "Prepare", "Map surfaces", "Map solids", "Hexahedra",
  "Deform and compose", "Measure" };
const char* const OtherTask = "More";

vtkPVXMLElement* FindHint(vtkSMProxy* prototype)
{
  vtkPVXMLElement* hints = prototype ? prototype->GetHints() : nullptr;
  return hints ? hints->FindNestedElementByName("ShapeMap") : nullptr;
}

QString GetHint(vtkSMProxy* prototype, const char* attribute)
{
  vtkPVXMLElement* hint = FindHint(prototype);
  return hint ? hint->GetAttributeOrEmpty(attribute) : "";
}

QMenu* FindCategoryMenu(pqProxyGroupMenuManager* manager)
{
  return manager->menu()->findChild<QMenu*>(Category, Qt::FindDirectChildrenOnly);
}

/// Whether an output can be this input, by the domains in the XML.
bool Fits(vtkSMInputProperty* input, pqOutputPort* output)
{
  input->RemoveAllUncheckedProxies();
  input->AddUncheckedInputConnection(output->getSource()->getProxy(), output->getPortNumber());
  const bool fits = input->IsInDomains() > 0;
  input->RemoveAllUncheckedProxies();
  return fits;
}

/// Whether an output has the array of a hint PointArray.
bool HasArray(pqOutputPort* output, vtkPVXMLElement* hint)
{
  const QString name = hint->GetAttributeOrEmpty("name");
  int components = 0;
  hint->GetScalarAttribute("components", &components);
  vtkPVDataSetAttributesInformation* arrays =
    output->getDataInformation()->GetPointDataInformation();
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkPVArrayInformation* array = arrays->GetArrayInformation(i);
    if (array->GetNumberOfComponents() == components &&
      (name.isEmpty() || name == array->GetName()))
    {
      return true;
    }
  }
  return false;
}

using Outputs = QList<pqOutputPort*>;

/// Whether a filter can work if the candidates for its required inputs, by name, are these.
bool CanWork(vtkSMProxy* prototype, const QMap<QString, Outputs>& candidates)
{
  const bool allFound = std::all_of(candidates.begin(), candidates.end(),
    [](const Outputs& outputs) { return !outputs.isEmpty(); });
  vtkPVXMLElement* hint = FindHint(prototype);
  bool arraysFound = true;
  for (unsigned int i = 0; hint && i < hint->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* array = hint->GetNestedElement(i);
    const QStringList inputs = QString(array->GetAttributeOrEmpty("inputs")).split(' ');
    arraysFound &= std::any_of(inputs.begin(), inputs.end(),
      [&](const QString& input)
      {
        const Outputs outputs = candidates.value(input);
        return std::any_of(outputs.begin(), outputs.end(),
          [&](pqOutputPort* output) { return HasArray(output, array); });
      });
  }
  return allFound && arraysFound;
}

/// The same for some choice of the input that the active output becomes.
bool CanWork(vtkSMProxy* prototype, pqOutputPort* active, const Outputs& all)
{
  QMap<QString, Outputs> candidates;
  for (const QString& name : pqShapeNeeded::GetInputs(prototype))
  {
    auto* input = vtkSMInputProperty::SafeDownCast(prototype->GetProperty(name.toUtf8().data()));
    std::copy_if(all.begin(), all.end(), std::back_inserter(candidates[name]),
      [&](pqOutputPort* output) { return Fits(input, output); });
  }
  for (const QString& name : candidates.keys())
  {
    QMap<QString, Outputs> choice = candidates;
    if (choice[name].contains(active))
    {
      choice[name] = { active };
      if (CanWork(prototype, choice))
      {
        return true;
      }
    }
  }
  return false;
}

bool HasData(pqPipelineSource* source)
{
  return source->modifiedState() != pqProxy::UNINITIALIZED;
}

/// The outputs with data in the pipeline of a server.
Outputs FindOutputs(pqServer* server)
{
  Outputs outputs;
  auto* model = pqApplicationCore::instance()->getServerManagerModel();
  for (pqPipelineSource* source : model->findItems<pqPipelineSource*>(server))
  {
    if (HasData(source))
    {
      outputs += source->getOutputPorts();
    }
  }
  return outputs;
}

} // namespace

pqShapeMenu::pqShapeMenu(QObject* parent)
  : QObject(parent)
{
}

void pqShapeMenu::startup()
{
  connect(pqApplicationCore::instance(), &pqApplicationCore::clientEnvironmentDone, this,
    [this]() { this->FindMenus(); });
  this->FindMenus();
}

void pqShapeMenu::FindMenus()
{
  for (QWidget* widget : QApplication::allWidgets())
  {
    auto* manager = qobject_cast<QMenu*>(widget)
      ? widget->findChild<pqProxyGroupMenuManager*>(QString(), Qt::FindDirectChildrenOnly)
      : nullptr;
    if (!manager || this->Managers.contains(manager))
    {
      continue;
    }
    this->Managers.append(manager);
    connect(
      manager, &pqProxyGroupMenuManager::menuPopulated, this, [manager]() { Arrange(manager); });
    // After ParaView's own answer to these signals, which disables what it deems unfit.
    connect(manager->menu(), &QMenu::aboutToShow, this, [manager]() { Enable(manager); });
    if (manager->supportsQuickLaunch())
    {
      connect(pqPVApplicationCore::instance(), &pqPVApplicationCore::aboutToShowQuickLaunch,
        manager,
        [manager]()
        {
          Enable(manager);
          AddSearchWords(manager);
        });
    }
    Arrange(manager);
  }
}

void pqShapeMenu::Arrange(pqProxyGroupMenuManager* manager)
{
  QMenu* menu = FindCategoryMenu(manager);
  if (!menu)
  {
    return;
  }
  const auto taskOf = [manager](const QAction* action)
  {
    const QString task = GetHint(manager->getPrototype(const_cast<QAction*>(action)), "task");
    const int index = Tasks.indexOf(task);
    return index < 0 ? Tasks.size() : index;
  };
  const auto key = [&](QAction* action)
  {
    return std::make_tuple(
      taskOf(action), GetHint(manager->getPrototype(action), "order").toInt(), action->text());
  };
  QList<QAction*> actions = manager->actions(Category);
  std::sort(
    actions.begin(), actions.end(), [&](QAction* a, QAction* b) { return key(a) < key(b); });
  menu->clear();
  int last = -1;
  for (QAction* action : actions)
  {
    const int task = taskOf(action);
    if (task != last)
    {
      menu->addSection(Tasks.value(task, OtherTask));
    }
    menu->addAction(action);
    last = task;
  }
}

void pqShapeMenu::Enable(pqProxyGroupMenuManager* manager)
{
  QMenu* menu = FindCategoryMenu(manager);
  pqActiveObjects& active = pqActiveObjects::instance();
  pqOutputPort* port = active.activePort();
  vtkSMProxySelectionModel* selection = active.activeSourcesSelectionModel();
  if (!menu || !port || !selection || selection->GetNumberOfSelectedProxies() != 1)
  {
    return; // ParaView's own answer holds: nothing, or several selected
  }
  const Outputs all = FindOutputs(port->getServer());
  // The other kind of menu, that of the pipeline browser, hides what is disabled.
  const bool hides = !manager->supportsQuickLaunch();
  QAction* section = nullptr;
  for (QAction* action : menu->actions())
  {
    if (action->isSeparator())
    {
      section = action;
      section->setVisible(!hides);
      continue;
    }
    vtkSMProxy* prototype = manager->getPrototype(action);
    const bool enabled = CanWork(prototype, port, all);
    action->setEnabled(enabled);
    action->setStatusTip(enabled ? prototype->GetDocumentation()->GetShortHelp()
        : HasData(port->getSource())
        ? QString("%1 needs %2").arg(prototype->GetXMLLabel(), GetHint(prototype, "needs"))
        : QString("Press Apply first: the active source has no data yet"));
    if (hides)
    {
      action->setVisible(enabled);
      section->setVisible(section->isVisible() || enabled);
      menu->menuAction()->setVisible(menu->menuAction()->isVisible() || enabled);
    }
  }
}

void pqShapeMenu::AddSearchWords(pqProxyGroupMenuManager* manager)
{
  // The dialog, which is filled right after this, searches the texts as they are now. When it
  // shows, the texts are the labels again.
  for (QAction* action : manager->actions())
  {
    const QString keywords = GetHint(manager->getPrototype(action), "keywords");
    if (!keywords.isEmpty())
    {
      const QString label = action->text();
      action->setText(QString("%1 (%2)").arg(label, keywords));
      QTimer::singleShot(0, action, [action, label]() { action->setText(label); });
    }
  }
}
