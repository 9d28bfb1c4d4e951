#pragma once

class pqOutputPort;
class pqView;
class vtkPVXMLElement;

/// The colours of an output in a view.
namespace pqShapeColors
{

/// Colours an output that is visible as an element Color says (see pqShapeFirstApply).
void Apply(pqOutputPort* port, vtkPVXMLElement* element, pqView* view);

/// Takes the values of the same array as colours if another output does. ParaView copies the array
/// from the input of a filter, but not this.
void Follow(pqOutputPort* port, pqOutputPort* other, pqView* view);

} // namespace pqShapeColors
