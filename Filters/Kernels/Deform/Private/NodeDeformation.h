#pragma once

#include "Base/Progress.h"
#include "Deform/UpwindFront.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace shape
{

/// How nodes of a graph move and turn.
struct NodeTransforms
{
  Eigen::MatrixXd Shifts; ///< 3 x n: from a node's place to where it goes
  std::vector<Eigen::Matrix3d> Rotations;
};

/// How many weights are kept (512 MiB of them); where there are more, each pass finds them again.
constexpr std::size_t MaximumKeptWeights = std::size_t(1) << 27;

/// A graph, the nodes of it that are moved by hand, and how the others follow them.
struct NodeProblem
{
  PointGraph Graph;         ///< in one piece
  std::vector<int> Sources; ///< different nodes, at least one
  Eigen::VectorXd Powers;   ///< n: k of equation 4
  Eigen::VectorXd Scales;   ///< n: of the offsets to each node
  UpwindFrontOptions Front;
  std::size_t MaximumWeights = MaximumKeptWeights; ///< of those that are kept
};

/// The nodes of a graph as they follow its sources: what every method and resolution does.
class NodeDeformation
{
public:
  virtual ~NodeDeformation() = default;

  /// The motions of all nodes where the sources, in their order, move like this. Nodes that the
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
