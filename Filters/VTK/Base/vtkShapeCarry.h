#pragma once

#include "Mesh/Provenance.h"

#include "vtkSmartPointer.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <string>
#include <vector>

class vtkAbstractArray;
class vtkDataArray;
class vtkDataSet;
class vtkDataSetAttributes;

/**
 * Carries data onto derived meshes, by one rule for every filter:
 * - Values (float, double and unsigned char, which is a colour) are interpolated by the weights of
 *   the provenance, colours rounded and clamped. What has no weight does not count, even NaN.
 * - Everything else (integers, ids, strings, bits) comes from the source with the largest weight,
 *   of several the first.
 * - Normals (the active ones, or an array Normals with three real components) are interpolated and
 *   made unit vectors again.
 * - A tuple without a source is 0, or an empty string. If no cell has a source, there are no cell
 *   arrays.
 * - Arrays keep name, type, components with their names, information and attribute role. Global
 *   ids and ghost marks are left out, as both belong to the old mesh.
 * Data of two meshes are merged: arrays of one name, type and number of components become one. If
 * only one mesh has an array, or the other's is different, tuples of the other mesh are 0.
 */
namespace vtkShapeCarry
{

using Weights = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// A mesh that data come from.
struct Source
{
  vtkDataSet* Mesh;
  const shape::Provenance& From;
};

/// Carries the point data and cell data of one mesh or several; of one, the field data, too.
void Carry(const std::vector<Source>& sources, vtkDataSet* derived);

/// One array, by weights (new tuples x old ones, no entry 0). It has no role.
vtkSmartPointer<vtkAbstractArray> CarryArray(vtkAbstractArray* array, const Weights& weights);

/// The weights of tuples that are copies: of each, the old one, less than oldTuples; -1: none.
Weights ToWeights(const Eigen::VectorXi& tuples, vtkIdType oldTuples);

/// Adds Provenance::Points or Provenance::Cells as an array of ids: `OriginalPointId`,
/// `OriginalCellId`.
void AddOriginals(
  const Eigen::VectorXi& originals, const std::string& name, vtkDataSetAttributes* data);

/// The normals among point or cell data, or nullptr.
vtkDataArray* GetNormals(vtkDataSetAttributes* data);

/// Whether an array of `data` belongs to the mesh and is not carried: global ids, ghost marks.
bool BelongsToMesh(vtkAbstractArray* array, vtkDataSetAttributes* data);

/// Whether an array has values that can be averaged (float, double, colours).
bool AreValues(vtkAbstractArray* array);

/// Whether arrays have the same type and number of components; nullptr is like none.
bool AreAlike(vtkAbstractArray* one, vtkAbstractArray* other);

/// The tuples of an array as rows.
Eigen::MatrixXd GetTuples(vtkDataArray* array);

/// Writes rows to an array of values from tuple `first` on; colours are rounded and clamped.
void SetTuples(const Eigen::MatrixXd& values, vtkIdType first, vtkDataArray* array);

} // namespace vtkShapeCarry
