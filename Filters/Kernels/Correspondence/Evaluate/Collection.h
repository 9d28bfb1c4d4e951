#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct CollectionOptions
{
  /// What the distances of shapes compare.
  enum class MeasureType
  {
    Area,      ///< areas: the area operators
    Conformal, ///< angles: the conformal operators
    Both,      ///< the squares of both distances are added
    Procrustes ///< positions, after the best rigid motion
  };
  MeasureType Measure = MeasureType::Both;
  /// Number k of eigenfunctions of the template on which the operators act; more than its number of
  /// components, and at most its number of points.
  int BasisSize = 50;
  int EmbeddingDimension = 3; ///< maximum number of coordinates; >= 1
  /// Whether the shapes are scaled to the area of the template, so that size does not count.
  bool Scale = false;
};

/// A shape of a collection, with the map onto the template.
struct CollectionShape
{
  Surface Shape;
  /// The images of the shape's points on the template. If there are none, the shape has the points
  /// and triangles of the template, in the same order.
  SurfacePoints Images;
  /// With Images and Procrustes: the positions on the shape of the template's points, one row each
  /// (InvertMap).
  Eigen::MatrixXd OnShape;
};

/// The differences of one kind over the collection.
struct CollectionVariation
{
  /// For each shape, the operator (k x k) in the eigenbasis of the template: DifferenceOperator.
  std::vector<Eigen::MatrixXd> Operators;
  /// n values: the standard deviation, over the shapes, of the factor at the point:
  /// DifferenceOperator::Field.
  Eigen::VectorXd Deviation;
  /// n rows, one column for each of Variances. Functions of norm 1 in the product of the template:
  /// those that the operators change most differently.
  Eigen::MatrixXd Functions;
  /// Descending: the mean, over the shapes, of |(D - mean D) f|^2 for each of these functions.
  Eigen::VectorXd Variances;
  /// n x d: the change of the factor at the point for one standard deviation of each coordinate of
  /// CollectionResult::Embedding, by linear regression. 0 if the shapes are alike.
  Eigen::MatrixXd Modes;
};

struct CollectionResult
{
  CollectionVariation Area, Conformal;
  Eigen::MatrixXd Distances; ///< N x N
  /// N x d: classical MDS of Distances, about mean 0. The coordinate of the greatest magnitude in
  /// each column is positive. d is the smaller one of EmbeddingDimension and N.
  Eigen::MatrixXd Embedding;
  Eigen::VectorXd Shares; ///< d values: the part of the squared distances; 0 if shapes are alike
  Eigen::VectorXd Dissimilarities; ///< N values: the mean distance to the other shapes
  std::vector<int> Order;          ///< the shapes, the most dissimilar one first
  /// The shapes in the order of the leaves of their dendrogram: similar ones are neighbours.
  std::vector<int> Leaves;
  /// n values, with Procrustes: the standard deviation of the position about the mean shape.
  Eigen::VectorXd PositionDeviation;
};

/// The maximum number of functions of a variation; never more than k.
inline constexpr int VariationFunctions = 10;

/**
 * Compares N shapes by their difference operators from one template (Rustamov et al., "Map-based
 * exploration of intrinsic shape differences and variability", 2013, section 6).
 *
 * The operators are those of MapDifference, with the products of the template's eigenfunctions
 * integrated over the triangles of each shape. In a basis that is orthonormal on the template, each
 * is a symmetric matrix. The distance of two shapes is the Frobenius norm of the difference of
 * their matrices, divided by the square root of their size: 0 if a map between them keeps areas
 * (Area) or angles (Conformal), whatever the pose. The coordinates of the embedding are then
 * the principal components of the matrices, and Modes are their modes. With Procrustes, the
 * distance is the root mean square distance of corresponding points after the best rigid motion,
 * weighted by the template's areas. The dendrogram is that of average linkage (Sokal and Michener,
 * "A statistical method for evaluating systematic relationships", 1958).
 *
 * base: the template, a 2-manifold, open or closed. Throws InvalidInput if there is no shape, if a
 * shape without Images has other triangles than the template, if positions are not finite, if
 * Procrustes is asked of a shape with Images and without OnShape, or if an option is out of range;
 * SolveFailure; Aborted.
 */
CollectionResult CompareCollection(const Surface& base, const std::vector<CollectionShape>& shapes,
  const CollectionOptions& options = {}, const Progress& progress = {});

/// Returns the shape with the smallest mean distance from the others, by operators relative to the
/// first shape. All shapes have the same points and triangles. Throws as CompareCollection.
int FindNearestToAll(const std::vector<CollectionShape>& shapes,
  const CollectionOptions& options = {}, const Progress& progress = {});

} // namespace shape
