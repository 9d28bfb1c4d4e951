#pragma once

#include <QObject>
#include <QPointer>

class QFrame;
class QLabel;
class QPushButton;
class QTableWidget;
class pqPipelineSource;

/**
 * A summary of what the active ShapeMap filter did, above the rows of the properties panel: lines
 * of key facts, warnings, and a table of all facts, whose cells can be copied. It follows every run
 * of the filter. For filters without facts, it is hidden.
 *
 * The element Result among the hints of a filter declares what is shown:
 *
 * <Line text="{Hexahedra} hexahedra, mean {MeanScaledJacobian}"/>: names in braces are replaced by
 * facts, without the prefix of the filter. {Share%} is in percent. The line is left out if a fact
 * is missing.
 *
 * <Warning fact="Overlaps" above="0" text="..."/>: a line that is shown if the fact is above, or
 * below, the value.
 */
class pqShapeResult : public QObject
{
  Q_OBJECT

public:
  explicit pqShapeResult(QObject* parent = nullptr)
    : QObject(parent)
  {
  }
  ~pqShapeResult() override = default;

  void startup();
  void shutdown();

private Q_SLOTS:
  void Update();

private:
  Q_DISABLE_COPY(pqShapeResult)

  bool MakeFrame();
  void FillTable(pqPipelineSource* filter);

  QPointer<QFrame> Frame;
  QLabel* Lines = nullptr;
  QLabel* Warnings = nullptr;
  QPushButton* All = nullptr;
  QTableWidget* Table = nullptr;
};
