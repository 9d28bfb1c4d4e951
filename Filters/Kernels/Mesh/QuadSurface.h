#pragma once

#include "Mesh/HexMesh.h"
#include "Mesh/Topology.h"

#include <Eigen/Core>

#include <map>
#include <utility>
#include <vector>

namespace shape
{

/// An edge of a quad, in counter-clockwise direction seen from outside.
using QuadEdge = std::pair<int, int>;

/// An immutable closed surface of quads, such as the boundary of hexahedra, with its adjacency.
class QuadSurface
{
public:
  /// quads: q x 4, an oriented 2-manifold without boundary.
  explicit QuadSurface(Eigen::MatrixXi quads);

  const Eigen::MatrixXi& Quads() const { return this->Corners; } ///< q x 4

  /// The quad of each directed edge; each edge occurs in both directions.
  const std::map<QuadEdge, int>& Edges() const { return this->QuadOf; }

  /// Returns the quad of a directed edge. Throws std::out_of_range if there is no such edge.
  int QuadAt(const QuadEdge& edge) const { return this->QuadOf.at(edge); }

  /// Returns the quad across edge k of a quad. Edge k runs from corner k to the next corner.
  int Across(int quad, int k) const;

  /// Returns the quad after `quad` around one of its points, counter-clockwise.
  int NextAround(int point, int quad) const;

  /// Returns the quads around a point of `quad`, counter-clockwise, starting with `quad`.
  std::vector<int> QuadsAround(int point, int quad) const;

private:
  Eigen::MatrixXi Corners;
  std::map<QuadEdge, int> QuadOf;
};

/// Computes the topology of the boundary of hexahedra.
Topology ComputeBoundaryTopology(const HexMesh& mesh);

/// Whether the boundary of hexahedra is a 2-manifold with the same Euler number and number of
/// components as `wanted`.
bool HasBoundaryTopology(const HexMesh& mesh, const Topology& wanted);

} // namespace shape
