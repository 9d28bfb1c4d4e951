/**
 * @class   vtkShapeCollection
 * @brief   map many surfaces onto one template, and compare them
 *
 * Inputs
 * - Shapes: surfaces as the blocks of composite data, for instance of Group Datasets. Each block of
 *   the top level is a shape; blocks inside it and pieces of several processes are joined. With
 *   Correspondence SamePoints, all shapes have the same points and triangles in the same order.
 *   With Maps, each shape has the map onto Template: `TargetPosition`, and its companions
 *   `TargetCell` and `TargetBarycentric` if they are present. With Computed, each shape is a
 *   connected, consistently oriented surface; its points and triangles are its own. Another one is
 *   left out, with a warning that names it. So are blocks without points.
 * - Template: required with Maps. An oriented 2-manifold, open or closed, to which the shapes are
 *   compared. By default, it is the shape with the smallest mean distance from the others.
 * - Landmarks (optional): with Computed, points whose partners are known. Block k has those of
 *   shape k, and the block after those of all shapes has those of the Template. They are moved to
 *   the nearest points. Those with the same number correspond: the point array `Number`, or their
 *   order, from 1. A pair of shapes with less than three common numbers is mapped without them.
 *
 * The number of a shape is that of its block. Outputs have no block for one that is left out.
 *
 * Output 0, Shapes: a multiblock data set with the shapes and their names. Point arrays:
 * - `TargetPosition`: the position on the template.
 * - `TargetCell`, `TargetBarycentric`, with Maps and Computed: see vtkShapePreciseMap.
 *
 * Output 1, Template: the template with the point arrays
 * - `AreaDeviation`, `ConformalDeviation`: the standard deviation, over the shapes, of
 *   `AreaDifference` and `ConformalDifference` of vtkShapeMapDifference.
 * - `AreaVariationFunctions`, `ConformalVariationFunctions`: functions that the operators change
 *   most differently (10 components, the most variable one first).
 * - `AreaModes`, `ConformalModes`: the change of `AreaDifference` and `ConformalDifference` for one
 *   standard deviation of each coordinate of the embedding (one component each).
 * - `PositionDeviation`, with Measure Procrustes: the standard deviation of the position.
 *
 * Output 2, Distances: a table with the distance of each shape (row) from each other one (column).
 *
 * Output 3, Table: a row for each shape. `Shape` is its number, and `Name` that of the block.
 * `Dissimilarity` is the mean distance from the others, and `Rank` the rank by it: 0 is the most
 * dissimilar one. `Leaf` is its rank among the leaves of the dendrogram. `Disagreement`, with
 * Computed, is shape::ConsistentMaps::Disagreements. The coordinates are Embedding0, Embedding1,
 * ...
 *
 * Output 4, Operators: a table with the operators in the eigenbasis of the template: a row for each
 * shape and eigenfunction, and the columns Shape, Area0, Area1, ..., Conformal0, ... The rows of
 * one shape are a table for vtkShapeFromOperators.
 *
 * Output 5, Facts
 * - Collection.Shapes: number of shapes.
 * - .LeftOut: number of blocks that were left out.
 * - .Template: number of the shape that is the template, -1 for the input.
 * - .Outlier: number of the shape of rank 0.
 * - .LargestDistance: of two shapes.
 * - .EmbeddingShares: for each coordinate, its part of the squared distances.
 * - .AreaVariances, .ConformalVariances: of the variation functions.
 * With Computed and LimitShape, also
 * - .Pairs: number of pairs that were matched.
 * - .ExchangedPairs: number of pairs whose best map was exchanged.
 * - .DroppedPairs: number of pairs that were left out, because they contradict the others.
 * - .CycleError, .PairwiseCycleError, .Triples: see shape::ConsistentMaps.
 *
 * Output 6, Resampled: a multiblock data set. Each block is a shape with the points and cells of
 * the template: the points are at their positions on the shape. Point arrays of the shape are
 * interpolated. `TargetPosition` is the position on the template. With SamePoints, the blocks are
 * the shapes themselves.
 *
 * On several processes, all outputs are on the first one; the pairs and maps of Computed are
 * shared out.
 *
 * The mathematics: shape::CompareCollection and shape::ComputeConsistentMaps.
 */
