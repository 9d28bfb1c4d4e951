#pragma once

#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Where in which triangle the nearest place is.
struct NearestTriangle : SurfacePoint
{
  double SquaredDistance = 0.0;
};

/// Triangles in the order of a tree, 16 to a block, and balls around them, in single precision: for
/// coordinate k of what is in place i of block b, index (b * Dimension + k) * 16 + i.
struct TriangleBlocks
{
  static constexpr int Size = 16;

  /// Balls around 16 blocks, or around 16 balls of the level before; the last level has at most 16.
  struct Level
  {
    std::vector<float> Centres;
    std::vector<float> Radii; ///< with room for rounding; below any distance where there is no ball
  };

  int Dimension = 0;
  std::vector<float> Corners, FirstEdges, SecondEdges; ///< the sides start at the corner
  std::vector<float> Products;                         ///< of the sides: 3 in place of Dimension
  std::vector<Level> Levels;
  float Rounding = 0.0F; ///< by how much a distance may be wrong
};

/**
 * Finds the nearest places of triangles between points of any dimension: a tree of balls around
 * triangles that are near each other, which fit a surface askew in many dimensions better than
 * boxes do. Sixteen balls, or triangles, are compared at once in single precision (Highway); what
 * may be nearest by that is in double precision. Where points are moved a little, as an iteration
 * does, the tree stays and its balls follow.
 */
class TriangleTree
{
public:
  /// triangles: m x 3, at least one, kept by reference; points: n x d, d <= 64, as they are now.
  TriangleTree(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points);

  /// points: n x d. The result of Find is as exact however far they move, but takes longer.
  void Move(const Eigen::MatrixXd& points);

  /// The nearest place to a point (d), over all triangles. guess: a triangle that is likely near,
  /// which makes it quicker; of places equally near, the guess's is taken.
  NearestTriangle Find(const Eigen::RowVectorXd& point, int guess) const;

private:
  void Split(int first, int count, const Eigen::MatrixXd& centres);
  void MoveBlocks();
  void MoveBalls();
  void Test(const double* point, int triangle, NearestTriangle& best) const;

  const Eigen::MatrixXi& Triangles;
  int Dimension; ///< d, raised to a multiple of 4 by zeros
  std::vector<int> Order;
  std::vector<double> Coordinates; ///< n x Dimension
  Eigen::MatrixXd Products;        ///< m x 3: of each triangle's edges from its first corner
  TriangleBlocks Blocks;
};

} // namespace shape
