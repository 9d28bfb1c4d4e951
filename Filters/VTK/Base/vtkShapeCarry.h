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
 * Carries data onto derived meshes, by the same rules for every filter:
 * - Values (float, double, and unsigned char for colours) are interpolated by the weights of the
 *   provenance. Colours are rounded and clamped. A source tuple with weight 0 has no influence,
 *   even if it is NaN.
 * - All other data (integers, ids, strings, bits) are copied from the source with the largest
 *   weight. If several sources have this weight, the first is used.
 * - Normals (the active ones, or an array Normals with three real components) are interpolated and
 *   normalised.
 * - A new tuple without a source is 0, or an empty string. If no cell has a source, there are no
 *   cell arrays.
 * - Arrays keep their name, type, components, names of components, information and attribute role.
 *   Global ids and ghost marks are omitted, because both describe the old mesh.
 * The data of several meshes are merged. Arrays with the same name, type and number of components
 * become one array. If a mesh has no such array, the tuples that come from this mesh are 0.
 */
namespace vtkShapeCarry
{

using Weights = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// A mesh from which data are carried.
struct Source
{
  vtkDataSet* Mesh;
  const shape::Provenance& From;
};

/// Carries the point data and cell data of one or several meshes. The field data are carried if
/// there is only one mesh.
void Carry(const std::vector<Source>& sources, vtkDataSet* derived);

/// Returns one carried array, without an attribute role. weights: number of new tuples x number of
/// old tuples, without stored zeros.
vtkSmartPointer<vtkAbstractArray> CarryArray(vtkAbstractArray* array, const Weights& weights);

/// Returns the weights for tuples that are copies. tuples: for each new tuple, the index of the old
/// tuple, less than oldTuples, or -1 for none.
Weights ToWeights(const Eigen::VectorXi& tuples, vtkIdType oldTuples);

/// Adds Provenance::Points or Provenance::Cells as an array of ids with the given name, such as
/// `OriginalPointId` or `OriginalCellId`.
void AddOriginals(
  const Eigen::VectorXi& originals, const std::string& name, vtkDataSetAttributes* data);

/// Replaces the ids of OriginalPointId, an array that AddOriginals made, by their entries in a
/// list. An empty list changes nothing.
void RenumberOriginals(const std::vector<int>& list, vtkDataSetAttributes* data);

/// Returns the array of normals in point or cell data, or nullptr if there is none.
vtkDataArray* GetNormals(vtkDataSetAttributes* data);

/// Returns whether an array of `data` describes the mesh itself and is not carried: global ids and
/// ghost marks.
bool BelongsToMesh(vtkAbstractArray* array, vtkDataSetAttributes* data);

/// Returns whether an array has values that can be averaged (float, double, colours).
bool AreValues(vtkAbstractArray* array);

/// Returns whether two arrays have the same type and number of components. It returns false if one
/// of them is nullptr.
bool AreAlike(vtkAbstractArray* one, vtkAbstractArray* other);

/// Returns the tuples of an array as rows.
Eigen::MatrixXd GetTuples(vtkDataArray* array);

/// Writes the rows of `values` to an array, beginning at tuple `first`. Colours are rounded and
/// clamped.
void SetTuples(const Eigen::MatrixXd& values, vtkIdType first, vtkDataArray* array);

} // namespace vtkShapeCarry
