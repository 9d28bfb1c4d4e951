#include "pqShapeResult.h"

#include "pqShapeFacts.h"

#include "vtkPVXMLElement.h"
#include "vtkSMProxy.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFrame>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPalette>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <QVBoxLayout>

#include <cmath>
#include <cstring>

namespace
{

constexpr int TableHeight = 160;

QString ToText(double number)
{
  return number == std::floor(number) && std::abs(number) < 1e15
    ? QLocale(QLocale::English).toString(static_cast<qlonglong>(number))
    : QString::number(number, 'g', 3);
}

/// Returns the value of a fact as it is shown, or an empty text if there is no such fact.
QString GetValue(vtkSMProxy* filter, const QString& name, bool percent = false)
{
  const QString words = pqShapeFacts::GetText(filter, name.toStdString()).c_str();
  if (!words.isEmpty())
  {
    return words;
  }
  QStringList numbers;
  for (const double number : pqShapeFacts::GetNumbers(filter, name.toStdString()))
  {
    numbers << (percent ? QString::number(100.0 * number, 'g', 3) + " %" : ToText(number));
  }
  return numbers.join(", ");
}

QString MakeLine(vtkSMProxy* filter, const QString& text)
{
  static const QRegularExpression braces("\\{(\\w+)(%?)\\}");
  QString line = text;
  QRegularExpressionMatch match;
  while ((match = braces.match(line)).hasMatch())
  {
    const QString value = GetValue(filter, match.captured(1), !match.captured(2).isEmpty());
    if (value.isEmpty())
    {
      return QString();
    }
    line.replace(match.capturedStart(), match.capturedLength(), value);
  }
  return line;
}

bool IsExceeded(vtkSMProxy* filter, vtkPVXMLElement* warning)
{
  const std::vector<double> numbers =
    pqShapeFacts::GetNumbers(filter, warning->GetAttributeOrEmpty("fact"));
  double limit = 0.0;
  return !numbers.empty() &&
    ((warning->GetScalarAttribute("above", &limit) && numbers[0] > limit) ||
      (warning->GetScalarAttribute("below", &limit) && numbers[0] < limit));
}

} // namespace

void pqShapeResult::startup()
{
  QObject::connect(
    &pqActiveObjects::instance(), &pqActiveObjects::sourceChanged, this, &pqShapeResult::Update);
  pqServerManagerModel* model = pqApplicationCore::instance()->getServerManagerModel();
  QObject::connect(model, &pqServerManagerModel::dataUpdated, this, &pqShapeResult::Update);
  QObject::connect(
    model, &pqServerManagerModel::modifiedStateChanged, this, &pqShapeResult::Update);
}

void pqShapeResult::shutdown()
{
  delete this->Frame;
}

