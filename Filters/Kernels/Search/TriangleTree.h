#pragma once

#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The point of a set of triangles that is nearest to a given point.
struct NearestTriangle : SurfacePoint
{
  double SquaredDistance = 0.0;
};

/// Triangles in the order of a tree, in blocks of 16, and balls around them, in single precision.
/// Coordinate k of entry i of block b is stored at index (b * Dimension + k) * 16 + i.
struct TriangleBlocks
{
  static constexpr int Size = 16;

  /// Balls, each around a block or around 16 balls of the previous level. The last level has at
  /// most 16 balls.
  struct Level
  {
    std::vector<float> Centres;
    std::vector<float> Radii; ///< enlarged for rounding; negative in unused entries
  };

  int Dimension = 0;
  std::vector<float> Corners, FirstEdges, SecondEdges; ///< both edges start at the corner
  std::vector<float> Products; ///< edge products: 3 values per entry, not Dimension
  std::vector<Level> Levels;
  float Rounding = 0.0F; ///< the largest error of a distance
};

/**
 * Finds the nearest points of triangles in up to 64 dimensions. The tree consists of balls around
 * triangles that are close to each other. In many dimensions, balls fit an oblique surface better
 * than boxes. Sixteen balls or triangles are compared at once in single precision (Highway).
 * Candidates for the nearest triangle are compared in double precision. If points move a little,
 * for example during an iteration, the tree is kept and only its balls are updated.
 */
class TriangleTree
{
public:
  /// triangles: m x 3, m >= 1; they must outlive the tree. points: n x d, d <= 64, the initial
  /// positions.
  TriangleTree(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points);

  /// Sets the positions of the points (n x d). Find stays exact however far they move, but becomes
  /// slower.
  void Move(const Eigen::MatrixXd& points);

  /// Returns the point of all triangles that is nearest to `point` (d coordinates). guess: a
  /// triangle that is likely to be close, which speeds up the search. It is preferred among
  /// triangles at equal distance.
  NearestTriangle Find(const Eigen::RowVectorXd& point, int guess) const;

private:
  void Split(int first, int count, const Eigen::MatrixXd& centres);
  void MoveBlocks();
  void MoveBalls();
  void Test(const double* point, int triangle, NearestTriangle& best) const;

  const Eigen::MatrixXi& Triangles;
  int Dimension; ///< d, padded with zeros to a multiple of 4
  std::vector<int> Order;
  std::vector<double> Coordinates; ///< n x Dimension
  Eigen::MatrixXd Products;        ///< m x 3: products of the edges at the first corner
  TriangleBlocks Blocks;
};

} // namespace shape
