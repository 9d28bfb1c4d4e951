#pragma once

#include "Mesh/HexMesh.h"
#include "Mesh/Topology.h"

#include <Eigen/Core>

#include <map>
#include <utility>
#include <vector>

namespace shape
{

/// An edge of a quad, counter-clockwise around it seen from outside.
using QuadEdge = std::pair<int, int>;

/// A closed surface of quads, as hexahedra have: which quads are neighbours. Never changes.
class QuadSurface
{
public:
  /// quads: q x 4, an oriented 2-manifold without boundary.
  explicit QuadSurface(Eigen::MatrixXi quads);

  const Eigen::MatrixXi& Quads() const { return this->Corners; } ///< q x 4

  /// The quad of each edge; each edge is there twice, once in each direction.
  const std::map<QuadEdge, int>& Edges() const { return this->QuadOf; }

  /// The quad that an edge belongs to. Throws std::out_of_range if there is no such edge.
  int QuadAt(const QuadEdge& edge) const { return this->QuadOf.at(edge); }

  /// The quad across edge k of a quad: from its corner k to the next.
  int Across(int quad, int k) const;

  /// The quad after `quad` around a point of it, counter-clockwise.
  int NextAround(int point, int quad) const;

  /// The quads around a point, counter-clockwise from `quad`, which has the point.
  std::vector<int> QuadsAround(int point, int quad) const;

private:
  Eigen::MatrixXi Corners;
  std::map<QuadEdge, int> QuadOf;
};

/// The topology of the boundary of hexahedra.
Topology ComputeBoundaryTopology(const HexMesh& mesh);

/// Whether the boundary of hexahedra is a 2-manifold with the Euler number and the number of
/// components of `wanted`.
bool HasBoundaryTopology(const HexMesh& mesh, const Topology& wanted);

} // namespace shape
