#pragma once

class pqOutputPort;
class pqPipelineSource;
class pqView;
class vtkPVXMLElement;

/// Where outputs are drawn in a view, and from where they are seen. Representations are translated,
/// never data, and none that was translated before. What an output then covers exactly is hidden.
namespace pqShapeArrangement
{

/// Draws an output to the right of another one that it overlaps. Returns whether it did.
bool DrawBeside(pqOutputPort* port, pqOutputPort* other, pqView* view);

/// Draws a part of a surface off the rest of it, away from the centre of the rest.
void DrawOff(pqOutputPort* port, pqOutputPort* rest, pqView* view);

/// Draws an output where another one is drawn.
void DrawLike(pqOutputPort* port, pqOutputPort* other, pqView* view);

/// Points the camera at the outputs of a filter where it does not show them well. camera: an
/// element Camera (see pqShapeFirstApply), or nullptr.
void Look(pqPipelineSource* filter, vtkPVXMLElement* camera, pqView* view);

} // namespace pqShapeArrangement
