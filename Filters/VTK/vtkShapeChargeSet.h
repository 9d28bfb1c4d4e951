#pragma once

#include "Core/Mesh.h"
#include "Core/Progress.h"
#include "Volume/ApplyVolumeMap.h"

#include "vtkType.h"

#include <array>
#include <functional>
#include <string>

class vtkDataObject;
class vtkPolyData;

/**
 * Charge sets as data: points with `Charge` (double, 3), field data `Affine` (3 tuples of 4), and
 * as cells the surface that bounds the domain, at whose points there is no charge.
 */
namespace vtkShapeChargeSet
{

struct Contents
{
  shape::ChargeSet Map;
  shape::Mesh Surface;
  /// How far outside the surface the map still holds: half the distance of the charges.
  double Farthest;
};

/// How far that is: offsetDistance is the charges', divided by the longest side of the surface.
double Farthest(double offsetDistance, const shape::Mesh& surface);

/// Throws shape::InvalidInput where `data` is no charge set; `name` is what the message calls it.
/// The charges' distance is the field data HarmonicVolumeMap.OffsetDistance, or else measured.
Contents Read(vtkPolyData* data, const std::string& name);

/// Makes `output` the charge set; charges of zero are left out.
void Write(const shape::ChargeSet& map, const shape::Mesh& surface, vtkPolyData* output);

/**
 * Makes `moved` the data `domain` with every data set's points where `place` puts them, with
 * `SourcePosition` and `OutsideDomain` (0, 1 or 2). Returns how many points have each value of it,
 * but for those that are another process's.
 */
std::array<vtkIdType, 3> Move(vtkDataObject* domain, vtkDataObject* moved,
  const std::function<shape::MovedPoints(
    const Eigen::MatrixXd& points, const shape::Progress& progress)>& place,
  const shape::Progress& progress);

} // namespace vtkShapeChargeSet
