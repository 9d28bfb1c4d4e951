#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

/// Access to the data sets in a data object, which may be composite, and creation of outputs with
/// the same blocks.
namespace vtkShapeComposite
{

/// Returns the data set itself or, if it is composite, its non-empty blocks.
std::vector<vtkDataSet*> Of(vtkDataObject* data);

/// Throws shape::InvalidInput if a block is not a data set.
void RequireDataSets(vtkDataObject* data);

/// Whether an output keeps the points of its input.
enum class Points
{
  Kept,
  Moved ///< to any positions: image data and rectilinear grids become structured grids
};

/// Returns the class name of an output that has the structure of `input`. Composite data that are
/// not trees become multiblock data sets.
std::string FindOutputType(vtkDataObject* input, Points points);

/**
 * Copies the data set `input` to `output`, and moves its points to `points`. Attributes are passed
 * on; vtkShapeMeasures removes the attributes that are no longer valid. Image data and rectilinear
 * grids become structured grids.
 */
void Move(vtkDataSet* input, const Eigen::MatrixXd& points, vtkDataSet* output);

/**
 * Builds the structure of `input` in `output`, whose class is FindOutputType(input, points). Calls
 * `fill` with each data set in `input` and the corresponding empty data set in `output`. Throws
 * shape::InvalidInput if a block is not a data set.
 */
void ForEach(vtkDataObject* input, vtkDataObject* output, Points points,
  const std::function<void(vtkDataSet* input, vtkDataSet* output)>& fill);

/// Makes the first of the arrays `names` that a data set has its active scalars, which the window
/// shows at first. A data set with none of them stays as it is.
void ActivateScalars(vtkDataObject* data, const std::vector<std::string>& names);

/// Values at points and the name of their array.
struct PointField
{
  std::string Name;
  Eigen::MatrixXd Values; ///< n x d
  bool AreIds = false;    ///< whether the array is of vtkIdType; then d = 1
};

/// Copies `input` to `output` and adds the fields. The rows of Values belong to the points of all
/// blocks, in order.
void AddPointFields(
  vtkDataObject* input, vtkDataObject* output, const std::vector<PointField>& fields);

} // namespace vtkShapeComposite
