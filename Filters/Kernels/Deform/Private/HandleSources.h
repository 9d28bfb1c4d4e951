#pragma once

#include "Deform/BoundaryHandle.h"
#include "Deform/Private/NodeDeformation.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The start of the front: a graph with the nodes of a shape and those of its handle, and how the
 * latter follow the handle's samples.
 *
 * A node of the shape is a source if it is within 1e-6 of the diagonal of a sample, a segment or a
 * triangle of the handle. Other samples become new nodes, and so do positions on segments and in
 * triangles that are longer than the mean edge of the shape, so that a coarse handle has no gaps;
 * all of these are linked with the shape's nearest nodes.
 */
struct HandleSources
{
  /// The shape's nodes come first, in their order. Weights of sources are those of the handle
  /// there: three times the area of its triangles, or of a strip of half a mean edge beside its
  /// curve; that of new positions on edges of triangles is the square of a mean edge.
  PointGraph Graph;
  std::vector<int> Nodes;  ///< k: the sources
  Eigen::MatrixXi Samples; ///< k x 3: the samples that a source lies between
  Eigen::MatrixXd Shares;  ///< k x 3: its barycentric coordinates there
};

/// The motions of the sources of a posed handle, in their order. scales: for each node, of its
/// offset from the handle, which is tiny.
NodeTransforms MoveSources(const HandleSources& sources, const BoundaryHandle& handle,
  const HandlePose& pose, const Eigen::VectorXd& scales);

} // namespace shape
