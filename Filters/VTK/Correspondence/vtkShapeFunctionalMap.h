#pragma once

#include "Correspondence/Functional/FunctionalGuide.h"
#include "Correspondence/Functional/FunctionalMatrix.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;
class vtkPolyData;
class vtkTable;

/// Functional maps as tables, and the arrays that guide them.
namespace vtkShapeFunctionalMap
{

/// Returns the columns of a table as a matrix; all components of a column, in order. Every process
/// gets the matrix of the first one (a collective call). Throws shape::InvalidInput if the input is
/// no table, or if a column holds no numbers.
Eigen::MatrixXd ReadMatrix(vtkDataObject* table, vtkMultiProcessController* controller);

/// Writes a row for each eigenfunction of B and a column, named 0, 1 and so on, for each one of A.
/// Field data: EigenvaluesOfA, EigenvaluesOfB, ScaleOfA, ScaleOfB, which vtkShapeCorrespondence
/// documents.
void WriteMatrix(const shape::FunctionalMatrix& map, vtkTable* table);

/// Point arrays of both surfaces, side by side.
struct Descriptors
{
  Eigen::MatrixXd OfA, OfB; ///< equally many columns
};

/// Appends the columns of regions.
void Append(const shape::RegionIndicators& regions, Descriptors& descriptors);

/// Reads a point array of any number of components (n x components). Throws shape::InvalidInput if
/// it is missing, or holds values that are not finite.
Eigen::MatrixXd ReadArray(vtkPolyData* surface, const std::string& array, const std::string& name);

/// Reads point arrays that both surfaces have with equally many components. Names that are empty or
/// None are left out. Throws shape::InvalidInput if an array is missing, or holds values that are
/// not finite.
Descriptors ReadDescriptors(vtkPolyData* a, vtkPolyData* b, const std::vector<std::string>& arrays);

/// Reads an array of integers of the cells or, if there is none, of the points. cellOf: the cell of
/// each triangle. Throws shape::InvalidInput if there is no such array.
shape::SurfaceRegions ReadRegions(vtkPolyData* surface, const std::vector<int>& cellOf,
  const std::string& array, const std::string& name);

} // namespace vtkShapeFunctionalMap
