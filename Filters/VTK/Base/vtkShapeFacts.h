#pragma once

#include <set>
#include <string>
#include <vector>

class vtkDataObject;
class vtkTable;

/// The facts of a run: numbers and words about a result, such as counts, errors and the method that
/// was used. Execute writes them to the field data of its outputs (vtkShapeConvert::AddFact).
namespace vtkShapeFacts
{

/// Moves the facts of an output to a table of one row. Facts are the field data arrays whose names
/// begin with `prefix`, such as "HexRemesh.". Each becomes a column of the same name, unless there
/// is one. The tuples of an array become the components of its column.
/// inputs: their arrays are no facts of this run. kept: names of facts, without the prefix, that
/// also stay in the field data, because other filters read them there.
void Move(const std::string& prefix, const std::vector<vtkDataObject*>& inputs,
  const std::set<std::string>& kept, vtkDataObject* output, vtkTable* facts);

/// Adds the facts `Warning`, the warnings in one text, and `SplitPoints` and `RemovedTriangles`
/// unless they are 0.
void AddWarnings(const std::string& prefix, const std::vector<std::string>& warnings,
  int splitPoints, int removedTriangles, vtkDataObject* output);

} // namespace vtkShapeFacts
