#include "pqShapeRows.h"

#include "vtkPVXMLElement.h"
#include "vtkSMDocumentation.h"
#include "vtkSMDoubleVectorProperty.h"
#include "vtkSMEnumerationDomain.h"
#include "vtkSMIntVectorProperty.h"
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
#include <QMap>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>

#include <cstring>

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

/// Returns what a documentation says about values: "Value: ...", "Value (source): ..." or "Value
/// and Value: ...", up to the next one.
QMap<QString, QString> FindExplanations(const QString& documentation, const QStringList& values)
{
  QStringList escaped;
  for (const QString& value : values)
  {
    escaped << QRegularExpression::escape(value);
  }
  const QString any = "(?:" + escaped.join('|') + ")";
  const QRegularExpression start(QString("\\b(%1(?: and %1)*)(?: \\(([^)]*)\\))?: ").arg(any));
  QMap<QString, QString> explanations;
  QRegularExpressionMatch match = start.match(documentation);
  while (match.hasMatch())
  {
    const QRegularExpressionMatch next = start.match(documentation, match.capturedEnd());
    const int end = next.hasMatch() ? next.capturedStart() : documentation.size();
    QString text = documentation.mid(match.capturedEnd(), end - match.capturedEnd()).trimmed();
    text[0] = text[0].toUpper();
    const QString source = match.captured(2);
    for (const QString& value : match.captured(1).split(" and "))
    {
      explanations[value] = source.isEmpty() ? text : QString("%1 (%2)").arg(text, source);
    }
    match = next;
  }
  return explanations;
}

pqPropertyWidget* MakeChoice(vtkSMIntVectorProperty* property, vtkSMProxy* proxy, QWidget* parent)
{
  pqPropertyWidget* row = pqIntVectorPropertyWidget::createWidget(property, proxy, parent);
  auto* list = row->findChild<QComboBox*>("ComboBox");
  if (!list)
  {
    return row;
  }
  QStringList values; // as scripts and the property have them; they stay the data of the entries
  for (int i = 0; i < list->count(); ++i)
  {
    values << list->itemData(i).toString();
  }
  vtkSMDocumentation* documentation = property->GetDocumentation();
  const QMap<QString, QString> explanations = FindExplanations(
    QString(documentation ? documentation->GetDescription() : "").simplified(), values);
  const QSignalBlocker blocker(list);
  for (int i = 0; i < values.size(); ++i)
  {
    list->setItemText(i, ToWords(values[i]));
    if (explanations.contains(values[i]))
    {
      list->setItemData(
        i, QString("<qt>%1</qt>").arg(explanations[values[i]].toHtmlEscaped()), Qt::ToolTipRole);
    }
  }
  return row;
}

pqPropertyWidget* ExplainZero(pqPropertyWidget* row, const QString& meaning)
{
  auto* edit = row->findChild<QLineEdit*>();
  if (!edit)
  {
    return row;
  }
  auto* label = new QLabel(meaning, row);
  label->setObjectName("Zero");
  row->layout()->addWidget(label);
  const auto update = [label](const QString& text)
  {
    bool isNumber = false;
    label->setVisible(text.toDouble(&isNumber) == 0.0 && isNumber);
  };
  QObject::connect(edit, &QLineEdit::textChanged, label, update);
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
  if (vtkPVXMLElement* zero = FindPropertyHint(property, "Zero"))
  {
    auto* numbers = vtkSMDoubleVectorProperty::SafeDownCast(property);
    return ExplainZero(numbers ? new pqDoubleVectorPropertyWidget(numbers, proxy, parent)
                               : pqIntVectorPropertyWidget::createWidget(integers, proxy, parent),
      zero->GetAttributeOrEmpty("text"));
  }
  auto* proxies = vtkSMProxyProperty::SafeDownCast(property);
  if (proxies && FindPropertyHint(property, "SelectionInput"))
  {
    return MakeSelection(proxies, proxy, parent);
  }
  return nullptr;
}
