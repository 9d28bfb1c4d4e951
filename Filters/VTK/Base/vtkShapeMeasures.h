#pragma once

#include <set>
#include <string>
#include <vector>

class vtkDataObject;
class vtkPointSet;

/**
 * A measure is an array that describes the geometry on which it was computed. Measures are the
 * quality and size of cells, distances, curvatures, distortion of maps, spectra, normals, and the
 * results that filters write to the field data. They are wrong on any other geometry. Only this
 * file contains the names of measures. It removes them from outputs whose points differ from the
 * points of the inputs; vtkShapeAlgorithm applies it to every filter.
 */
namespace vtkShapeMeasures
{

/// Returns the names of the Verdict measures that Shape Hex Remesh writes: ScaledJacobian, Volume,
/// ...
const std::vector<std::string>& NamesOfHexahedra();

/// Computes these measures with vtkMeshQuality and adds them as cell arrays to a data set of
/// hexahedra. They do not depend on the unit of length: Volume and Jacobian may exceed 1e30.
void AddToHexahedra(const std::vector<std::string>& names, vtkPointSet* hexahedra);

/// An executed filter: its name, its inputs and the measures that it computed.
struct Filter
{
  std::string Name;                   ///< such as HexRemesh: the prefix of the filter's field data
  std::set<std::string> Made;         ///< the measures that it computed for its outputs
  std::vector<vtkDataObject*> Inputs; ///< its inputs, both as connected and as gathered
};

/**
 * Removes the measures of the inputs from an output. A data set of `output` that shares its points
 * with an input keeps all arrays, because it has the same geometry. Other data sets lose each
 * measure that the filter did not compute and each result of another filter in the field data. If
 * all cells are hexahedra, the Verdict measures that were removed are computed again.
 */
void Renew(const Filter& filter, vtkDataObject* output);

} // namespace vtkShapeMeasures
