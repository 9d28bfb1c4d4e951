#pragma once

#include "vtkWeakPointer.h"

#include <QString>

#include <vector>

class vtkSMProperty;
class vtkSMProxy;

/**
 * A change of properties of a filter that is shown while the user makes it, and that one undo takes
 * back.
 *
 * During the change the property `Dragging` of the filter, if it has one, is 1, so that the filter
 * prefers speed. Nothing is added to the undo stack. At the end `Dragging` is 0 again, and the undo
 * stack gets the change from the first values to the last.
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
  void Keep();     ///< remembers the current values for TakeBack
  void TakeBack(); ///< restores the values of the last Keep, or else the first ones
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
