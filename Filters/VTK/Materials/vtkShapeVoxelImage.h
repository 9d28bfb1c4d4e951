#pragma once

#include "Materials/VoxelImage.h"

#include <Eigen/Core>

#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;

namespace vtkShapeVoxelImage
{

/// An array of the image, whose components are successive channels.
struct Array
{
  std::string Name;
  int FirstChannel;
  int Components;
  bool AreScalars; ///< whether it is the active one
};

struct Result
{
  shape::VoxelImage Image;
  std::vector<Array> Arrays;
};

/**
 * Returns the part of a vtkImageData that surrounds some points, or of the images that are its
 * pieces on this and other processes, with all numeric point arrays. It is the same on every
 * process, and surrounds the points of all of them.
 *
 * points: matrices of points (n x 3) of this process.
 *
 * Throws shape::InvalidInput if a block is not an image, if images have different origins, spacings
 * or directions, if there is no point array, or if a part of the image is missing.
 */
Result Read(vtkDataObject* input, const std::vector<const Eigen::MatrixXd*>& points,
  vtkMultiProcessController* controller);

} // namespace vtkShapeVoxelImage
