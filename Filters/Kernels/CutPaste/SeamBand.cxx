#include "CutPaste/SeamBand.h"

#include "Mesh/EdgeMidpoints.h"
#include "Mesh/HalfEdges.h"
#include "Planar/PlanarDelaunay.h"

#include <algorithm>

namespace shape
{
namespace
{

/// The inner edges of a band that join two points of the ring.
std::vector<std::array<int, 2>> RingChords(const SeamBand& band, int loop)
{
  const Eigen::Index points = loop + band.RingPoints.size();
  std::vector<bool> isRing(points, true);
  std::fill_n(isRing.begin(), loop, false);
  for (const int point : band.RingPoints)
  {
    isRing[point] = true;
  }
  std::vector<std::array<int, 2>> chords;
  const std::vector<HalfEdge> sides = SortHalfEdges(band.Triangles, points);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    const int low = sides[i].Low(), high = sides[i].High();
    const bool isInner = sides[i + 1].Low() == low && sides[i + 1].High() == high;
    if (isInner && isRing[low] && isRing[high])
    {
      chords.push_back({ low, high });
    }
  }
  return chords;
}

} // namespace

SeamBand TriangulateSeamBand(const Eigen::MatrixXd& loop, const Eigen::MatrixXd& ring)
{
  const auto inner = static_cast<int>(loop.rows()), outer = static_cast<int>(ring.rows());
  Eigen::MatrixXd points(inner + outer, 2);
  points << loop, ring;
  Eigen::MatrixXi segments(inner + outer, 2);
  for (int i = 0; i < inner; ++i)
  {
    segments.row(i) << i, (i + 1) % inner;
  }
  for (int i = 0; i < outer; ++i)
  {
    segments.row(inner + i) << inner + i, inner + (i + 1) % outer;
  }
  PlanarDelaunayOptions options;
  options.Keep = PlanarDelaunayOptions::KeepType::Oddly;
  const PlanarTriangulation joined = TriangulateInPlane(points, segments, options);
  SeamBand band{ joined.Triangles, joined.SamePoint.tail(outer), {} };
  const CutTriangles cut = SplitEdges(band.Triangles, RingChords(band, inner), inner + outer);
  band.Triangles = cut.Triangles;
  band.Midpoints = cut.Midpoints;
  return band;
}

} // namespace shape
