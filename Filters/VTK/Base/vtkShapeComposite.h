#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

/// Access to the data sets in a data object, composite or not, and outputs with the same structure.
namespace vtkShapeComposite
{

/// Returns the data set itself, or the non-empty blocks of a composite one.
std::vector<vtkDataSet*> Of(vtkDataObject* data);

/// Whether an output keeps the points of its input.
enum class Points
{
  Kept,
  Moved ///< to any positions: image data and rectilinear grids become structured grids
};

/// Returns the class of an output like `input`. Composites that are not trees become multiblocks.
std::string FindOutputType(vtkDataObject* input, Points points);

/**
 * Copies the data set `input` to `output` with its points at `points`. Attributes are passed on;
 * vtkShapeMeasures removes those that are no longer valid. Image data and rectilinear grids become
 * structured grids: see vtkShapeAlgorithm.
 */
void Move(vtkDataSet* input, const Eigen::MatrixXd& points, vtkDataSet* output);

/**
 * Gives `output`, a FindOutputType(input, points), the structure of `input`, and calls `fill` with
 * each data set in `input` and its empty counterpart in `output`. Throws shape::InvalidInput if a
 * block is not a data set.
 */
void ForEach(vtkDataObject* input, vtkDataObject* output, Points points,
  const std::function<void(vtkDataSet* input, vtkDataSet* output)>& fill);

/// Values at points (n x d), and the name of their array.
struct PointField
{
  std::string Name;
  Eigen::MatrixXd Values;
  bool AreIds = false; ///< integers, for an array of vtkIdType; n x 1
};

/// Copies `input` to `output` and adds these fields, which contain the points of all blocks in
/// order.
void AddPointFields(
  vtkDataObject* input, vtkDataObject* output, const std::vector<PointField>& fields);

} // namespace vtkShapeComposite
