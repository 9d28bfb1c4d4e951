#pragma once

#include "Deform/BoundaryHandle.h"
#include "Deform/Private/NodeDeformation.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The start of the front: a graph with the nodes of a shape and those of its handle, and the rule
 * by which the handle's nodes follow its samples.
 *
 * A node of the shape is a source if its distance from a sample, a segment or a triangle of the
 * handle is at most 1e-6 of the diagonal. Other samples become new nodes. So do positions on long
 * segments and in large triangles (compared with the mean edge of the shape), so that a coarse
 * handle leaves no gaps. All new nodes are linked with the shape's nearest nodes.
 */
struct HandleSources
{
  /// The shape's nodes come first, in their order. The weight of a source on a triangle is three
  /// times its share of the area. On a curve, it is the area of a strip along its share of the
  /// curve (CurveWidth). Other nodes of the shape keep their weights; other new nodes get
  /// the square of a mean edge.
  PointGraph Graph;
  std::vector<int> Nodes;  ///< k: the sources
  Eigen::MatrixXi Samples; ///< k x 3: the samples between which a source lies
  Eigen::MatrixXd Shares;  ///< k x 3: the barycentric coordinates of the source among them
  SourceCurves Curves;     ///< the segments of the handle's curves, from sample to sample
};

/// Returns the motions of the sources of a posed handle, in their order. scales: for each node, the
/// factor of its tiny offset from the handle.
NodeTransforms MoveSources(const HandleSources& sources, const BoundaryHandle& handle,
  const HandlePose& pose, const Eigen::VectorXd& scales);

} // namespace shape
