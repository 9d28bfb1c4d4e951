#include "pqShapeLandmarkList.h"

#include <QHeaderView>
#include <QSignalBlocker>

#include <algorithm>
#include <cstddef>

namespace
{

constexpr int VisibleRows = 6;
enum LandmarkColumn
{
  NameColumn,
  PointColumn,
  TargetColumn
};

QString ToText(const std::vector<double>& values, std::size_t index)
{
  QStringList words;
  for (std::size_t k = 3 * index; k < std::min(3 * index + 3, values.size()); ++k)
  {
    words.append(QString::number(values[k]));
  }
  return words.join(' ');
}

/// Replaces a position if the text is three numbers.
void FromText(const QString& text, std::vector<double>& values, std::size_t index)
{
  const QStringList words = text.split(' ', Qt::SkipEmptyParts);
  std::vector<double> numbers;
  for (const QString& word : words)
  {
    bool isNumber = false;
    numbers.push_back(word.toDouble(&isNumber));
    if (!isNumber)
    {
      return;
    }
  }
  if (numbers.size() == 3 && 3 * index + 3 <= values.size())
  {
    std::copy(
      numbers.begin(), numbers.end(), values.begin() + static_cast<std::ptrdiff_t>(3 * index));
  }
}

} // namespace

pqShapeLandmarkList::pqShapeLandmarkList(
  const std::function<void(const Table&)>& edited, QWidget* parent)
  : QTableWidget(parent)
  , Edited(edited)
{
  this->horizontalHeader()->setStretchLastSection(true);
  this->setMinimumHeight((VisibleRows + 1) * this->verticalHeader()->defaultSectionSize());
  QObject::connect(this, &QTableWidget::cellChanged, this,
    [this](int row, int column) { this->OnEdited(row, column); });
}

void pqShapeLandmarkList::Show(const Table& landmarks, bool hasNames, bool hasTarget)
{
  const QSignalBlocker blocker(this);
  this->Shown = landmarks;
  this->setColumnCount(3);
  this->setHorizontalHeaderLabels(
    { tr("Name"), hasTarget ? tr("On A") : tr("Position"), tr("On B") });
  this->setColumnHidden(NameColumn, !hasNames);
  this->setColumnHidden(TargetColumn, !hasTarget);
  const std::size_t count = std::max(landmarks.Points.size(), landmarks.TargetPoints.size()) / 3;
  this->setRowCount(static_cast<int>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto set = [this, i](int column, const QString& text)
    { this->setItem(static_cast<int>(i), column, new QTableWidgetItem(text)); };
    const bool isNamed = i < landmarks.Names.size() && !landmarks.Names[i].empty();
    set(NameColumn, isNamed ? QString::fromStdString(landmarks.Names[i]) : QString::number(i + 1));
    set(PointColumn, ToText(landmarks.Points, i));
    set(TargetColumn, ToText(landmarks.TargetPoints, i));
  }
}

void pqShapeLandmarkList::OnEdited(int row, int column)
{
  const auto i = static_cast<std::size_t>(row);
  const QString text = this->item(row, column)->text().trimmed();
  Table edited = this->Shown;
  if (column == NameColumn)
  {
    edited.Names.resize(std::max(edited.Names.size(), i + 1));
    edited.Names[i] = text == QString::number(row + 1) ? std::string() : text.toStdString();
  }
  else
  {
    FromText(text, column == PointColumn ? edited.Points : edited.TargetPoints, i);
  }
  this->Edited(edited);
}
