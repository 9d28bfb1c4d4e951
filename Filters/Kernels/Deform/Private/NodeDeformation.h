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

/// The width of the strip along a curve that its sources represent, in mean links. It is half of
/// the area of the triangles around a boundary vertex, over their edge: in a mesh of equilateral
/// triangles with edge h, a boundary vertex has three of them, of area sqrt(3) / 4 h^2 each, in
/// total 1.3 h^2.
constexpr double CurveWidth = 1.3;

/// The curves among the sources of a graph.
struct SourceCurves
{
  Eigen::MatrixXi Segments; ///< l x 2: the sources at the ends of each segment
  /// For each source, the share of its weight that it does not have from curves: 1 at a point that
  /// is on no curve, 0 on curves alone.
  Eigen::VectorXd OtherShares;
};

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
  SourceCurves Curves = {};                        ///< its sources are indices in Sources
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
