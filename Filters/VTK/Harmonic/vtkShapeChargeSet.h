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
 * Conversion of charge sets to data and back. The data are points with `Charge` (double, 3) and
 * field data `Affine` (3 tuples of 4). Their cells are the surface that bounds the domain, whose
 * points have no charge.
 *
 * If the map has several layers, `RegionId` (int) at a charge is the region to whose map it
 * belongs. At the surfaces' points and cells it is the region that the surface encloses (-1: a
 * void). `Affine` has one tuple of 12 for each region, the rows of its A and b. Field data `Skin`
 * has one number for each region (PiecewiseCharges).
 */
namespace vtkShapeChargeSet
{

/// Reads a charge set. The distance of the charges is the field data
/// HarmonicVolumeMap.OffsetDistance or, without it, measured. Throws shape::InvalidInput if `data`
/// is not a charge set; `name` denotes it in the message.
shape::PiecewiseCharges Read(vtkPolyData* data, const std::string& name);

/// Copies the charge set of the first process to every process.
void Share(vtkMultiProcessController* controller, shape::PiecewiseCharges& charges);

/// Writes the charge set to `output`; charges of zero are left out.
void Write(const shape::PiecewiseCharges& charges, vtkPolyData* output);

/**
 * Writes the moved data of `domain` to `moved`: `position` returns the new positions of the points
 * of every data set. Adds `SourcePosition` and `OutsideDomain` (0, 1 or 2). Returns the number of
 * points with each value of OutsideDomain, without those that belong to other processes.
 */
std::array<vtkIdType, 3> Move(vtkDataObject* domain, vtkDataObject* moved,
  const std::function<shape::MovedPoints(
    const Eigen::MatrixXd& points, const shape::Progress& progress)>& position,
  const shape::Progress& progress);

} // namespace vtkShapeChargeSet
