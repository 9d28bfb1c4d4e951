#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/LoopSides.h"
#include "CutPaste/SampledLoop.h"
#include "Fill/FillHoles.h"
#include "Geometry/SampledSurface.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace shape
{

struct CutPointsOptions
{
  LoopSide Side = LoopSide::Smaller;
  bool FillHole = true;  ///< whether the hole that the feature leaves is filled
  FillHolesOptions Fill; ///< its points are as far from each other as those of the loop
};

/// A feature cut from a point cloud. Both parts have the points of the loop.
struct CutPointsResult
{
  std::vector<int> Feature; ///< points of the cloud, ascending
  std::vector<int> Rest;    ///< points of the cloud, ascending
  std::vector<int> Loop;    ///< points of the cloud in order, with the feature to the left
  /// The fill, if FillHole is set: the loop's points, in order, then new points. Its triangles have
  /// the side of the normals outside.
  Mesh Fill;
  Eigen::MatrixXd FillNormals;         ///< unit normals at the new points
  std::vector<FilledHole> Holes;       ///< the fill, with the loop's points from 0; empty if none
  std::vector<FeatureFootprint> Bases; ///< the feature's base on the filled rest; empty if none
  double CutLength = 0.0;              ///< length of the loop
  double FeatureArea = 0.0;            ///< area of the local triangles of the feature's points
};

/**
 * Cuts features from a surface given by points, any number of times, along closed curves on it.
 * See section 4.2 of Schmidt and Singh, "Drag-and-drop surface composition" (Graphics Interface
 * 2010), which needs no more than samples.
 *
 * The points are connected by local triangles (ConnectSamples). The loop runs along their edges,
 * from point to point (SampledLoops). The points on one side of it are the feature. The hole of the
 * rest is filled from its loop with normals (SurfaceFiller, section 4.1), and only the points of
 * the fill are used. The base is that of the rest with these points.
 *
 * A cutter must not be used by several threads at once.
 */
class PointCutter
{
public:
  /// samples: the points with their normals. Throws the exceptions of ExponentialMap; Aborted.
  explicit PointCutter(SampledSurface samples, const Progress& progress = {});
  PointCutter(const PointCutter&) = delete;
  PointCutter& operator=(const PointCutter&) = delete;

  const SampledSurface& Sampled() const { return this->Samples; }
  double Spacing() const { return this->Loops->Spacing(); }

  /// Cuts one feature. curve: k x 3, closed, at least 3 positions; the last is joined to the first.
  /// Throws the exceptions of SampledLoops, SurfaceFiller and ConnectSamples; Aborted.
  CutPointsResult Cut(const Eigen::MatrixXd& curve, const CutPointsOptions& options = {},
    const Progress& progress = {});

private:
  void FillRest(
    const CutPointsOptions& options, CutPointsResult& result, const Progress& progress) const;
  void FindBase(CutPointsResult& result, const Progress& progress) const;

  SampledSurface Samples;
  std::unique_ptr<SampledLoops> Loops;
};

} // namespace shape
