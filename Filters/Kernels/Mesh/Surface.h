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
 * A triangulated surface that never changes, with what follows from it: half-edges, topology,
 * area vectors, and whatever kernels add (a search tree, a Laplacian).
 *
 * Each of these is computed when it is first asked for, once, and shared by all copies; a copy
 * costs as much as a pointer. Kernels take a `const Surface&`, so that one that calls ten others
 * checks and indexes its surface once. Every member may be called from several threads.
 */
class Surface
{
public:
  /// No points and no triangles.
  Surface();

  /// From a mesh, which is moved or copied. A mesh may stand wherever a kernel takes a surface.
  Surface(Mesh mesh); // NOLINT(google-explicit-constructor)

  /// From n x 3 positions and m x 3 indices of them.
  Surface(Eigen::MatrixXd points, Eigen::MatrixXi triangles);

  const Eigen::MatrixXd& Points() const { return this->AsMesh().Points; }       ///< n x 3
  const Eigen::MatrixXi& Triangles() const { return this->AsMesh().Triangles; } ///< m x 3

  ///@{
  /// The points and triangles as a value, for what takes a mesh.
  const Mesh& AsMesh() const;
  operator const Mesh&() const { return this->AsMesh(); } // NOLINT(google-explicit-constructor)
  ///@}

  /// SortHalfEdges of the triangles. Throws InvalidInput as RequireIndices does.
  const std::vector<HalfEdge>& HalfEdges() const;

  /// SideTwins of the triangles, which must be an oriented 2-manifold's.
  const std::vector<int>& Twins() const;

  /// Throws InvalidInput as ComputeTopology does.
  const shape::Topology& Topology() const;

  /// AreaVectors of the triangles (m x 3).
  const Eigen::MatrixXd& AreaVectors() const;

  /// Something of type T that follows from the surface: what `make()` returns when it is first
  /// asked for. There is one of each type; a kernel defines a type for what it keeps here. It must
  /// not hold the surface itself, or neither would ever be freed.
  template <typename T, typename Make>
  std::shared_ptr<const T> Cached(const Make& make) const
  {
    return std::static_pointer_cast<const T>(this->Find(typeid(T),
      [&]() -> std::shared_ptr<const void> { return std::make_shared<const T>(make()); }));
  }

private:
  struct Data;
  /// What was kept under the type, or made now; what `make` throws is thrown, and nothing is kept.
  const std::shared_ptr<const void>& Find(
    std::type_index type, const std::function<std::shared_ptr<const void>()>& make) const;

  std::shared_ptr<Data> Impl;
};

/// The components of a surface in the order of ComponentId, each with the points it uses, in order.
std::vector<Mesh> SplitComponents(const Surface& surface);

/// Throws InvalidInput unless `surface` has triangles, every coordinate is finite, its longest side
/// is between 1e-50 and 1e50 and it is a consistently oriented 2-manifold, open or closed. `name`
/// is what the message calls it.
Topology RequireManifold(const Surface& surface, const std::string& name);

/**
 * The same, and closed: `name` is what the message calls it: "the boundary", "the surface".
 */
Topology RequireClosedSurface(const Surface& surface, const std::string& name);

} // namespace shape
