#pragma once

class pqOutputPort;
class pqView;
class vtkPVXMLElement;

/// The colours of an output in a view.
namespace pqShapeColors
{

/// Colours an output that is visible as an element Color says (see pqShapeFirstApply).
void Apply(pqOutputPort* port, vtkPVXMLElement* element, pqView* view);

} // namespace pqShapeColors
