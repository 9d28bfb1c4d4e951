#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <string>
#include <vector>

class vtkPolyData;

/// Texture coordinates that vtkShapeTransferFields has transferred.
namespace vtkShapeSeams
{

/**
 * Copies points of a surface so that no polygon interpolates texture coordinates across a seam
 * (shape::SplitAtSeams). The copies follow the other points, and have their arrays. Returns the
 * points that were copied.
 *
 * receiver: has the transferred coordinates as the point array `array`. giver: its positions are
 * those to which `positions` (a row for each point of the receiver) refer. texture: the giver's
 * coordinates (n x 2). Throws Aborted.
 */
std::vector<int> Split(vtkPolyData* receiver, const std::string& array, const shape::Surface& giver,
  const Eigen::MatrixXd& texture, const Eigen::MatrixXd& positions,
  const shape::Progress& progress = {});

} // namespace vtkShapeSeams
