#pragma once

#include "pqShapeDisplay.h"

#include <Eigen/Geometry>

class pqDataRepresentation;
class pqPipelineSource;
class pqView;
class vtkSMProperty;

/// Where a view draws an input of a filter: representations can be moved, rotated and scaled.
namespace pqShapePlacement
{

/// Returns the source that an input property has, or null.
pqPipelineSource* FindSource(vtkSMProperty* input);

/// Returns the visible representation of an input in a view, or null.
pqDataRepresentation* FindShown(vtkSMProperty* input, pqView* view);

/// Returns the transformation from data coordinates to the view. Without a representation, it is
/// the identity.
Eigen::Affine3d FindTransform(pqDataRepresentation* representation);

/// Transforms a line of sight. Positions on it are transformed, too, but lengths along it change.
pqShapeDisplay::Ray Transform(const Eigen::Affine3d& transform, const pqShapeDisplay::Ray& ray);

} // namespace pqShapePlacement
