#include "pqShapeRows.h"

#include "pqShapeSliders.h"

#include "vtkPVXMLElement.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMIntVectorProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxyProperty.h"

#include "pqApplicationCore.h"
#include "pqDoubleVectorPropertyWidget.h"
#include "pqIntVectorPropertyWidget.h"
#include "pqInterfaceTracker.h"
#include "pqProxyPropertyWidget.h"
#include "pqSelectionManager.h"

#include <QComboBox>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace
{

vtkPVXMLElement* FindPropertyHint(vtkSMProperty* property, const char* name)
{
  vtkPVXMLElement* hints = property->GetHints();
  return hints ? hints->FindNestedElementByName(name) : nullptr;
}

/// Returns "Reversible Harmonic" for "ReversibleHarmonic".
QString ToWords(QString value)
{
  static const QRegularExpression border("([a-z])([A-Z])");
  return value.replace(border, "\\1 \\2");
}

pqPropertyWidget* MakeChoice(vtkSMIntVectorProperty* property, vtkSMProxy* proxy, QWidget* parent)
{
  pqPropertyWidget* row = pqIntVectorPropertyWidget::createWidget(property, proxy, parent);
  auto* list = row->findChild<QComboBox*>("ComboBox");
  if (!list)
  {
    return row;
  }
  auto* words = property->FindDomain<vtkSMEnumerationDomain>();
  const QSignalBlocker blocker(list);
  for (unsigned int i = 0; i < words->GetNumberOfEntries(); ++i)
  {
    // ParaView appends the explanation to the text. The data of the item stays the word itself.
    const int item = list->findData(QString(words->GetEntryText(i)));
    list->setItemText(item, ToWords(words->GetEntryText(i)));
    const QString explanation = QString(words->GetInfoText(i)).simplified();
    if (!explanation.isEmpty())
    {
      list->setItemData(
        item, QString("<qt>%1</qt>").arg(explanation.toHtmlEscaped()), Qt::ToolTipRole);
    }
  }
  return row;
}

/// Returns about how many hexahedra fill a solid: those inside, and the layers along its boundary.
/// The factors fit generated shapes; where thin parts or creases need smaller cells, there are
/// more.
double EstimateCellCount(vtkSMProxy* proxy, vtkPVXMLElement* hint, double number)
{
  const char* name = hint->GetAttributeOrEmpty("size");
  proxy->UpdatePropertyInformation(proxy->GetProperty(name));
  const std::vector<double> measures = vtkSMPropertyHelper(proxy, name).GetDoubleArray();
  if (measures.size() != 3 || number <= 0.0)
  {
    return 0.0;
  }
  vtkSMPropertyHelper layers(proxy, hint->GetAttributeOrEmpty("layers"));
  layers.SetUseUnchecked(true);
  const double size = hint->GetAttribute("on_longest_edge") ? measures[2] / number : number;
  constexpr double first = 1.1, further = 0.7; // cells of a layer, per square on the boundary
  return measures[0] / std::pow(size, 3) +
    (first + further * (layers.GetAsInt() - 1)) * measures[1] / std::pow(size, 2);
}

/// Adds what the number in a row means: the text of the hint Zero, or the number of hexahedra.
pqPropertyWidget* ExplainNumber(pqPropertyWidget* row, vtkSMProperty* property, vtkSMProxy* proxy)
{
  auto* edit = row->findChild<QLineEdit*>();
  if (!edit)
  {
    return row;
  }
  vtkPVXMLElement* count = FindPropertyHint(property, "CellCount");
  auto* zero = new QLabel(FindPropertyHint(property, "Zero")->GetAttributeOrEmpty("text"), row);
  zero->setObjectName("Zero");
  auto* cells = new QLabel(row);
  cells->setObjectName("CellCount");
  cells->setToolTip(
    QObject::tr("An estimate from the volume and the area of the surface. There are "
                "more cells if thin parts or creases need smaller ones."));
  row->layout()->addWidget(zero);
  row->layout()->addWidget(cells);
  const auto update = [=](const QString& text)
  {
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    zero->setVisible(isNumber && number == 0.0);
    const double estimate = count && isNumber ? EstimateCellCount(proxy, count, number) : 0.0;
    // Two digits: it is an estimate.
    const double unit = std::pow(10.0, std::floor(std::log10(std::max(estimate, 10.0))) - 1.0);
    cells->setText(QObject::tr("\u2248 %1 cells")
                     .arg(QLocale(QLocale::English)
                            .toString(static_cast<qlonglong>(std::round(estimate / unit) * unit))));
    cells->setVisible(estimate >= 1.0);
  };
  QObject::connect(edit, &QLineEdit::textChanged, zero, update);
  update(edit->text());
  return row;
}

pqPropertyWidget* MakeSelection(vtkSMProxyProperty* property, vtkSMProxy* proxy, QWidget* parent)
{
  auto* row = new pqProxyPropertyWidget(property, proxy, parent);
  auto* copy = row->findChild<QPushButton*>("pushButtonCopySelection");
  if (!copy)
  {
    return row;
  }
  auto* label =
    new QLabel(QObject::tr("Nothing is selected: select cells or points in the view first."), row);
  label->setObjectName("NothingSelected");
  label->setWordWrap(true);
  label->hide();
  row->layout()->addWidget(label);
  QObject::connect(copy, &QPushButton::clicked, label,
    [label]
    {
      auto* selection = qobject_cast<pqSelectionManager*>(
        pqApplicationCore::instance()->manager("SelectionManager"));
      label->setVisible(selection && !selection->hasActiveSelection());
    });
  return row;
}

} // namespace

void pqShapeRows::startup()
{
  pqApplicationCore::instance()->interfaceTracker()->addInterface(this);
}

void pqShapeRows::shutdown()
{
  pqApplicationCore::instance()->interfaceTracker()->removeInterface(this);
}

pqPropertyWidget* pqShapeRows::createWidgetForProperty(
  vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent)
{
  if (std::strncmp(proxy->GetXMLName(), "Shape", 5) != 0 || property->GetPanelWidget())
  {
    return nullptr;
  }
  auto* integers = vtkSMIntVectorProperty::SafeDownCast(property);
  if (integers && property->FindDomain<vtkSMEnumerationDomain>())
  {
    return MakeChoice(integers, proxy, parent);
  }
  if (FindPropertyHint(property, "Zero"))
  {
    auto* numbers = vtkSMDoubleVectorProperty::SafeDownCast(property);
    return ExplainNumber(numbers ? new pqDoubleVectorPropertyWidget(numbers, proxy, parent)
                                 : pqIntVectorPropertyWidget::createWidget(integers, proxy, parent),
      property, proxy);
  }
  if (FindPropertyHint(property, "Sliders"))
  {
    return new pqShapeSliders(proxy, property, parent);
  }
  auto* proxies = vtkSMProxyProperty::SafeDownCast(property);
  if (proxies && FindPropertyHint(property, "SelectionInput"))
  {
    return MakeSelection(proxies, proxy, parent);
  }
  return nullptr;
}
