#pragma once

#include "Harmonic/PiecewiseVolumeMap.h"

#include <vector>

class vtkDataObject;
class vtkTable;

/// Writes the errors of a harmonic volume map, and the choices of its method, to VTK data.
namespace vtkShapeVolumeMapFacts
{

/// Prefix of the names of the facts.
inline constexpr const char* Prefix = "HarmonicVolumeMap.";

/// Writes a row for each level of each region's map, with the columns that
/// vtkShapeHarmonicVolumeMap documents.
void WriteLevels(const std::vector<shape::HarmonicVolumeMapResult>& regions, vtkTable* output);

/// Adds facts: the errors, the choices of the method, and the reason why it stopped. If
/// `boundaries` is set, also adds facts with an entry for each region: the errors on the
/// surface around the region.
void AddFacts(const shape::PiecewiseVolumeMapResult& result,
  shape::HarmonicVolumeMapOptions::MethodType method, bool boundaries, vtkDataObject* output);

} // namespace vtkShapeVolumeMapFacts
