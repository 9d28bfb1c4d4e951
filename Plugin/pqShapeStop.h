#pragma once

#include <QObject>
#include <QString>

#include <atomic>
#include <memory>
#include <set>

class pqPipelineSource;
class pqServerManagerModelItem;
class pqShapeStopWatch;

/**
 * Makes the abort button of ParaView's status bar work while a ShapeMap filter runs, here or on a
 * server. Escape in the window does the same.
 *
 * ParaView 5.11 never enables that button for a filter, and processes no event until the filter has
 * ended. pqShapeStopWatch notices that the button is pressed; vtkShapeProgress (here) or
 * vtkShapeRemoteStop (on a server) stops the filter at its next report. The status bar then says
 * so, and Apply is enabled again.
 */
class pqShapeStop : public QObject
{
  Q_OBJECT

public:
  pqShapeStop(QObject* parent = nullptr);
  ~pqShapeStop() override;

  /// ParaView calls these when it has loaded the plugin, and at its end.
  void startup();
  void shutdown();

private Q_SLOTS:
  void OnProgress(const QString& text, int percent);
  void OnEnd();
  void Report();
  void OnModifiedStateChanged(pqServerManagerModelItem* item);

private:
  void StartWatch();

  std::unique_ptr<pqShapeStopWatch> Watch;
  std::atomic<bool> Wanted{ false };
  QString Label;      ///< of the filter that runs
  QString Unreported; ///< label of the filter that was stopped, until the window shows it
  int Percent = 0;
  std::set<pqPipelineSource*> Stopped; ///< not yet run again
};
