#include "pqShapeMenu.h"

#include "pqShapeNeeded.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqObjectBuilder.h"
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
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMProxySelectionModel.h"
#include "vtkSMTrace.h"

#include <QAction>
#include <QApplication>
#include <QMenu>
#include <QTimer>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

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

/// The outputs that are selected in the pipeline browser, in the order of their selection.
Outputs FindSelected()
{
  vtkSMProxySelectionModel* selection = pqActiveObjects::instance().activeSourcesSelectionModel();
  const auto* model = pqApplicationCore::instance()->getServerManagerModel();
  Outputs outputs;
  for (unsigned int i = 0; selection && i < selection->GetNumberOfSelectedProxies(); ++i)
  {
    auto* item = model->findItem<pqServerManagerModelItem*>(selection->GetSelectedProxy(i));
    auto* port = qobject_cast<pqOutputPort*>(item);
    auto* source = qobject_cast<pqPipelineSource*>(item);
    if (port || source)
    {
      outputs << (port ? port : source->getOutputPort(0));
    }
  }
  return outputs;
}

/// Returns the outputs for the required inputs of a filter, by their order, if there is exactly one
/// for each and the filter can work; otherwise, an empty list.
Outputs Assign(vtkSMProxy* prototype, const Outputs& outputs)
{
  const QStringList inputs = pqShapeNeeded::GetInputs(prototype);
  if (inputs.size() != outputs.size())
  {
    return {};
  }
  std::vector<int> order(static_cast<std::size_t>(outputs.size()));
  std::iota(order.begin(), order.end(), 0);
  do
  {
    QMap<QString, Outputs> candidates;
    Outputs assigned;
    for (int i = 0; i < inputs.size(); ++i)
    {
      pqOutputPort* output = outputs[order[static_cast<std::size_t>(i)]];
      auto* input =
        vtkSMInputProperty::SafeDownCast(prototype->GetProperty(inputs[i].toUtf8().data()));
      if (Fits(input, output))
      {
        candidates[inputs[i]] = { output };
        assigned << output;
      }
    }
    if (assigned.size() == outputs.size() && CanWork(prototype, candidates))
    {
      return assigned;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return {};
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
  for (QAction* action : actions)
  {
    if (!action->property("TakesSelected").toBool())
    {
      // Before ParaView's own answer, which makes the filter.
      action->setProperty("TakesSelected", true);
      action->disconnect(SIGNAL(triggered()), manager);
      connect(action, &QAction::triggered, manager,
        [manager, action]() { TakeSelected(manager, action); });
      connect(action, SIGNAL(triggered()), manager, SLOT(triggered()), Qt::UniqueConnection);
    }
  }
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
  const Outputs selected = FindSelected();
  if (!menu || !port || selected.isEmpty())
  {
    return; // ParaView's own answer holds
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
    const bool enabled =
      selected.size() > 1 ? !Assign(prototype, selected).isEmpty() : CanWork(prototype, port, all);
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

/// ParaView would connect all selected outputs to the first input. So only the first one is left
/// selected before ParaView makes the filter, and the others are connected after that.
void pqShapeMenu::TakeSelected(pqProxyGroupMenuManager* manager, QAction* action)
{
  vtkSMProxy* prototype = manager->getPrototype(action);
  const Outputs selected = FindSelected();
  const Outputs assigned = selected.size() > 1 ? Assign(prototype, selected) : Outputs();
  if (assigned.isEmpty())
  {
    return;
  }
  const QStringList inputs = pqShapeNeeded::GetInputs(prototype);
  pqActiveObjects::instance().setActivePort(assigned[0]);
  auto* once = new QObject(manager);
  connect(pqApplicationCore::instance()->getObjectBuilder(),
    QOverload<pqPipelineSource*>::of(&pqObjectBuilder::filterCreated), once,
    [once, assigned, inputs](pqPipelineSource* filter)
    {
      once->deleteLater();
      SM_SCOPED_TRACE(PropertiesModified).arg("proxy", filter->getProxy());
      for (int i = 1; i < inputs.size(); ++i)
      {
        vtkSMPropertyHelper(filter->getProxy(), inputs[i].toUtf8().data())
          .Set(assigned[i]->getSource()->getProxy(),
            static_cast<unsigned int>(assigned[i]->getPortNumber()));
      }
      filter->getProxy()->UpdateVTKObjects();
    });
  // If the filter is not made, nothing is connected to the next one.
  QTimer::singleShot(0, once, &QObject::deleteLater);
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
