#pragma once

#include "Planar/Private/PlanarTriangles.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Makes segments between the corners of a planar triangulation edges of it, by flips.
class SegmentRecovery
{
public:
  /// plane: changed by Recover; its other edges stay locally Delaunay. addCrossings: whether a
  /// point is added where segments cross. segments: how many there will be.
  SegmentRecovery(PlanarTriangles& plane, bool addCrossings, Eigen::Index segments);

  /// Makes a segment between two points edges; what it runs through splits it. They are marked with
  /// the number of the group of segments that run along them. winding: 1 for an outline, or 0.
  /// Throws InvalidInput where it crosses a marked edge and may not, SolveFailure where crossings,
  /// rounded, cross again without end.
  void Recover(int begin, int end, int segment, int winding);

  /// The segments of a group, in order.
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
  std::vector<Piece> Pieces; ///< that are to be recovered
  std::vector<int> Flipped;  ///< triangles that the last way changed
};

} // namespace shape
