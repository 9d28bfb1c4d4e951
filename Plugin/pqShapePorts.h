#pragma once

#include <string>

class pqOutputPort;
class pqView;
class vtkSMProxy;

/// Outputs in the pipeline, as inputs of filters and in views.
namespace pqShapePorts
{

/// Returns the output that is the first connection of an input, or nullptr.
pqOutputPort* FindInput(vtkSMProxy* filter, const std::string& name);

bool IsVisible(pqOutputPort* port, pqView* view);
void SetVisible(pqOutputPort* port, pqView* view, bool visible);

} // namespace pqShapePorts
