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
 * The front of an ExponentialMap (see there), which spreads over the nodes of a surface's graph. An
 * object serves many runs. The time of a run grows with the part of the surface that it covers.
 */
class ExponentialFront
{
public:
  /// triangles: m x 3 nodes. normals: n x 3, the unit normals of the nodes. upwindAverage: whether
  /// to use equation 11.
  ExponentialFront(const PointGraph& graph, const Eigen::MatrixXi& triangles,
    const Eigen::MatrixXd& normals, bool upwindAverage);

  /// Runs from a seed until the next node is beyond the radius. seed: the tangent frame at the
  /// seed. corners, barycentric: the nodes of the seed's triangle, and the coordinates of the seed
  /// in it. Throws Aborted.
  void Run(const TangentFrame& seed, const Eigen::RowVector3i& corners,
    const Eigen::RowVector3d& barycentric, double radius, const Progress& progress = {});

  /// A triangle between nodes.
  struct Triangle
  {
    int Id;
    std::array<int, 3> Nodes;
  };

  ///@{
  /// Results of the last run. Nodes are in the order in which they were reached, and triangles in
  /// the order in which their last corners were reached. Image, Position and Distance are defined
  /// for reached nodes only.
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
    AcrossTriangle, ///< reached on a straight line across a triangle with corner Source
    Settled,
    StateCount
  };

  /// The data of a node, which fills whole cache lines.
  struct alignas(64) Sample
  {
    Eigen::Vector3d Position = Eigen::Vector3d::Zero(), Normal = Eigen::Vector3d::Zero();
    /// the x and y axes, one per row
    Eigen::Matrix<double, 2, 3> Axes = Eigen::Matrix<double, 2, 3>::Zero();
    Eigen::Vector2d Image = Eigen::Vector2d::Zero();
    double Distance = 0.0;
    int Source = -1; ///< the neighbour from which the front came; -1: the seed
  };

  /// The image of a node predicted by a neighbour (equation 10).
  struct Prediction
  {
    Eigen::Vector2d Image;
    Eigen::Vector3d XAxis;
    Eigen::Vector2d Step; ///< vector from the neighbour's image to the predicted image
    double Length2;       ///< squared length of the edge from the neighbour to the node
  };

  /// The weighted sum of several predictions. Image is their mean times Factor; XAxis is not
  /// normalised.
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
  std::vector<Sample> Samples; ///< not cleared between runs; Marks shows which are valid
  /// FirstMark + State for each node reached in this run; less for other nodes
  std::vector<int> Marks;
  int FirstMark = 0;
  /// The neighbours of node i are Neighbours[FirstNeighbour[i]] ... Each is listed once, although
  /// triangles of a sampled surface overlap: otherwise, the mean of the predictions would depend on
  /// the side to which the normals point.
  std::vector<int> FirstNeighbour, Neighbours;
  Sample Seed;
  std::vector<std::pair<double, int>> Queue;
  std::vector<Triangle> Covered;
  std::vector<int> Met,
    Upwind; ///< Upwind: neighbours of the node being settled; the first UpwindCount are valid
  int UpwindCount = 0;
};

} // namespace shape