#ifndef vtkShapeCollection_h
#define vtkShapeCollection_h

#include "vtkShapeAlgorithm.h"

#include "Correspondence/Consistent/ConsistentMaps.h" // for the options
#include "Correspondence/Evaluate/Collection.h"       // for the options

namespace vtkShapeBlocks
{
struct Block;
}

class VTKSHAPEFILTERS_EXPORT vtkShapeCollection : public vtkShapeAlgorithm
{
public:
  static vtkShapeCollection* New();
  vtkTypeMacro(vtkShapeCollection, vtkShapeAlgorithm);

  /// How the points of the shapes correspond to those of the template.
  enum class CorrespondenceType
  {
    SamePoints,
    Maps,
    Computed
  };

  ///@{
  /// The properties. Effects and ranges: vtkShapeCollection.xml. Enumerations and defaults:
  /// shape::CollectionOptions and shape::ConsistentMapsOptions.
  vtkShapeEnumOptionAs(Correspondence, Correspondence, CorrespondenceType,
    CorrespondenceType::SamePoints, CorrespondenceType::Computed);
  vtkShapeEnumOptionOf(MapOptions, Method, shape::ConsistentMapsOptions::MethodType,
    shape::ConsistentMapsOptions::MethodType::FunctionalMap,
    shape::ConsistentMapsOptions::MethodType::ReversibleHarmonic);
  vtkShapeEnumOptionOf(MapOptions, Consistency, shape::ConsistentMapsOptions::ConsistencyType,
    shape::ConsistentMapsOptions::ConsistencyType::None,
    shape::ConsistentMapsOptions::ConsistencyType::LimitShape);
  vtkShapeOptionOf(MapOptions, Neighbours, int);
  vtkShapeOptionOf(MapOptions, Candidates, int);
  vtkShapeOptionAs(MapOptions.Eigenpairs, NumberOfEigenpairs, int);
  vtkShapeOptionOf(MapOptions, CoarsePoints, int);
  vtkShapeEnumOption(Measure, shape::CollectionOptions::MeasureType,
    shape::CollectionOptions::MeasureType::Area, shape::CollectionOptions::MeasureType::Procrustes);
  vtkShapeOption(BasisSize, int);
  vtkShapeOption(EmbeddingDimension, int);
  vtkShapeOption(Scale, bool);
  ///@}

protected:
  vtkShapeCollection();
  ~vtkShapeCollection() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeCollection(const vtkShapeCollection&) = delete;
  void operator=(const vtkShapeCollection&) = delete;

  /// The landmarks of each shape, and of the template if it is given; none if there are none.
  /// count: number of blocks of Shapes.
  std::vector<shape::NumberedPoints> ReadLandmarks(const std::vector<shape::Surface>& surfaces,
    const std::vector<vtkShapeBlocks::Block>& blocks, int count, const shape::Surface* base);
  void WriteShapes(const std::vector<shape::CollectionShape>& shapes,
    const std::vector<vtkShapeBlocks::Block>& blocks,
    const std::vector<shape::SurfacePoints>& inverses, vtkPolyData* templateData,
    const shape::Mesh& base);
  void WriteTables(const shape::CollectionResult& result,
    const std::vector<vtkShapeBlocks::Block>& blocks, const Eigen::VectorXd& disagreements);
  void WriteFacts(const shape::ConsistentMaps& maps, vtkPolyData* output);

  CorrespondenceType Correspondence = CorrespondenceType::SamePoints;
  shape::CollectionOptions Options;
  shape::ConsistentMapsOptions MapOptions;
};

#endif
