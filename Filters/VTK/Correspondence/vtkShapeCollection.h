/**
 * @class   vtkShapeCollection
 * @brief   compare many surfaces by their shape difference operators
 *
 * Inputs
 * - Shapes: surfaces as the blocks of composite data, for instance of Group Datasets. Each block of
 *   the top level is a shape; blocks inside it and pieces of several processes are joined. With
 *   Correspondence SamePoints, all shapes have the same points and triangles in the same order.
 * With Maps, each shape has the map onto Template: `TargetPosition`, and its companions
 * `TargetCell` and `TargetBarycentric` if they are present.
 * - Template: optional with SamePoints. An oriented 2-manifold, open or closed, to which the shapes
 *   are compared. By default, it is the shape with the smallest mean distance from the others.
 *
 * Output 0: on one process, the template with the point arrays
 * - `AreaDeviation`, `ConformalDeviation`: the standard deviation, over the shapes, of
 *   `AreaDifference` and `ConformalDifference` of vtkShapeMapDifference.
 * - `AreaVariationFunctions`, `ConformalVariationFunctions`: functions that the operators change
 * most differently (10 components, the most variable one first).
 * - `PositionDeviation`, with Measure Procrustes: the standard deviation of the position.
 *
 * Output 1: a table with a row for each shape. `Shape` is its number, and `Name` that of the block.
 * `Dissimilarity` is the mean distance from the others, and `Rank` the rank by it: 0 is the most
 * dissimilar one. The coordinates are Embedding0, Embedding1, ...
 *
 * Output 2: a table with the distance of each shape (row) from each other one (column).
 *
 * Output 3: a table with the operators in the eigenbasis of the template: a row for each shape and
 * eigenfunction, and the columns Shape, Area0, Area1, ..., Conformal0, ... The rows of one shape
 * are a table for vtkShapeFromOperators.
 *
 * Facts
 * - Collection.Shapes: number of shapes.
 * - .Template: number of the shape that is the template, -1 for the input.
 * - .Outlier: number of the shape of rank 0.
 * - .LargestDistance: of two shapes.
 * - .EmbeddingShares: for each coordinate, its part of the squared distances.
 * - .AreaVariances, .ConformalVariances: of the variation functions.
 *
 * The mathematics: shape::CompareCollection.
 */
#ifndef vtkShapeCollection_h
#define vtkShapeCollection_h

#include "vtkShapeAlgorithm.h"

#include "Correspondence/Evaluate/Collection.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeCollection : public vtkShapeAlgorithm
{
public:
  static vtkShapeCollection* New();
  vtkTypeMacro(vtkShapeCollection, vtkShapeAlgorithm);

  /// How the points of the shapes correspond to those of the template.
  enum class CorrespondenceType
  {
    SamePoints,
    Maps
  };

  ///@{
  /// The properties. Effects and ranges: vtkShapeCollection.xml. Enumerations and defaults:
  /// shape::CollectionOptions.
  vtkShapeEnumOptionAs(Correspondence, Correspondence, CorrespondenceType,
    CorrespondenceType::SamePoints, CorrespondenceType::Maps);
  vtkShapeEnumOption(Measure, shape::CollectionOptions::MeasureType,
    shape::CollectionOptions::MeasureType::Area, shape::CollectionOptions::MeasureType::Procrustes);
  vtkShapeOption(BasisSize, int);
  vtkShapeOption(EmbeddingDimension, int);
  ///@}

protected:
  vtkShapeCollection();
  ~vtkShapeCollection() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeCollection(const vtkShapeCollection&) = delete;
  void operator=(const vtkShapeCollection&) = delete;

  void WriteTables(const shape::CollectionResult& result, const std::vector<std::string>& names);

  CorrespondenceType Correspondence = CorrespondenceType::SamePoints;
  shape::CollectionOptions Options;
};

#endif
