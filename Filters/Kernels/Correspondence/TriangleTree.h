#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Where in which triangle the nearest place is.
struct NearestTriangle
{
  int Triangle = -1;
  Eigen::RowVector3d Barycentric; ///< exactly 0 opposite an edge that it lies on
  double SquaredDistance = 0.0;
};

/**
 * Finds the nearest places of triangles between points of any dimension: a tree of balls around
 * triangles that are near each other, which fit a surface askew in many dimensions better than
 * boxes do. Where points are moved a little, as an iteration does, the tree stays and its balls
 * follow.
 */
class TriangleTree
{
public:
  /// triangles: m x 3, at least one; points: n x d, d <= 64, where the tree is made.
  TriangleTree(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points);

  /// points: n x d. The result of Find is as exact however far they move, but takes longer.
  void Move(const Eigen::MatrixXd& points);

  /// The nearest place to a point (d), over all triangles. guess: a triangle that is likely near,
  /// which makes it quicker; of places equally near, the guess's is taken.
  NearestTriangle Find(const Eigen::RowVectorXd& point, int guess) const;

private:
  struct Node
  {
    int First = 0, Count = 0; ///< of its triangles in the order of the tree
    int Right = -1;           ///< the second child; the first is the next node; -1: a leaf
  };

  void Split(int first, int count, const Eigen::MatrixXd& centres);
  void Test(const double* point, int triangle, NearestTriangle& best) const;
  double Gap(const double* point, int node) const;

  const Eigen::MatrixXi& Triangles;
  int Dimension; ///< d, raised to a multiple of 4 by zeros
  std::vector<Node> Nodes;
  std::vector<int> Order;
  std::vector<double> Coordinates; ///< n x Dimension
  std::vector<double> Centres;     ///< of the nodes' balls, x Dimension
  std::vector<double> Radii;
  Eigen::MatrixXd Products; ///< m x 3: of each triangle's edges from its first corner
};

} // namespace shape
