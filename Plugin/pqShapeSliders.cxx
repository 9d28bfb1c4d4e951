#include "pqShapeSliders.h"

#include "vtkPVArrayInformation.h"
#include "vtkPVDataInformation.h"
#include "vtkPVDataSetAttributesInformation.h"
#include "vtkPVXMLElement.h"
#include "vtkSMDoubleRangeDomain.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMSourceProxy.h"

#include "pqApplicationCore.h"
#include "pqDoubleRangeWidget.h"
#include "pqPipelineSource.h"
#include "pqServerManagerModel.h"

#include <QFormLayout>
#include <QLabel>
#include <QScopedValueRollback>

#include <algorithm>

pqShapeSliders::pqShapeSliders(vtkSMProxy* filter, vtkSMProperty* property, QWidget* parent)
  : Superclass(filter, parent)
  , Rows(new QFormLayout(this))
  , Empty(new QLabel(tr("The input has no modes."), this))
{
  vtkPVXMLElement* hint = property->GetHints()->FindNestedElementByName("Sliders");
  this->Input = hint->GetAttributeOrEmpty("input");
  this->Array = hint->GetAttributeOrEmpty("array");
  if (auto* domain = property->FindDomain<vtkSMDoubleRangeDomain>())
  {
    this->Range[0] = domain->GetMinimum(0);
    this->Range[1] = domain->GetMaximum(0);
  }
  this->Rows->setContentsMargins(0, 0, 0, 0);
  this->Rows->addRow(this->Empty);
  this->addPropertyLink(this, "values", SIGNAL(ValuesChanged()), property);
  this->Update();
  QObject::connect(pqApplicationCore::instance()->getServerManagerModel(),
    &pqServerManagerModel::dataUpdated, this, &pqShapeSliders::Update);
}

int pqShapeSliders::CountArrays() const
{
  const vtkSMPropertyHelper input(this->proxy(), this->Input.c_str(), true);
  auto* source =
    input.GetNumberOfElements() > 0 ? vtkSMSourceProxy::SafeDownCast(input.GetAsProxy()) : nullptr;
  if (!source)
  {
    return 0;
  }
  vtkPVDataSetAttributesInformation* arrays =
    source->GetDataInformation(input.GetOutputPort())->GetPointDataInformation();
  int count = 0;
  while (arrays->GetArrayInformation((this->Array + std::to_string(count)).c_str()))
  {
    ++count;
  }
  return count;
}

void pqShapeSliders::Update()
{
  // More weights than modes have a slider, too: the filter warns of them.
  const int count = this->CountArrays();
  int last = this->Sliders.size();
  while (last > count && this->Sliders[last - 1]->value() == 0.0)
  {
    --last;
  }
  this->Resize(std::max(count, last));
}

void pqShapeSliders::Resize(int count)
{
  while (this->Sliders.size() > count)
  {
    this->Sliders.removeLast();
    this->Rows->removeRow(this->Rows->rowCount() - 1);
  }
  while (this->Sliders.size() < count)
  {
    const QString name = QString("%1%2").arg(this->Array.c_str()).arg(this->Sliders.size());
    auto* slider = new pqDoubleRangeWidget(this);
    slider->setObjectName(name);
    slider->setMinimum(this->Range[0]);
    slider->setMaximum(this->Range[1]);
    slider->setValue(0.0);
    QObject::connect(slider, &pqDoubleRangeWidget::valueChanged, this,
      [this]
      {
        if (!this->Setting)
        {
          Q_EMIT this->ValuesChanged();
        }
      });
    this->Rows->addRow(name, slider);
    this->Sliders << slider;
  }
  this->Empty->setVisible(count == 0);
}

QList<QVariant> pqShapeSliders::GetValues() const
{
  QList<QVariant> values;
  for (const pqDoubleRangeWidget* slider : this->Sliders)
  {
    values << slider->value();
  }
  return values;
}

void pqShapeSliders::SetValues(const QList<QVariant>& values)
{
  const QScopedValueRollback<bool> setting(this->Setting, true);
  this->Resize(std::max(this->CountArrays(), static_cast<int>(values.size())));
  for (int i = 0; i < this->Sliders.size(); ++i)
  {
    this->Sliders[i]->setValue(i < values.size() ? values[i].toDouble() : 0.0);
  }
}
