#pragma once

#include "Base/Progress.h"
#include "Deform/UpwindFront.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace shape
{

/// The translations and rotations of the nodes of a graph.
struct NodeTransforms
{
  Eigen::MatrixXd Shifts; ///< 3 x n vectors from the old to the new positions
  std::vector<Eigen::Matrix3d> Rotations;
};

/// The maximum number of stored weights (512 MiB). If there are more, each pass computes the
/// weights again.
constexpr std::size_t MaximumKeptWeights = std::size_t(1) << 27;

/// A graph, the sources that are moved, and the parameters by which the other nodes follow the
/// sources.
struct NodeProblem
{
  PointGraph Graph;         ///< connected
  std::vector<int> Sources; ///< distinct nodes, at least one
  Eigen::VectorXd Powers;   ///< n powers k of equation 4, one for each node
  Eigen::VectorXd Scales;   ///< n factors of the offsets, one for each node
  UpwindFrontOptions Front;
  std::size_t MaximumWeights = MaximumKeptWeights; ///< maximum number of stored weights
};

/// Moves the nodes of a graph with its sources: the interface of all methods and resolutions.
class NodeDeformation
{
public:
  virtual ~NodeDeformation() = default;

  /// Returns the motions of all nodes, given those of the sources in their order. Nodes that the
  /// front reaches later than `reach` may stay. Throws Aborted.
  virtual NodeTransforms Move(
    const NodeTransforms& sources, double reach, const Progress& progress = {}) const = 0;

  int EmptyBands() const { return this->Empty; }
  int ZeroWeights() const { return this->Zero; }
  int BaseNodes() const { return this->Base; }
  bool IsStreamed() const { return this->Streamed; }

protected:
  int Empty = 0, Zero = 0, Base = 0;
  bool Streamed = false;
};

} // namespace shape
