#pragma once

#include "Correspondence/CommonBase/Private/PathSurface.h"

#include <functional>
#include <limits>
#include <vector>

namespace shape
{

/// The triangles around a point from one path, counter-clockwise, to the next.
struct SurfaceGap
{
  int Point = -1;
  /// The second point of the path before the gap; -1 if no path meets the point, whose triangles
  /// are then all in the gap.
  int Neighbour = -1;
};

/// A path between two gaps that crosses no other path.
struct StripPath
{
  double Length = std::numeric_limits<double>::infinity(); ///< infinite if there is no path
  int Begin = -1, End = -1;                                ///< the points at its ends
  /// The half-edges that it crosses, each of the triangle before the crossing. Empty: the path is
  /// the edge between both points.
  std::vector<int> Sides;
  /// The integrals of the surface's forms along the path.
  FormValues Forms{};
};

/// Whether a path with these integrals may be taken.
using AcceptForms = std::function<bool(const FormValues& forms)>;

/**
 * Finds a short path from a gap to each of other gaps, through the midpoints of edges. There is one
 * whenever a curve between the gaps meets no path of the surface: the strip of triangles that it
 * passes can be split. Edges that touch paths count double, so that paths keep apart.
 *
 * accept: if given, the paths are the shortest ones whose integrals it accepts. Then no edge may
 * join the points of two gaps. A path that would cross itself is not returned. longest: the
 * weighted length beyond which there is no search.
 */
std::vector<StripPath> FindStripPaths(const PathSurface& surface, const SurfaceGap& from,
  const std::vector<SurfaceGap>& to, const AcceptForms& accept = nullptr,
  double longest = std::numeric_limits<double>::infinity());

/// Straightens a path within its strip, splits the triangles that it passes, and marks it. Returns
/// its points in order.
std::vector<int> ImprintStripPath(PathSurface& surface, const StripPath& path, int number);

} // namespace shape
