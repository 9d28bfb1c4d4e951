#pragma once

#include "Base/Progress.h"
#include "Fmm/FmmLatticeOrder.h"
#include "Fmm/InverseDistance.h"
#include "Fmm/Private/FmmTranslation.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace shape
{

/**
 * Boxes of sources and of points on one lattice of halved cubes, and which box sees which how.
 *
 * The root cube holds the sources; a box of sources with more than `leaf` of them is split. Points
 * may lie anywhere: the same lattice goes on outside the root. A box of points is split as long as
 * a box of sources that touches it is. So where a point's value comes from depends on the sources
 * and on this point, not on the other points. The lists are those of H. Cheng, L. Greengard,
 * V. Rokhlin, "A fast adaptive multipole algorithm in three dimensions", J. Comput. Phys. 155,
 * 1999: a box receives from the boxes of its size that do not touch it and whose parents touch its
 * parent (their V list); the sources of the others are near. With this rule of splitting nothing is
 * left for their W list, and X, larger boxes of few sources, counts as near.
 */
class FmmTree
{
public:
  static constexpr int Deepest = FmmLatticeOrder::Halvings;

  struct Box
  {
    int Level = 0;
    std::array<int, 3> Cell = { 0, 0, 0 }; ///< of the lattice of its level, the root at the origin
    int Begin = 0, End = 0;                ///< its sources or points in their order
    int Parent = -1;                       ///< -1: none
    int FirstChild = 0, ChildCount = 0;

    /// The axes along which it is the upper half of its parent, as bits.
    int Octant() const
    {
      return (this->Cell[0] & 1) | (this->Cell[1] & 1) << 1 | (this->Cell[2] & 1) << 2;
    }
  };

  /// Translations of one class, [Begin, End) of Pairs.
  struct Run
  {
    int Offset = 0; ///< |x| y z in base 4
    int Begin = 0, End = 0;
  };

  /// Boxes of points [FirstBox, LastBox) of one level with the runs [FirstRun, LastRun).
  struct Chunk
  {
    int FirstBox = 0, LastBox = 0;
    int FirstRun = 0, LastRun = 0;
  };

  FmmTree(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points, int leaf,
    const Progress& progress);

  /// The centre and half the side of a box, in the scaled coordinates.
  Eigen::RowVector3d Centre(const Box& box) const;
  double HalfEdgeLength(const Box& box) const;

  /// Sources or points in their order, in the scaled coordinates.
  Eigen::MatrixXd Ordered(const Eigen::MatrixXd& positions, const std::vector<int>& order) const;

  double Scale = 1.0; ///< a power of two: scaled coordinates are coordinates times Scale - Shift
  Eigen::RowVector3d Shift = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero(); ///< the lowest corner of the root
  double Side = 1.0;                                      ///< of the root, 1/2 to 1
  std::vector<int> SourceOrder, PointOrder;
  std::vector<Box> SourceBoxes, PointBoxes;   ///< level after level, children side by side
  std::vector<int> SourceLevels, PointLevels; ///< each level's first box, and the end
  std::vector<int> PointLeaves;               ///< boxes of points without children
  std::vector<int> NearStart;                 ///< of each leaf in Near, and the end
  std::vector<SourceSpan> Near;
  int FarPoints = 0;         ///< the first points in their order: too far for the lattice
  std::vector<Chunk> Chunks; ///< level after level
  std::vector<int> ChunkLevels;
  std::vector<Run> Runs;
  std::vector<BoxPair> Pairs;

private:
  /// A box that another one receives from.
  struct Seen
  {
    int Offset = 0, Source = 0, Mirror = 0;
  };
  struct Surroundings;
  void SplitSources(const std::vector<std::uint64_t>& keys, int leaf);
  void SplitPoints(const std::vector<std::uint64_t>& keys, const std::vector<int>& rootStart);
  void AddLeaf(int box, std::vector<int> near);
  void AddChunks(int firstBox, const std::vector<std::vector<Seen>>& seen);
};

} // namespace shape
