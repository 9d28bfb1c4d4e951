#pragma once

#include <string>

/// The names of filters, sources, readers and writers in ParaView.
namespace vtkShapeLabel
{

/// Returns the name of a class in ParaView: "Shape Harmonic Volume Map" for
/// vtkShapeHarmonicVolumeMap, "Shape OFF Reader" for vtkShapeOFFReader.
std::string Of(const std::string& className);

} // namespace vtkShapeLabel
