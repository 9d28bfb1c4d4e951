#include "pqShapeInputsWidget.h"

#include "pqShapeNeeded.h"

#include "vtkCommand.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDataTypeDomain.h"
#include "vtkSMDomain.h"
#include "vtkSMDomainIterator.h"
#include "vtkSMInputArrayDomain.h"
#include "vtkSMInputProperty.h"
#include "vtkSMPropertyGroup.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"
#include "vtkSMUncheckedPropertyHelper.h"
#include "vtkSmartPointer.h"

#include "pqActiveObjects.h"
#include "pqApplicationCore.h"
#include "pqCoreUtilities.h"
#include "pqOutputPort.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QVBoxLayout>

namespace
{

pqServerManagerModel* GetModel()
{
  return pqApplicationCore::instance()->getServerManagerModel();
}

QList<QPointer<pqOutputPort>> GetConnections(vtkSMProperty* input)
{
  const vtkSMPropertyHelper helper(input);
  QList<QPointer<pqOutputPort>> ports;
  for (unsigned int i = 0; i < helper.GetNumberOfElements(); ++i)
  {
    auto* source = GetModel()->findItem<pqPipelineSource*>(helper.GetAsProxy(i));
    if (source)
    {
      ports << source->getOutputPort(static_cast<int>(helper.GetOutputPort(i)));
    }
  }
  return ports;
}

bool Suits(vtkSMInputProperty* input, const pqOutputPort* port)
{
  auto* source = vtkSMSourceProxy::SafeDownCast(port->getSource()->getProxy());
  const int number = port->getPortNumber();
  const auto domains = vtkSmartPointer<vtkSMDomainIterator>::Take(input->NewDomainIterator());
  for (domains->Begin(); !domains->IsAtEnd(); domains->Next())
  {
    auto* type = vtkSMDataTypeDomain::SafeDownCast(domains->GetDomain());
    auto* array = vtkSMInputArrayDomain::SafeDownCast(domains->GetDomain());
    if ((type && !type->IsInDomain(source, number)) ||
      (array && !array->GetIsOptional() &&
        !array->IsInDomain(source, static_cast<unsigned int>(number))))
    {
      return false;
    }
  }
  return true;
}

void FindDependents(const pqPipelineSource* source, QList<const pqPipelineSource*>& found)
{
  if (!found.contains(source))
  {
    found << source;
    for (const pqPipelineSource* consumer : source->getAllConsumers())
    {
      FindDependents(consumer, found);
    }
  }
}

QString GetName(const pqOutputPort* port)
{
  pqPipelineSource* source = port->getSource();
  return source->getNumberOfOutputPorts() == 1
    ? source->getSMName()
    : QString("%1: %2").arg(source->getSMName(), port->getPortName());
}

} // namespace

pqShapeInputsWidget::pqShapeInputsWidget(
  vtkSMProxy* filter, vtkSMPropertyGroup* group, QWidget* parent)
  : Superclass(filter, parent)
{
  auto* layout = new QFormLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  for (unsigned int i = 0; i < group->GetNumberOfProperties(); ++i)
  {
    auto* input = vtkSMInputProperty::SafeDownCast(group->GetProperty(i));
    this->AddRow(layout, input, group->GetPropertyName(i));
    pqCoreUtilities::connect(input, vtkCommand::ModifiedEvent, this, SLOT(OnModified()));
  }
  this->Update();
  pqServerManagerModel* model = GetModel();
  // A filter is marked as new after its panel was made.
  QObject::connect(
    model, &pqServerManagerModel::modifiedStateChanged, this, &pqShapeInputsWidget::ChooseNeeded);
  QObject::connect(model, &pqServerManagerModel::sourceAdded, this, &pqShapeInputsWidget::Update);
  QObject::connect(model, &pqServerManagerModel::sourceRemoved, this, &pqShapeInputsWidget::Update);
  QObject::connect(model, &pqServerManagerModel::nameChanged, this, &pqShapeInputsWidget::Update);
  QObject::connect(model, &pqServerManagerModel::dataUpdated, this, &pqShapeInputsWidget::Update);
}

void pqShapeInputsWidget::AddRow(
  QFormLayout* layout, vtkSMInputProperty* property, const QString& name)
{
  auto* box = new QWidget(this);
  box->setObjectName(name);
  box->setToolTip(pqPropertyWidget::getTooltip(property));
  auto* lists = new QVBoxLayout(box);
  lists->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(property->GetXMLLabel(), this);
  label->setToolTip(box->toolTip());
  layout->addRow(label, box);
  this->Rows.push_back({ property, box, GetConnections(property), {}, {} });
}

void pqShapeInputsWidget::apply()
{
  // The pipeline browser moves the filter to its new inputs, and then nothing is selected.
  pqOutputPort* active = pqActiveObjects::instance().activePort();
  {
    const QScopedValueRollback<bool> applying(this->Applying, true);
    for (const Row& row : this->Rows)
    {
      std::vector<vtkSMProxy*> sources;
      std::vector<unsigned int> ports;
      for (const pqOutputPort* port : row.Chosen)
      {
        sources.push_back(port->getSource()->getProxy());
        ports.push_back(static_cast<unsigned int>(port->getPortNumber()));
      }
      if (row.Chosen != GetConnections(row.Property))
      {
        vtkSMPropertyHelper(row.Property)
          .Set(sources.data(), static_cast<unsigned int>(sources.size()), ports.data());
      }
    }
  }
  if (active)
  {
    pqActiveObjects::instance().setSelection({ active }, active);
  }
  this->Superclass::apply();
}

