#pragma once

#include "Correspondence/CommonBase/Private/TracedSurface.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace shape
{

/// A closed curve along edges of a surface that does not meet itself.
struct SurfaceCycle
{
  std::vector<int> Points;  ///< in order; the last one is joined to the first
  double Length = 0.0;      ///< in the model's units
  Eigen::VectorXi Homology; ///< its coefficients in a basis of loops
};

/// Two loops through one point that cross once. They cut a handle.
struct LoopCrossing
{
  SurfaceCycle Handle; ///< bounds inside the surface; its first point is that of the crossing
  SurfaceCycle Tunnel; ///< bounds outside the surface; its first point is the same
  int Point() const { return this->Handle.Points.front(); }
  double Length() const { return this->Handle.Length + this->Tunnel.Length; }
};

/// Returns a cycle in the other direction, from the same first point.
SurfaceCycle Reversed(const SurfaceCycle& cycle);
/// Returns both loops in the directions that they may have.
std::array<LoopCrossing, 4> Turned(const LoopCrossing& crossing);

/**
 * Finds short handle loops and tunnel loops (Dey, Li, Sun and Cohen-Steiner, "Computing
 * geometry-aware handle and tunnel loops in 3D models", 2008): loops that are not the boundary of a
 * part of the surface, but bound inside or outside it. The linking numbers of loops tell which.
 *
 * The shortest loop through a point that is no boundary consists of an edge and the shortest paths
 * from the point to both its ends (Erickson and Whittlesey, "Greedy optimal homotopy and homology
 * generators", 2005). The shortest one that bounds on a given side may need paths of other classes,
 * so several paths to each point are kept, whose classes differ.
 */
class HandleLoops
{
public:
  /// surface: closed and connected. name: of the surface, in messages. Throws InvalidInput if the
  /// surface intersects itself.
  HandleLoops(const Surface& surface, const std::string& name);

  int Genus() const { return static_cast<int>(this->Traced.Basis.Linking.rows() / 2); }
  /// Returns the shortest crossings at a point, the shortest first; at most `count`, or none.
  std::vector<LoopCrossing> FindAt(int point, int count) const;
  /// Returns how often two loops cross, with signs.
  int Crossings(const SurfaceCycle& one, const SurfaceCycle& other) const
  {
    return this->Traced.Crossings(one.Homology, other.Homology);
  }

private:
  std::vector<SurfaceCycle> CyclesAt(int point) const;

  TracedSurface Traced;
};

} // namespace shape
