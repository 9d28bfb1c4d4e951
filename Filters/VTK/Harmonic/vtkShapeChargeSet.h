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
 * Conversion of charge sets to VTK data and back. The data have the point array
 * `Charge` (double, 3 components) and the field data array `Affine` (3 tuples of 4 components). The
 * cells are the surface that bounds the domain; the points of this surface have charge 0.
 *
 * If the map has several layers, there is also `RegionId` (int). At a charge, it is the region to
 * whose map the charge belongs. At the points and cells of a surface, it is the region that the
 * surface encloses (-1: a void). `Affine` then has one tuple of 12 components for each region: the
 * rows of its A and b. The field data `Skin` have one number for each region (PiecewiseCharges).
 *
 * If the map is repaired, the field data have its repair (MapRepair): `RepairPoints` and
 * `RepairTargetPosition` (double, 3), `RepairShare` (double), and `RepairTetrahedra` (int, 4).
 */
namespace vtkShapeChargeSet
{

/// Reads a charge set. The distance of the charges from the boundary is the field data
/// HarmonicVolumeMap.OffsetDistance or, if there is none, it is measured. name: denotes the data in
/// errors. Throws shape::InvalidInput if `data` is not a charge set.
shape::PiecewiseCharges Read(vtkPolyData* data, const std::string& name);

/// Copies the charge set of the first process to every process.
void Share(vtkMultiProcessController* controller, shape::PiecewiseCharges& charges);

/// Writes the charge set to `output`. Charges that are zero are omitted.
void Write(const shape::PiecewiseCharges& charges, vtkPolyData* output);

/**
 * Moves the points of `domain`, adds the point arrays `SourcePosition` and `OutsideDomain` (0, 1 or
 * 2), and writes the result to `moved`. position: computes the new positions of the points of one
 * data set. Returns the points with OutsideDomain 1, and those with 2, at their old positions;
 * without ghost points, which belong to other processes.
 */
std::array<std::vector<Eigen::RowVector3d>, 2> Move(vtkDataObject* domain, vtkDataObject* moved,
  const std::function<shape::MovedPoints(
    const Eigen::MatrixXd& points, const shape::Progress& progress)>& position,
  const shape::Progress& progress);

} // namespace vtkShapeChargeSet