bool pqShapeResult::MakeFrame()
{
  auto* panel = pqCoreUtilities::mainWidget()->findChild<QWidget*>("propertiesPanel");
  auto* layout = panel ? qobject_cast<QVBoxLayout*>(panel->layout()) : nullptr;
  auto* rows = panel ? panel->findChild<QWidget*>("scrollArea") : nullptr;
  if (!layout || !rows)
  {
    return false;
  }
  this->Frame = new QFrame(panel);
  this->Frame->setObjectName("ShapeResult");
  this->Frame->setFrameShape(QFrame::StyledPanel);
  auto* box = new QVBoxLayout(this->Frame);
  box->setContentsMargins(4, 4, 4, 4);
  box->setSpacing(2);
  this->Lines = new QLabel(this->Frame);
  this->Lines->setObjectName("Lines");
  this->Warnings = new QLabel(this->Frame);
  this->Warnings->setObjectName("Warnings");
  const bool isDark = panel->palette().color(QPalette::Window).lightness() < 128;
  this->Warnings->setStyleSheet(
    QString("color: %1; font-weight: bold").arg(isDark ? "#ff9f4d" : "#b34700"));
  for (QLabel* label : { this->Lines, this->Warnings })
  {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    box->addWidget(label);
  }
  this->All = new QPushButton(tr("All facts"), this->Frame);
  this->All->setObjectName("All");
  this->All->setCheckable(true);
  box->addWidget(this->All);
  this->Table = new QTableWidget(0, 2, this->Frame);
  this->Table->setObjectName("Facts");
  this->Table->setMaximumHeight(TableHeight);
  this->Table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  this->Table->horizontalHeader()->hide();
  this->Table->horizontalHeader()->setStretchLastSection(true);
  this->Table->verticalHeader()->hide();
  this->Table->hide();
  box->addWidget(this->Table);
  QObject::connect(this->All, &QPushButton::toggled, this->Table, &QWidget::setVisible);
  auto* copy = new QAction(tr("Copy"), this->Table);
  copy->setShortcut(QKeySequence::Copy);
  copy->setShortcutContext(Qt::WidgetShortcut);
  this->Table->addAction(copy);
  this->Table->setContextMenuPolicy(Qt::ActionsContextMenu);
  QObject::connect(copy, &QAction::triggered, this->Table,
    [table = this->Table]
    {
      QStringList lines;
      for (int row = 0; row < table->rowCount(); ++row)
      {
        QStringList cells;
        for (int column = 0; column < table->columnCount(); ++column)
        {
          if (table->item(row, column)->isSelected())
          {
            cells << table->item(row, column)->text();
          }
        }
        if (!cells.isEmpty())
        {
          lines << cells.join('\t');
        }
      }
      QApplication::clipboard()->setText(lines.join('\n'));
    });
  layout->insertWidget(layout->indexOf(rows), this->Frame);
  return true;
}

void pqShapeResult::FillTable(pqPipelineSource* filter)
{
  const std::vector<std::string> names = pqShapeFacts::GetNames(filter->getProxy());
  this->Table->setRowCount(static_cast<int>(names.size()));
  int row = 0;
  for (const std::string& name : names)
  {
    this->Table->setItem(row, 0, new QTableWidgetItem(name.c_str()));
    this->Table->setItem(row, 1, new QTableWidgetItem(GetValue(filter->getProxy(), name.c_str())));
    ++row;
  }
  this->Table->resizeColumnToContents(0);
}

void pqShapeResult::Update()
{
  pqPipelineSource* filter = pqActiveObjects::instance().activeSource();
  vtkPVXMLElement* hints = filter ? filter->getProxy()->GetHints() : nullptr;
  vtkPVXMLElement* result = hints ? hints->FindNestedElementByName("Result") : nullptr;
  const bool there = filter && filter->modifiedState() != pqProxy::UNINITIALIZED &&
    std::strncmp(filter->getProxy()->GetXMLName(), "Shape", 5) == 0 &&
    (result ? !pqShapeFacts::GetNames(filter->getProxy()).empty()
            : !pqShapeFacts::GetText(filter->getProxy(), "Warning").empty());
  if (!there || (!this->Frame && !this->MakeFrame()))
  {
    if (this->Frame)
    {
      this->Frame->hide();
    }
    return;
  }
  QStringList lines, warnings;
  for (unsigned int i = 0; result && i < result->GetNumberOfNestedElements(); ++i)
  {
    vtkPVXMLElement* element = result->GetNestedElement(i);
    const bool isWarning = std::strcmp(element->GetName(), "Warning") == 0;
    if (!isWarning || IsExceeded(filter->getProxy(), element))
    {
      const QString line = MakeLine(filter->getProxy(), element->GetAttributeOrEmpty("text"));
      (isWarning ? warnings : lines) << line;
    }
  }
  // What the filter itself said.
  warnings << GetValue(filter->getProxy(), "Warning");
  warnings.removeAll(QString());
  lines.removeAll(QString());
  this->Lines->setText(lines.join('\n'));
  this->Warnings->setText(warnings.join('\n'));
  this->Warnings->setVisible(!warnings.isEmpty());
  this->FillTable(filter);
  this->Frame->show();
}
