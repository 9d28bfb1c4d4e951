#pragma once

#include "Harmonic/PiecewiseVolumeMap.h"

#include <vector>

class vtkDataObject;
class vtkTable;

/// What a harmonic volume map says about itself.
namespace vtkShapeVolumeMapFacts
{

/// What the names of the facts begin with.
inline constexpr const char* Prefix = "HarmonicVolumeMap.";

/// A row for each level of each region's map, with the columns that vtkShapeHarmonicVolumeMap
/// names.
void WriteLevels(const std::vector<shape::HarmonicVolumeMapResult>& regions, vtkTable* output);

/// Field data: errors, what the method did and why it stopped; with `boundaries` an entry for each
/// region: the residual at the surface around it.
void AddFacts(const shape::PiecewiseVolumeMapResult& result,
  shape::HarmonicVolumeMapOptions::MethodType method, bool boundaries, vtkDataObject* output);

} // namespace vtkShapeVolumeMapFacts
