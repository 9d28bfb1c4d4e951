#pragma once

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

class vtkDataObject;
class vtkImageData;
class vtkMultiProcessController;

/// An image whose pieces are blocks on this and other processes.
namespace vtkShapeImagePieces
{

/// Returns the images of this process that have points. name: denotes the input in messages. Throws
/// shape::InvalidInput if a block is not an image.
std::vector<vtkImageData*> Find(vtkDataObject* input, const std::string& name);

/// A piece, whose samples are its points or the centres of its cells.
struct Piece
{
  vtkImageData* Image;
  bool IsAtCells;
};

/// Returns the range of the indices of the samples: first and last along i, j and k. Throws
/// shape::InvalidInput if they are at the cells of a flat image.
std::array<int, 6> FindExtent(const Piece& piece);

/// The grid of the samples of all pieces of all processes.
struct Grid
{
  Eigen::RowVector3d Origin; ///< of the index (0, 0, 0), which may lie outside the extent
  Eigen::Matrix3d Axes;      ///< the steps along i, j and k, as columns
  std::array<int, 6> Extent; ///< the smallest that contains those of the pieces
};

/**
 * Returns the grid, the same on every process. Every process must call this.
 *
 * Throws shape::InvalidInput if there is no piece on any process, if the pieces differ in origin,
 * spacing, direction or in where their samples are, and under the condition of FindExtent.
 */
Grid FindGrid(
  const std::vector<Piece>& pieces, const std::string& name, vtkMultiProcessController* controller);

} // namespace vtkShapeImagePieces
