#pragma once

#include <QObject>
#include <QPointer>

class QAction;
class QMenu;
class pqProxyGroupMenuManager;
class vtkSMProxy;

/**
 * @class   pqShapeMenu
 * @brief   arranges Filters > ShapeMap by task, enables its entries and finds them by search words
 *
 * Everything that it shows about a filter is in the filter's XML:
 *
 *     <Hints>
 *       <ShowInMenu category="ShapeMap" icon=":/ShapeMap/X.svg"/>
 *       <ShapeMap task="Hexahedra" order="1" keywords="hex mesh, mesher" needs="a closed surface"/>
 *     </Hints>
 *
 * `task` is a section of the menu and `order` the position in it. A filter without `task` is in the
 * last section, More. The quick search (Ctrl+Space) finds the filter by its label and its
 * `keywords`. If the filter cannot work with the data in the pipeline, the entry is disabled, and
 * the status bar says what the filter needs: "Shape Hex Remesh needs a closed surface".
 *
 * ParaView checks one input only. Here a filter is enabled if the active output can be one of its
 * required inputs, and each other required input can be some output of the pipeline.
 * `<PointArray inputs="A B" name="N" components="3"/>` inside `<ShapeMap>` says, in addition, that
 * one of these inputs must have such a point array (any name if there is no `name`).
 *
 * If several outputs are selected in the pipeline browser, the filters are enabled that need as
 * many inputs. The outputs become these inputs in the order of their selection, or in the first
 * order that fits.
 */
class pqShapeMenu : public QObject
{
  Q_OBJECT

public:
  explicit pqShapeMenu(QObject* parent = nullptr);

  /// Called when the plugin is loaded: before the window is made, or at any time later.
  void startup();
  void shutdown() {}

private:
  void FindMenus();
  static void Arrange(pqProxyGroupMenuManager* manager);
  static void Enable(pqProxyGroupMenuManager* manager);
  static void TakeSelected(pqProxyGroupMenuManager* manager, QAction* action);
  static void AddSearchWords(pqProxyGroupMenuManager* manager);

  QList<QPointer<pqProxyGroupMenuManager>> Managers;
};
