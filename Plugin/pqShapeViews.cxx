#include "pqShapeViews.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqOutputPort.h"
#include "pqPVApplicationCore.h"
#include "pqPipelineSource.h"
#include "pqPythonManager.h"
#include "pqUndoStack.h"

#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkSMProxy.h"
#include "vtkSMTrace.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>

#include <functional>
#include <string>

namespace
{

/// An entry of the menu.
struct Layout
{
  const char* Function; ///< in shapemap.views
  const char* Label;
  const char* Icon;
  const char* Tip;
  const char* Needs;
  std::function<bool(pqOutputPort*)> CanShow;
};

bool HasPointArray(pqOutputPort* port, const char* name)
{
  return port->getDataInformation()->GetPointDataInformation()->GetArrayInformation(name);
}

bool HasCellArray(pqOutputPort* port, const char* name)
{
  return port->getDataInformation()->GetCellDataInformation()->GetArrayInformation(name);
}

const std::vector<Layout> Layouts = {
  { "map_quality", "Map Quality", ":/ShapeMap/ViewMapQuality.svg",
    "Show a shape and its image side by side, coloured by the distortion of the map",
    "the point array TargetPosition or SourcePosition, which filters that map shapes make",
    [](pqOutputPort* port)
    { return HasPointArray(port, "TargetPosition") || HasPointArray(port, "SourcePosition"); } },
  { "correspondence", "Correspondence", ":/ShapeMap/ViewCorrespondence.svg",
    "Show two surfaces with the same colours at corresponding points, landmarks and the error "
    "curve",
    "the output of Shape Correspondence",
    [](pqOutputPort* port)
    { return QString("ShapeCorrespondence") == port->getSource()->getProxy()->GetXMLName(); } },
  { "hexahedra", "Hexahedra", ":/ShapeMap/ViewHexahedra.svg",
    "Show a cut through hexahedra and the histogram of their quality. Select the Clip to move the "
    "cut",
    "the cell array ScaledJacobian, which Shape Hex Remesh makes",
    [](pqOutputPort* port) { return HasCellArray(port, "ScaledJacobian"); } },
  { "deck_check", "Deck Check", ":/ShapeMap/ViewDeck.svg",
    "Show the regions and patches of a solid mesh, with the number of cells and faces of each",
    "the cell array RegionId, which Shape Hex Remesh and Shape Tetrahedralize make",
    [](pqOutputPort* port) { return HasCellArray(port, "RegionId"); } },
};

void Show(const Layout& layout)
{
  // ParaView cannot take back the creation of a layout, and crashes if it tries: as after a command
  // in its Python shell, there is nothing to undo.
  BEGIN_UNDO_EXCLUDE();
  {
    SM_SCOPED_TRACE(TraceText)
      .arg(("from shapemap import views\nviews." + std::string(layout.Function) + "()").c_str())
      .arg("comment", "show the active source");
  }
  // The trace has the one call: ParaView does not trace all that a layout of views needs.
  SM_SCOPED_TRACE(BlockTraceItems);
  pqPVApplicationCore::instance()->pythonManager()->executeCode(
    QString("import shapemap.views\nshapemap.views.show('%1')\n").arg(layout.Function).toUtf8());
  END_UNDO_EXCLUDE();
  CLEAR_UNDO_STACK();
}

} // namespace

pqShapeViews::pqShapeViews(QObject* parent)
  : QObject(parent)
{
}

void pqShapeViews::startup()
{
  connect(pqApplicationCore::instance(), &pqApplicationCore::clientEnvironmentDone, this,
    [this]() { this->AddMenu(); });
  this->AddMenu();
}

void pqShapeViews::AddMenu()
{
  auto* window = qobject_cast<QMainWindow*>(pqCoreUtilities::mainWidget());
  auto* view = window ? window->menuBar()->findChild<QMenu*>("menu_View") : nullptr;
  if (this->Menu || !view)
  {
    return;
  }
  this->Menu = view->addMenu("ShapeMap Views");
  this->Menu->setObjectName("ShapeMapViews");
  for (const Layout& layout : Layouts)
  {
    QAction* action = this->Menu->addAction(QIcon(layout.Icon), layout.Label);
    action->setObjectName(layout.Function);
    connect(action, &QAction::triggered, [&layout]() { Show(layout); });
  }
  connect(this->Menu, &QMenu::aboutToShow, this, &pqShapeViews::Enable);
}

void pqShapeViews::Enable()
{
  pqOutputPort* port = pqActiveObjects::instance().activePort();
  const bool hasData = port && port->getSource()->modifiedState() != pqProxy::UNINITIALIZED;
  const QList<QAction*> actions = this->Menu->actions();
  for (int i = 0; i < actions.size(); ++i)
  {
    const bool enabled = hasData && Layouts[i].CanShow(port);
    actions[i]->setEnabled(enabled);
    actions[i]->setStatusTip(
      enabled ? Layouts[i].Tip : QString("%1 needs %2").arg(Layouts[i].Label, Layouts[i].Needs));
  }
}
