#pragma once

#include "Labels/LabelImage.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;

namespace vtkShapeLabelImage
{

/**
 * Returns the labels of a vtkImageData, or of the images that are its pieces on this and other
 * processes, the same on every process.
 *
 * array: the name of an array of one component at points or cells; if it is empty, the active
 * scalars. thresholds: if there are any, the array has grey values (shape::MakeLabels). Otherwise
 * its values are integers. Hidden voxels and ghosts that no piece owns are the outside. name:
 * denotes the input in messages.
 *
 * Throws shape::InvalidInput if a block is not an image, if images have different origins, spacings
 * or directions, if the array is missing, or if a value is not an integer
 * from -2147483647 to 2147483647.
 */
shape::LabelImage Read(vtkDataObject* input, const std::string& array,
  const std::vector<double>& thresholds, vtkMultiProcessController* controller,
  const std::string& name = "the Input");

} // namespace vtkShapeLabelImage
