#pragma once

#include "vtkWeakPointer.h"

#include <QString>

#include <vector>

class vtkSMProperty;
class vtkSMProxy;

/**
 * A change of some properties of a filter that is shown while it goes on, and is one step to undo.
 *
 * While it is shown, the filter's property `Dragging`, where it has one, is 1, which asks it for
 * speed, and nothing goes on the undo stack. In the end `Dragging` is 0 again, and the undo stack
 * gets the change from the first values to the last.
 */
class pqShapeEdit
{
public:
  /// Properties may be null: a filter need not have them all.
  pqShapeEdit(
    vtkSMProxy* filter, const std::vector<vtkSMProperty*>& properties, vtkSMProperty* dragging);

  bool IsActive() const { return this->Active; }
  void Begin();
  void Show();
  void Keep();     ///< the values are good: TakeBack returns to them
  void TakeBack(); ///< to the values kept last, or else the first
  void Finish(const QString& label);
  void Cancel();

private:
  using Values = std::vector<std::vector<double>>;
  Values Get() const;
  void Set(const Values& values);
  void SetDragging(bool dragging);

  vtkWeakPointer<vtkSMProxy> Filter;
  std::vector<vtkSMProperty*> Properties;
  vtkSMProperty* Dragging;
  Values First, Kept;
  bool Active = false;
};
