#pragma once

#include <QStringList>

class vtkSMProperty;
class vtkSMProxy;

/// The inputs that a filter needs. All inputs but the first have the hint <Optional/>, so that no
/// dialog asks for them; <Optional needed="1"/> marks those that are needed nevertheless.
namespace pqShapeNeeded
{

bool IsNeeded(vtkSMProperty* input);

/// Returns the names of the needed inputs of a filter.
QStringList GetInputs(vtkSMProxy* filter);

} // namespace pqShapeNeeded