void pqShapeInputsWidget::reset()
{
  for (Row& row : this->Rows)
  {
    row.Chosen = GetConnections(row.Property);
    row.Property->RemoveAllUncheckedProxies();
  }
  this->Update();
  this->Superclass::reset();
}

void pqShapeInputsWidget::OnModified()
{
  if (!this->Applying)
  {
    this->reset();
  }
}

pqShapeInputsWidget::Ports pqShapeInputsWidget::FindSuitable(vtkSMInputProperty* property) const
{
  QList<const pqPipelineSource*> dependents; // they would close a cycle
  auto* filter = GetModel()->findItem<pqPipelineSource*>(this->proxy());
  if (!filter)
  {
    return {};
  }
  FindDependents(filter, dependents);
  Ports ports;
  for (const pqPipelineSource* source :
    GetModel()->findItems<pqPipelineSource*>(filter->getServer()))
  {
    if (source->modifiedState() == pqProxy::UNINITIALIZED || dependents.contains(source))
    {
      continue;
    }
    for (pqOutputPort* port : source->getOutputPorts())
    {
      if (Suits(property, port))
      {
        ports << port;
      }
    }
  }
  return ports;
}

void pqShapeInputsWidget::ChooseNeeded(pqServerManagerModelItem* item)
{
  const auto* filter = qobject_cast<pqProxy*>(item);
  if (filter->getProxy() != this->proxy() || filter->modifiedState() != pqProxy::UNINITIALIZED)
  {
    return;
  }
  Ports taken;
  for (const Row& row : this->Rows)
  {
    taken << row.Chosen;
  }
  for (Row& row : this->Rows)
  {
    if (!pqShapeNeeded::IsNeeded(row.Property) || !row.Chosen.isEmpty())
    {
      continue;
    }
    Ports ports = this->FindSuitable(row.Property);
    for (const QPointer<pqOutputPort>& port : taken)
    {
      ports.removeAll(port);
    }
    if (ports.size() == 1)
    {
      row.Chosen = ports;
      taken << ports;
      this->UpdateRow(row);
      this->ShowUnchecked(row);
    }
  }
}

void pqShapeInputsWidget::Update()
{
  for (Row& row : this->Rows)
  {
    row.Chosen.removeAll(nullptr);
    row.Offered = this->FindSuitable(row.Property);
    for (const QPointer<pqOutputPort>& port : row.Chosen)
    {
      if (!row.Offered.contains(port))
      {
        row.Offered << port; // it suited once, and is what the filter has
      }
    }
    this->UpdateRow(row);
  }
}

void pqShapeInputsWidget::UpdateRow(Row& row)
{
  const int size = row.Property->GetMultipleInput() ? row.Chosen.size() + 1 : 1;
  while (row.Lists.size() > size)
  {
    row.Lists.takeLast()->deleteLater();
  }
  while (row.Lists.size() < size)
  {
    auto* list = new QComboBox(row.Box);
    const int index = row.Lists.size();
    list->setObjectName(QString("List%1").arg(index));
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(10);
    row.Box->layout()->addWidget(list);
    const auto number = static_cast<int>(&row - this->Rows.data());
    QObject::connect(list, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
      [this, number, index](int entry) { this->OnChosen(number, index, entry); });
    row.Lists << list;
  }
  for (int i = 0; i < size; ++i)
  {
    this->FillList(row, i);
  }
}

void pqShapeInputsWidget::FillList(const Row& row, int index) const
{
  QComboBox* list = row.Lists[index];
  QStringList entries;
  entries << (pqShapeNeeded::IsNeeded(row.Property) ? tr("choose ...")
      : index > 0 && index == row.Chosen.size()     ? tr("add ...")
                                                    : tr("none"));
  for (const pqOutputPort* port : row.Offered)
  {
    entries << GetName(port);
  }
  QStringList shown;
  for (int i = 0; i < list->count(); ++i)
  {
    shown << list->itemText(i);
  }
  const QSignalBlocker blocker(list);
  if (entries != shown) // an open list stays as it is
  {
    list->clear();
    list->addItems(entries);
  }
  const int chosen = index < row.Chosen.size() ? row.Offered.indexOf(row.Chosen[index]) : -1;
  list->setCurrentIndex(chosen + 1);
}

void pqShapeInputsWidget::OnChosen(int number, int index, int entry)
{
  Row& row = this->Rows[static_cast<std::size_t>(number)];
  if (index < row.Chosen.size())
  {
    row.Chosen.removeAt(index);
  }
  if (entry > 0)
  {
    row.Chosen.insert(index, row.Offered[entry - 1]);
  }
  this->UpdateRow(row);
  this->ShowUnchecked(row);
  Q_EMIT this->changeAvailable();
}

void pqShapeInputsWidget::ShowUnchecked(const Row& row) const
{
  vtkSMUncheckedPropertyHelper helper(row.Property);
  row.Property->RemoveAllUncheckedProxies();
  for (int i = 0; i < row.Chosen.size(); ++i)
  {
    const pqOutputPort* port = row.Chosen[i];
    helper.Set(static_cast<unsigned int>(i), port->getSource()->getProxy(),
      static_cast<unsigned int>(port->getPortNumber()));
  }
}
