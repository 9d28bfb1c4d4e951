#pragma once

#include <vector>

class pqOutputPort;
class pqView;
class vtkSMProxy;

/// How an output is drawn in a view. Changes are recorded in a trace.
namespace pqShapeRepresentation
{

/// Returns the representation of an output that is visible in the view, or nullptr.
vtkSMProxy* FindVisible(pqOutputPort* port, pqView* view);

/// Returns the three values of its translation.
std::vector<double> GetPosition(vtkSMProxy* representation);
bool IsMoved(vtkSMProxy* representation);

void Set(vtkSMProxy* proxy, const char* property, const std::vector<double>& values);
void Set(vtkSMProxy* proxy, const char* property, int value);

} // namespace pqShapeRepresentation
