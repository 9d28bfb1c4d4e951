#pragma once

#include "Base/Progress.h"
#include "CutPaste/LoopSides.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Geometry/SampledSurface.h"
#include "Mesh/Graph.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Closed loops on a surface given by points: the links between neighbouring points are the edges
/// of its local triangles.
class SampledLoops
{
public:
  /// samples: kept by reference. Throws Aborted.
  explicit SampledLoops(const SampledSurface& samples, const Progress& progress = {});

  /**
   * Traces a closed curve along links. curve: k x 3, at least 3 positions on or near the surface;
   * the last one is joined to the first. Each position is moved to the nearest sample. From there,
   * the exponential map around this sample flattens the surface up to the next one: the geodesic is
   * a straight line, and the path is that of the shortest links that stays near this line. A link
   * costs its length, times 1 plus the squared distance of its ends from the line, in mean links.
   * Where the paths pass through a sample twice, the shorter part is left out.
   *
   * Returns the samples of the loop in order, each once. Throws InvalidInput if the curve has fewer
   * than 3 samples, or if two of its positions are on parts of the surface that no link connects;
   * Aborted.
   */
  std::vector<int> Trace(const Eigen::MatrixXd& curve, const Progress& progress = {});

  /**
   * Marks the samples strictly on one side of a loop: 1 for marked samples, else 0. Samples of the
   * loop are not marked. No link between the two sides passes the loop: links to its samples and
   * links that cross it in the tangent plane are left out. A part of the surface that the loop does
   * not touch is on neither side.
   *
   * Throws InvalidInput if the loop does not divide the surface, as around a handle, or if there is
   * no sample on the side.
   */
  std::vector<char> MarkSide(const std::vector<int>& loop, LoopSide side) const;

  /// The mean length of a link.
  double Spacing() const { return this->MeanLink; }
  ExponentialMap& Layout() { return this->Map; }

private:
  std::vector<int> PathBetween(int from, int to, const Progress& progress);

  const SampledSurface& Samples;
  Graph Links;
  ExponentialMap Map;
  double MeanLink;
};

} // namespace shape
