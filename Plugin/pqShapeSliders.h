#pragma once

#include "pqPropertyWidget.h"

#include <QList>
#include <QVariant>

#include <string>

class QFormLayout;
class QLabel;
class pqDoubleRangeWidget;
class vtkSMProperty;

/**
 * A slider for each number of a repeatable property. There are as many as the input has point
 * arrays whose names are a word with a number: Mode0, Mode1, ... The XML declares both:
 * <Hints><Sliders input="Atlas" array="Mode"/></Hints>. The range of the sliders is that of the
 * property; numbers beyond it can be typed.
 */
class pqShapeSliders : public pqPropertyWidget
{
  Q_OBJECT
  Q_PROPERTY(QList<QVariant> values READ GetValues WRITE SetValues)
  typedef pqPropertyWidget Superclass;

public:
  pqShapeSliders(vtkSMProxy* filter, vtkSMProperty* property, QWidget* parent);
  ~pqShapeSliders() override = default;

  QList<QVariant> GetValues() const;
  void SetValues(const QList<QVariant>& values);

Q_SIGNALS:
  void ValuesChanged();

private Q_SLOTS:
  void Update(); ///< there are as many sliders as modes

private:
  Q_DISABLE_COPY(pqShapeSliders)

  int CountArrays() const;
  void Resize(int count);

  std::string Input; ///< the property whose data has the arrays
  std::string Array; ///< their names without the number
  double Range[2] = { -1.0, 1.0 };
  QFormLayout* Rows;
  QLabel* Empty; ///< shown while there are none
  QList<pqDoubleRangeWidget*> Sliders;
  bool Setting = false; ///< the values come from the property
};
