#pragma once

#include <set>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

/**
 * Measures describe the geometry on which they were computed: quality and size of cells, distances,
 * curvatures, distortion of maps, spectra, normals, and the facts that filters write to the field
 * data. They are wrong on any other geometry. Only this file contains their names. It removes
 * them from outputs whose points differ from the inputs'; vtkShapeAlgorithm applies it to every
 * filter.
 */
namespace vtkShapeMeasures
{

/// Returns the names of the measures of hexahedra that ShapeMap writes and Verdict computes:
/// ScaledJacobian, Volume, ...
const std::vector<std::string>& NamesOfHexahedra();

/// Adds these cell arrays, computed by vtkMeshQuality, to a data set of hexahedra.
void AddToHexahedra(const std::vector<std::string>& names, vtkDataSet* hexahedra);

/// A filter that has been executed.
struct Filter
{
  std::string Name;                   ///< such as HexRemesh: the prefix of the filter's facts
  std::set<std::string> Made;         ///< the measures that it computes of its outputs
  std::vector<vtkDataObject*> Inputs; ///< its inputs, both as connected and as gathered
};

/**
 * Removes the inputs' measures from an output. A data set of `output` that shares its points with
 * an input has the input's geometry and keeps everything. Any other one loses each measure that the
 * filter did not compute and each fact of another filter. If all its cells are hexahedra, the
 * measures of hexahedra that it loses are computed again.
 */
void Renew(const Filter& filter, vtkDataObject* output);

} // namespace vtkShapeMeasures
