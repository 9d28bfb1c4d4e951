#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

/// The data sets in a data object, composite or not, and outputs that have the like of them.
namespace vtkShapeComposite
{

/// The data set itself, or the blocks of a composite one that are there.
std::vector<vtkDataSet*> Of(vtkDataObject* data);

/// Whether an output like an input keeps its points.
enum class Points
{
  Kept,
  Moved ///< anywhere: image data and rectilinear grids become structured grids
};

/// The class of a data object like `input`; composites that are no trees become multiblocks.
std::string FindOutputType(vtkDataObject* input, Points points);

/**
 * Makes `output` the data set `input` with its points at `points` and its attributes passed on;
 * vtkShapeMeasures removes those that no longer hold. Image data and rectilinear grids become
 * structured grids: see vtkShapeAlgorithm.
 */
void Move(vtkDataSet* input, const Eigen::MatrixXd& points, vtkDataSet* output);

/**
 * Makes `output`, a FindOutputType(input, points), like `input`, and calls `fill` with each data
 * set in `input` and the empty one for it in `output`. Throws shape::InvalidInput
 * if a block is no data set.
 */
void ForEach(vtkDataObject* input, vtkDataObject* output, Points points,
  const std::function<void(vtkDataSet* input, vtkDataSet* output)>& fill);

/// Values of points (n x d), and the name of their array.
struct PointField
{
  std::string Name;
  Eigen::MatrixXd Values;
  bool AreIds = false; ///< whole numbers, for an array of vtkIdType; n x 1
};

/// Makes `output` like `input` with these fields of the points of its blocks, one after the other.
void AddPointFields(
  vtkDataObject* input, vtkDataObject* output, const std::vector<PointField>& fields);

} // namespace vtkShapeComposite
