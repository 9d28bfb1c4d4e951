#pragma once

#include "Base/Progress.h"
#include "Harmonic/ApplyVolumeMap.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <string>

class vtkDataObject;
class vtkMultiProcessController;
class vtkPolyData;

/**
 * Charge sets as data: points with `Charge` (double, 3), field data `Affine` (3 tuples of 4), and
 * as cells the surface that bounds the domain, at whose points there is no charge.
 *
 * Of a map of several layers: `RegionId` (int) at the points says to which region's map a charge
 * belongs, and at the surfaces' points and on their cells, which region the surface encloses (-1: a
 * void); `Affine` has one tuple of 12 for each region, the rows of its A and b; field data `Skin`
 * has one number for each (PiecewiseCharges).
 */
namespace vtkShapeChargeSet
{

/// Throws shape::InvalidInput if `data` is no charge set; `name` is what the message calls it.
/// The charges' distance is the field data HarmonicVolumeMap.OffsetDistance, or else measured.
shape::PiecewiseCharges Read(vtkPolyData* data, const std::string& name);

/// What the first process has, on every process.
void Share(vtkMultiProcessController* controller, shape::PiecewiseCharges& charges);

/// Makes `output` the charge set; charges of zero are left out.
void Write(const shape::PiecewiseCharges& charges, vtkPolyData* output);

/**
 * Makes `moved` the data `domain` with every data set's points where `position` puts them, with
 * `SourcePosition` and `OutsideDomain` (0, 1 or 2). Returns how many points have each value of it,
 * but for those that are another process's.
 */
std::array<vtkIdType, 3> Move(vtkDataObject* domain, vtkDataObject* moved,
  const std::function<shape::MovedPoints(
    const Eigen::MatrixXd& points, const shape::Progress& progress)>& position,
  const shape::Progress& progress);

} // namespace vtkShapeChargeSet
