#include "pqShapeEdit.h"

#include "vtkSMProperty.h"
#include "vtkSMPropertyHelper.h"
#include "vtkSMProxy.h"
#include "vtkSMStringVectorProperty.h"
#include "vtkSMTrace.h"

#include "pqUndoStack.h"

#include <cstddef>

pqShapeEdit::pqShapeEdit(
  vtkSMProxy* filter, const std::vector<vtkSMProperty*>& properties, vtkSMProperty* dragging)
  : Filter(filter)
  , Dragging(dragging)
{
  for (vtkSMProperty* property : properties)
  {
    if (property)
    {
      this->Properties.push_back(property);
    }
  }
}

void pqShapeEdit::Begin()
{
  this->First = this->Get();
  this->Kept = this->First;
  this->Active = true;
}

void pqShapeEdit::Show()
{
  const pqScopedUndoExclude exclude;
  this->SetDragging(true);
  this->Filter->UpdateVTKObjects();
}

void pqShapeEdit::Keep()
{
  this->Kept = this->Get();
}

void pqShapeEdit::TakeBack()
{
  this->Set(this->Kept);
}

void pqShapeEdit::Finish(const QString& label)
{
  const Values last = this->Get();
  this->Cancel();
  if (!(last == this->First))
  {
    const pqScopedUndoSet undo(label);
    SM_SCOPED_TRACE(PropertiesModified).arg("proxy", this->Filter.Get());
    this->Set(last);
    this->Filter->UpdateVTKObjects();
  }
}

void pqShapeEdit::Cancel()
{
  const pqScopedUndoExclude exclude;
  this->Set(this->First);
  this->SetDragging(false);
  this->Filter->UpdateVTKObjects();
  this->Active = false;
}

pqShapeEdit::Values pqShapeEdit::Get() const
{
  Values values;
  for (vtkSMProperty* property : this->Properties)
  {
    Value value;
    if (auto* strings = vtkSMStringVectorProperty::SafeDownCast(property))
    {
      value.Strings = strings->GetElements();
    }
    else
    {
      value.Numbers = vtkSMPropertyHelper(property).GetDoubleArray();
    }
    values.push_back(value);
  }
  return values;
}

void pqShapeEdit::Set(const Values& values)
{
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    // A repeatable property gets the number of these values.
    if (auto* strings = vtkSMStringVectorProperty::SafeDownCast(this->Properties[i]))
    {
      strings->SetElements(values[i].Strings);
    }
    else
    {
      const std::vector<double>& numbers = values[i].Numbers;
      vtkSMPropertyHelper(this->Properties[i])
        .Set(numbers.data(), static_cast<unsigned int>(numbers.size()));
    }
  }
}

void pqShapeEdit::SetDragging(bool dragging)
{
  if (this->Dragging)
  {
    vtkSMPropertyHelper(this->Dragging).Set(dragging ? 1 : 0);
  }
}
