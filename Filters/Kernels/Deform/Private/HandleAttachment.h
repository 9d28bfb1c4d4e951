#pragma once

#include "Base/Progress.h"
#include "Deform/Private/HandleSources.h"
#include "Search/PointTree.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/**
 * Collects the sources of a handle, element by element. The order of calls is AddSamples; then
 * AddSegment for each segment of a curve and each edge of a triangle; then AddTriangle for each
 * triangle; then Finish, once.
 */
class HandleAttachment
{
public:
  /// Stores references to shape and handle. The handle must have samples, and its elements must be
  /// in range.
  HandleAttachment(const PointGraph& shape, const BoundaryHandle& handle);

  /// Makes each sample a source; of several coincident samples, only the first one.
  void AddSamples(const Progress& progress);

  /// Makes the shape's nodes on a segment sources, and adds new positions between sources that are
  /// too far apart. onCurve: whether each source is weighted by the length that it represents.
  void AddSegment(int a, int b, bool onCurve);

  /// Makes the shape's nodes inside a triangle sources. If there are none and the triangle is
  /// large, adds the nodes of a grid in it instead.
  void AddTriangle(Eigen::RowVector3i corners);

  HandleSources Finish();

private:
  /// A position on a segment, from 0 to 1, and the source there.
  using SegmentSource = std::pair<double, int>;

  double EdgeLength(const Eigen::RowVector3i& corners, int k) const;
  int CountParts(double length) const;
  std::vector<int> FindNodesNear(
    const Eigen::RowVector3d& from, const Eigen::RowVector3d& to) const;
  void BindNodesOnSegment(int a, int b, std::vector<SegmentSource>& along);
  void FillGaps(int a, int b, std::vector<SegmentSource>& along);
  void BindNodesInTriangle(const Eigen::RowVector3i& corners, std::vector<int>& sources);
  void AddGrid(const Eigen::RowVector3i& corners, double area, std::vector<int>& sources);
  int AddPosition(const Eigen::RowVector3d& position, const Eigen::RowVector3i& samples,
    const Eigen::RowVector3d& shares);
  void Bind(int node, const Eigen::RowVector3i& samples, const Eigen::RowVector3d& shares);
  int Add(int node, const Eigen::RowVector3i& samples, const Eigen::RowVector3d& shares);
  void LinkToShape(
    int node, const Eigen::RowVector3d& position, std::vector<std::pair<int, int>>& links) const;

  const PointGraph& Shape;
  const BoundaryHandle& Handle;
  PointTree Tree, SampleTree;
  double Tolerance, Step;
  double Gap;                ///< maximum distance between sources
  std::vector<int> SourceOf; ///< for each of the shape's nodes, its source or -1
  std::vector<int> OfSample;
  std::vector<int> Nodes;
  std::vector<Eigen::RowVector3i> Samples;
  std::vector<Eigen::RowVector3d> Shares, Extra;
  std::vector<double> Weights, CurveWeights; ///< CurveWeights: the part from curves
  std::vector<std::pair<int, int>> Links;
  std::vector<std::pair<int, int>> CurveSegments; ///< sources
};

/// Computes the sources of a handle on a shape. Throws InvalidInput if the handle has no samples, a
/// sample that is not finite, or a segment or triangle out of range; Aborted.
HandleSources AttachHandle(
  const PointGraph& shape, const BoundaryHandle& handle, const Progress& progress = {});

} // namespace shape
