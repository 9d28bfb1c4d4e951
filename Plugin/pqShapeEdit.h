#pragma once

#include "vtkWeakPointer.h"

#include <QString>

#include <string>
#include <vector>

class vtkSMProperty;
class vtkSMProxy;

/**
 * A change of filter properties. Its effect is shown while the user makes it, and one undo step
 * reverts it.
 *
 * If the filter has the property `Dragging`, it is 1 during the change, so that the filter prefers
 * speed, and 0 again at the end. During the change, nothing is added to the undo stack. At the end,
 * the undo stack gets one step, from the first values to the last.
 */
class pqShapeEdit
{
public:
  /// Any property may be null, because a filter need not have all of them.
  pqShapeEdit(
    vtkSMProxy* filter, const std::vector<vtkSMProperty*>& properties, vtkSMProperty* dragging);

  bool IsActive() const { return this->Active; }
  void Begin();
  void Show();
  void Keep();     ///< remembers the current values for TakeBack
  void TakeBack(); ///< restores the values of the last Keep or, without one, the first values
  void Finish(const QString& label);
  void Cancel();

private:
  struct Value ///< of one property, which has numbers or strings
  {
    std::vector<double> Numbers;
    std::vector<std::string> Strings;
    bool operator==(const Value& other) const
    {
      return this->Numbers == other.Numbers && this->Strings == other.Strings;
    }
  };
  using Values = std::vector<Value>;
  Values Get() const;
  void Set(const Values& values);
  void SetDragging(bool dragging);

  vtkWeakPointer<vtkSMProxy> Filter;
  std::vector<vtkSMProperty*> Properties;
  vtkSMProperty* Dragging;
  Values First, Kept;
  bool Active = false;
};
