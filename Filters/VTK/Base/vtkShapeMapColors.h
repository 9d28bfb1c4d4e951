#pragma once

#include <Eigen/Core>

#include <string>

class vtkDataObject;

/// Colours by which the eye sees a map: corresponding points of two shapes have the same colour.
namespace vtkShapeMapColors
{

/// Adds the point array `MapColors` (red, green and blue, unsigned char) to a data set or to each
/// block. The colour of a point is its position in a box.
/// positions: the name of a point array with 3 components, or empty for the points themselves.
/// points: n x 3, they span the box.
void Add(vtkDataObject* output, const std::string& positions, const Eigen::MatrixXd& points);

} // namespace vtkShapeMapColors
