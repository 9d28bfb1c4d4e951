#pragma once

#include <QObject>

class QMenu;

/**
 * @class   pqShapeViews
 * @brief   adds View > ShapeMap Views: layouts of views for the active source
 *
 * The layouts are functions of the Python module shapemap.views (views.py), which scripts call,
 * too. An entry is enabled if the active output has what its layout needs; else the status bar says
 * what that is.
 */
class pqShapeViews : public QObject
{
  Q_OBJECT

public:
  explicit pqShapeViews(QObject* parent = nullptr);

  /// Called when the plugin is loaded: before the window is made, or at any time later.
  void startup();
  void shutdown() {}

private:
  void AddMenu();
  void Enable();

  QMenu* Menu = nullptr;
};
