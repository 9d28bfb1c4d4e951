#include "pqShapeRows.h"

#include "vtkPVXMLElement.h"
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
