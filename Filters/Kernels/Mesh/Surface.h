#pragma once

#include "Mesh/HalfEdges.h"
#include "Mesh/Mesh.h"
#include "Mesh/Topology.h"

#include <functional>
#include <memory>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

namespace shape
{

/**
 * An immutable triangulated surface that caches data derived from it: half-edges, topology, area
 * vectors, and data that kernels add, such as a search tree or a Laplacian.
 *
 * Each of these is computed once, on first use, and shared by all copies. Copying a surface copies
 * only a pointer. Kernels take a `const Surface&`, so a kernel that calls ten others checks and
 * indexes its surface only once. Every member may be called from several threads.
 */
class Surface
{
public:
  /// Constructs a surface without points and triangles.
  Surface();

  /// Constructs from a mesh, which is moved or copied. The conversion is implicit, so a mesh can be
  /// passed to a kernel that takes a surface.
  Surface(Mesh mesh); // NOLINT(google-explicit-constructor)

  /// Constructs from points (n x 3) and triangles (m x 3 indices of points).
  Surface(Eigen::MatrixXd points, Eigen::MatrixXi triangles);

  const Eigen::MatrixXd& Points() const { return this->AsMesh().Points; }       ///< n x 3
  const Eigen::MatrixXi& Triangles() const { return this->AsMesh().Triangles; } ///< m x 3

  ///@{
  /// The points and triangles as a Mesh.
  const Mesh& AsMesh() const;
  operator const Mesh&() const { return this->AsMesh(); } // NOLINT(google-explicit-constructor)
  ///@}

  /// Returns a surface with the same triangles and its points at other positions (n x 3).
  /// Half-edges, twins and topology depend on the triangles alone, so both surfaces share them.
  /// Throws InvalidInput unless there is one row for each point.
  Surface WithPoints(Eigen::MatrixXd points) const;

  /// The sorted half-edges (SortHalfEdges). Throws InvalidInput if an index is out of range.
  const std::vector<HalfEdge>& HalfEdges() const;

  /// The twin of each half-edge (FindTwins). The surface must be an oriented 2-manifold.
  const std::vector<int>& Twins() const;

  /// The topology (ComputeTopology). Throws the exceptions of ComputeTopology.
  const shape::Topology& Topology() const;

  /// The twice-area vectors of the triangles (m x 3, ComputeAreaVectors).
  const Eigen::MatrixXd& AreaVectors() const;

  /// Returns the object of type T that is cached in the surface. The first call computes it by
  /// `make()`. There is one object per type, so a kernel defines its own type for its data. The
  /// object must not contain the surface itself, since neither would then ever be freed.
  template <typename T, typename Make>
  std::shared_ptr<const T> Cached(const Make& make) const
  {
    return std::static_pointer_cast<const T>(this->Find(typeid(T),
      [&]() -> std::shared_ptr<const void> { return std::make_shared<const T>(make()); }));
  }

private:
  struct Data;
  /// Returns the object cached for this type, or makes it. If `make` throws, nothing is cached.
  const std::shared_ptr<const void>& Find(
    std::type_index type, const std::function<std::shared_ptr<const void>()>& make) const;

  std::shared_ptr<Data> Impl;
};

/// Returns the components of a surface in the order of ComponentId. Each has the points that it
/// uses, in their original order.
std::vector<Mesh> SplitComponents(const Surface& surface);

/// Throws InvalidInput unless `surface` has triangles and is a consistently oriented 2-manifold,
/// open or closed. Every coordinate must be finite, and the longest edge of the bounding box must
/// be between 1e-50 and 1e50. `name` denotes the surface in the message. Returns the topology.
Topology RequireManifold(const Surface& surface, const std::string& name);

/**
 * The same, but throws InvalidInput also if the surface is open. `name` is, for example, "the
 * boundary" or "the surface".
 */
Topology RequireClosedSurface(const Surface& surface, const std::string& name);

} // namespace shape
