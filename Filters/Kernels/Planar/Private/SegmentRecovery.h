#pragma once

#include "Planar/Private/PlanarTriangles.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Flips edges of a planar triangulation until given segments between its corners are edges.
class SegmentRecovery
{
public:
  /// plane: the triangulation, which Recover changes; edges that are not marked stay locally
  /// Delaunay. addCrossings: whether a point is added where segments cross. segments: the number of
  /// segments that will be recovered.
  SegmentRecovery(PlanarTriangles& plane, bool addCrossings, Eigen::Index segments);

  /// Flips edges until a segment between two points is a sequence of edges; points on the segment
  /// split it. Each of these edges is marked with the number of the group of segments that contain
  /// it. winding: 1 for an outline, else 0. Throws InvalidInput if the segment crosses a marked
  /// edge and addCrossings is false. Throws SolveFailure if rounded crossings cause new crossings
  /// without end.
  void Recover(int begin, int end, int segment, int winding);

  /// Returns the segments of a group, ascending.
  const std::vector<int>& Group(int mark) const { return this->Groups[mark]; }

private:
  struct Piece
  {
    int Begin, End;
    PlanarTriangles::SegmentMark Mark;
  };

  bool IsAhead(int a, int b, int c) const;
  int Advance(int from, const Piece& piece);
  int Cross(int from, const Piece& piece, int ahead);
  int OpenWay(int from, int to, int ahead);
  int CutOff(int back, int before);
  void AddMark(int side, const PlanarTriangles::SegmentMark& mark);
  void AddCrossing(int from, const Piece& piece, int side);

  PlanarTriangles& Plane;
  bool AddsCrossings;
  double MaximumPointCount;
  std::vector<std::vector<int>> Groups;
  std::vector<Piece> Pieces; ///< pieces still to be recovered
  std::vector<int> Flipped;  ///< triangles changed by the last OpenWay
};

} // namespace shape
