#pragma once

#include "Base/Progress.h"
#include "Geometry/PointGraph.h"
#include "Geometry/TangentFrame.h"
#include "Mesh/VertexFans.h"

#include <Eigen/Core>

#include <array>
#include <utility>
#include <vector>

namespace shape
{

/**
 * The front of an ExponentialMap: see there. Runs over the nodes of a surface's graph, again and
 * again, each time in time proportional to what it covers. Throws Aborted.
 */
class ExponentialFront
{
public:
  /// triangles: m x 3, of nodes; normals: n x 3, unit, of the nodes. upwindAverage: equation 11.
  ExponentialFront(const PointGraph& graph, const Eigen::MatrixXi& triangles,
    const Eigen::MatrixXd& normals, bool upwindAverage);

  /// From a frame in the triangle with these nodes until the next node is beyond the radius.
  void Run(const TangentFrame& seed, const Eigen::RowVector3i& corners,
    const Eigen::RowVector3d& barycentric, double radius, const Progress& progress = {});

  /// A triangle between nodes.
  struct Triangle
  {
    int Id;
    std::array<int, 3> Nodes;
  };

  ///@{
  /// Of the last run: the nodes in the order met, the triangles in the order in which their last
  /// corner was met, and the data of one of these nodes.
  const std::vector<int>& Nodes() const { return this->Met; }
  const std::vector<Triangle>& Triangles() const { return this->Covered; }
  const Eigen::Vector2d& Image(int node) const { return this->Samples[node].Image; }
  const Eigen::Vector3d& Position(int node) const { return this->Samples[node].Position; }
  double Distance(int node) const { return this->Samples[node].Distance; }
  ///@}

private:
  enum State
  {
    AlongEdge,      ///< reached along the edge from Source
    AcrossTriangle, ///< reached straight across a triangle that Source is a corner of
    Settled,
    StateCount
  };

  /// The data of a node; two cache lines.
  struct alignas(64) Sample
  {
    Eigen::Vector3d Position = Eigen::Vector3d::Zero(), Normal = Eigen::Vector3d::Zero();
    Eigen::Matrix<double, 2, 3> Axes = Eigen::Matrix<double, 2, 3>::Zero(); ///< x and y
    Eigen::Vector2d Image = Eigen::Vector2d::Zero();
    double Distance = 0.0;
    int Source = -1; ///< the neighbour that the front came from; -1: the seed
  };

  /// The image of a node that a neighbour predicts (equation 10).
  struct Prediction
  {
    Eigen::Vector2d Image;
    Eigen::Vector3d XAxis;
    Eigen::Vector2d Step; ///< from the image of the one to that of the other
    double Length2;       ///< of the edge between them, squared
  };

  /// The mean of several predictions: the image times Factor; the x axis is of any length.
  struct Mean
  {
    Eigen::Vector2d Image;
    Eigen::Vector3d XAxis;
    double Factor;
  };

  static Prediction Predict(const Sample& from, const Sample& to);
  static double Distance2Across(
    const Sample& first, const Sample& second, const Eigen::Vector3d& apex, bool& nearFirst);

  void BeginRun(const TangentFrame& seed);
  void Start(const Eigen::RowVector3i& corners, const Eigen::RowVector3d& barycentric);
  bool IsSettled(int node) const { return this->Marks[node] == this->FirstMark + Settled; }
  void Reach(int node, double distance, int source, State state);
  void ReachAlong(const Sample& from, int node, int source);
  void Spread(int node);
  static void SetAxes(Sample& sample, const Eigen::Vector3d& xAxis);
  void Settle(int node);
  void FindUpwind(int node);
  Mean UpwindMean(const Sample& sample, const Prediction& first) const;

  bool UpwindAverage;
  VertexFans Fans;
  std::vector<Sample> Samples; ///< what older runs left is told by its mark and not cleared
  std::vector<int> Marks; ///< of each node its State, from FirstMark on where reached in this run
  int FirstMark = 0;
  Sample Seed;
  std::vector<std::pair<double, int>> Queue;
  std::vector<Triangle> Covered;
  std::vector<int> Met,
    Upwind; ///< Upwind: of the node that is being settled, the first UpwindCount
  int UpwindCount = 0;
};

} // namespace shape
