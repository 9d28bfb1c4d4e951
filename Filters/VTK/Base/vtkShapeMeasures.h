#pragma once

#include <set>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

/**
 * Measures describe the geometry on which they were computed: quality and size of cells, distances,
 * curvatures, distortion of maps, spectra, normals, and the facts that filters write to the field
 * data. They are wrong on any other geometry. Only this file knows their names, and it
 * keeps them off outputs with points of their own; vtkShapeAlgorithm applies it to every filter.
 */
namespace vtkShapeMeasures
{

/// What Verdict computes of hexahedra and ShapeMap writes: ScaledJacobian, Volume, ...
const std::vector<std::string>& NamesOfHexahedra();

/// Adds these cell arrays, computed by vtkMeshQuality, to a data set of hexahedra.
void AddToHexahedra(const std::vector<std::string>& names, vtkDataSet* hexahedra);

/// A filter that has been executed.
struct Filter
{
  std::string Name;                   ///< HexRemesh: the prefix of its facts
  std::set<std::string> Made;         ///< the measures that it computes of its outputs
  std::vector<vtkDataObject*> Inputs; ///< what it was given, as it came and gathered
};

/**
 * Removes the inputs' measures from an output. The data sets of `output` that have points of their
 * own lose each measure that the filter did not make and each fact of another filter. Measures of
 * hexahedra that they lose are computed again, if all their cells are hexahedra. A data set that
 * shares its points with an input has the input's geometry and keeps everything.
 */
void Renew(const Filter& filter, vtkDataObject* output);

} // namespace vtkShapeMeasures
