#pragma once

#include <QObject>
#include <QString>

class QAction;
class pqOutputPort;

/**
 * Makes File > Save Data write the file type that the user chooses.
 *
 * Two writers may have the same extension: a deck is written anew, or with its nodes moved.
 * ParaView 5.11 shows both types, and takes the first writer of the extension, whatever type is
 * chosen. This class shows the dialog instead. If the chosen writer is the one that ParaView
 * takes, ParaView writes the file.
 */
class pqShapeSaveData : public QObject
{
  Q_OBJECT

public:
  pqShapeSaveData(QObject* parent = nullptr);
  ~pqShapeSaveData() override;

  /// ParaView calls these when it has loaded the plugin, and at its end.
  void startup();
  void shutdown();

private:
  void FindActions();
  static void Save();
  static void Write(pqOutputPort* port, const QString& writer, const QString& path);
};
