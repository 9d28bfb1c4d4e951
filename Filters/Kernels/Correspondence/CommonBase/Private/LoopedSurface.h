#pragma once

#include "Base/Progress.h"
#include "Correspondence/CommonBase/Private/HandleLoops.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// A coarse surface with its loops and distances.
struct LoopedSurface
{
  /// surface: closed and connected. name: of the surface, in messages. Throws the exceptions of
  /// HandleLoops; SolveFailure, Aborted.
  LoopedSurface(const Surface& surface, const std::string& name, const Progress& progress = {});

  Surface Shape;
  HandleLoops Loops;
  std::vector<int> Samples;  ///< spread over the surface
  Eigen::VectorXd Weights;   ///< of the samples, with sum 1
  Eigen::MatrixXd Between;   ///< distances between the samples
  Eigen::MatrixXd Distances; ///< n x n: column i has those from point i, over the root of the area
};

/// Returns the shortest crossings at each point of a surface. Throws Aborted.
std::vector<LoopCrossing> FindCrossings(
  const LoopedSurface& surface, const Progress& progress = {});

/// Returns the shortest of all crossings, one for each handle: their loops span the homology.
std::vector<LoopCrossing> ChooseHandles(
  const LoopedSurface& surface, std::vector<LoopCrossing> all);

/// Returns some of the crossings, whose points are spread over those of all.
std::vector<LoopCrossing> SpreadCrossings(
  const LoopedSurface& surface, const std::vector<LoopCrossing>& all);

/// Returns the point of a crossing, and those nearest to some shares of the length of both loops.
/// shares: half of them of the handle loop, the others of the tunnel loop; on return, those where
/// the points are.
std::vector<int> MarksOf(
  const LoopedSurface& surface, const LoopCrossing& crossing, std::vector<double>& shares);

/// Returns the length of the shortest loop of some handles, over the root of the area.
double ShortestLoop(const LoopedSurface& surface, const std::vector<LoopCrossing>& handles);

/// Returns how much the map of samples that landmarks determine changes the distances between them
/// (AutomaticLandmarksResult::Distortion).
double DistortionOf(const LoopedSurface& a, const LoopedSurface& b, const Landmarks& pairs);

/// Adds landmarks far from the others, until no point of A is: the farthest point of A, with the
/// point of B that has the most similar distances from the others.
Landmarks WithFarPoints(const LoopedSurface& a, const LoopedSurface& b, Landmarks pairs);

} // namespace shape
