#pragma once

#include "pqPropertyWidget.h"

#include <QList>
#include <QPointer>

#include <vector>

class QComboBox;
class QFormLayout;
class pqOutputPort;
class pqServerManagerModelItem;
class vtkSMInputProperty;
class vtkSMPropertyGroup;

/**
 * The inputs of a filter, as rows of its panel (panel_widget="ShapeInputs"). Each property of the
 * group is an input. Its row is a list of the outputs in the pipeline that suit it. A repeatable
 * input has one list for each connection, and one more to add a connection.
 *
 * An input with the hint <Optional needed="1"/> is optional for ParaView, which would otherwise ask
 * for it in a dialog, but the filter does not work without it. When the panel of a new filter
 * appears and only one other output suits such an input, this output is chosen.
 *
 * A choice takes effect with Apply, like any other value in the panel. Until then, it is the
 * unchecked value of the property, so that lists of arrays already show the arrays of the choice.
 */
class pqShapeInputsWidget : public pqPropertyWidget
{
  Q_OBJECT
  typedef pqPropertyWidget Superclass;

public:
  pqShapeInputsWidget(vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqShapeInputsWidget() override = default;

  void apply() override;
  void reset() override;

private Q_SLOTS:
  void Update();     ///< the lists follow the pipeline
  void OnModified(); ///< an input was changed elsewhere, as by undo or Change Input

private:
  Q_DISABLE_COPY(pqShapeInputsWidget)

  using Ports = QList<QPointer<pqOutputPort>>;
  struct Row
  {
    vtkSMInputProperty* Property;
    QWidget* Box;
    Ports Chosen;
    Ports Offered;
    QList<QComboBox*> Lists;
  };

  void AddRow(QFormLayout* layout, vtkSMInputProperty* property, const QString& name);
  Ports FindSuitable(vtkSMInputProperty* property) const;
  void ChooseNeeded(pqServerManagerModelItem* item); ///< if item is the filter, and new
  void UpdateRow(Row& row);
  void FillList(const Row& row, int index) const;
  void OnChosen(int row, int index, int entry);
  void ShowUnchecked(const Row& row) const;

  std::vector<Row> Rows;
  bool Applying = false;
};
