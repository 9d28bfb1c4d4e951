#pragma once

#include "Harmonic/PiecewiseVolumeMap.h"

#include <vector>

class vtkDataObject;
class vtkTable;

/// Facts about a harmonic volume map.
namespace vtkShapeVolumeMapFacts
{

/// The prefix of the names of the facts.
inline constexpr const char* Prefix = "HarmonicVolumeMap.";

/// Writes a row for each level of each region's map, with the columns that
/// vtkShapeHarmonicVolumeMap documents.
void WriteLevels(const std::vector<shape::HarmonicVolumeMapResult>& regions, vtkTable* output);

/// Adds field data: the errors, the choices of the method, and the reason why it stopped. With
/// `boundaries`, adds an entry for each region: the residual at the surface around it.
void AddFacts(const shape::PiecewiseVolumeMapResult& result,
  shape::HarmonicVolumeMapOptions::MethodType method, bool boundaries, vtkDataObject* output);

} // namespace vtkShapeVolumeMapFacts
