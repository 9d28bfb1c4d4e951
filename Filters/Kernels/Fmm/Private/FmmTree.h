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
 * Boxes of sources and of points on one lattice of recursively halved cubes, and their
 * interactions.
 *
 * The root cube contains the sources. A box of sources is split while it has more than `leaf` of
 * them. Points may lie anywhere: the lattice has one more cube on each side of the root, and points
 * farther out lie in no box (FarPoints). A box of points is split if it touches a split box of
 * sources of the same size. The terms of a point's value therefore depend only on the sources and
 * on this point, not on other points.
 *
 * The interaction lists are those of H. Cheng, L. Greengard, V. Rokhlin, "A fast adaptive multipole
 * algorithm in three dimensions", J. Comput. Phys. 155, 1999. A box receives the field of its V
 * list: the boxes of its size that do not touch it, but whose parents touch its parent. Closer
 * sources are summed directly. With this splitting rule the W list is empty. The X list contains
 * larger boxes with few sources; they are treated as near.
 */
class FmmTree
{
public:
  static constexpr int Deepest = FmmLatticeOrder::Halvings;

  struct Box
  {
    int Level = 0;
    /// its cell in the lattice of its level; the root is at (0, 0, 0)
    std::array<int, 3> Cell = { 0, 0, 0 };
    int Begin = 0, End = 0; ///< the range of its sources or points in the tree's order
    int Parent = -1;        ///< -1: none
    int FirstChild = 0, ChildCount = 0;

    /// Returns a bit for each axis: 1 if the box lies in the upper half of its parent along this
    /// axis.
    int Octant() const
    {
      return (this->Cell[0] & 1) | (this->Cell[1] & 1) << 1 | (this->Cell[2] & 1) << 2;
    }
  };

  /// The translations [Begin, End) of Pairs, which share one operator.
  struct Run
  {
    int Offset = 0; ///< |x|, |y|, |z| of target - source, as the digits of a number in base 4
    int Begin = 0, End = 0;
  };

  /// The point boxes [FirstBox, LastBox), which all have the same level, and the runs [FirstRun,
  /// LastRun) that translate to them.
  struct Chunk
  {
    int FirstBox = 0, LastBox = 0;
    int FirstRun = 0, LastRun = 0;
  };

  FmmTree(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points, int leaf,
    const Progress& progress);

  /// The centre and half the edge length of a box, in scaled coordinates.
  Eigen::RowVector3d Centre(const Box& box) const;
  double HalfEdgeLength(const Box& box) const;

  /// Returns the positions of sources or points in scaled coordinates, in the given order:
  /// SourceOrder or PointOrder.
  Eigen::MatrixXd Ordered(const Eigen::MatrixXd& positions, const std::vector<int>& order) const;

  double Scale = 1.0; ///< a power of two; scaled coordinates = coordinates * Scale - Shift
  Eigen::RowVector3d Shift = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero(); ///< lowest corner of the root
  double Side = 1.0;                                      ///< edge length of the root, 1/2 to 1
  std::vector<int> SourceOrder, PointOrder;
  std::vector<Box> SourceBoxes, PointBoxes;   ///< level by level; siblings are contiguous
  std::vector<int> SourceLevels, PointLevels; ///< first box of each level, and the end
  std::vector<int> PointLeaves;               ///< boxes of points without children
  std::vector<int> NearStart;                 ///< first entry of each leaf in Near, and the end
  std::vector<SourceSpan> Near;
  /// number of points outside the lattice's cubes; they come first in PointOrder
  int FarPoints = 0;
  std::vector<Chunk> Chunks; ///< level by level
  std::vector<int> ChunkLevels;
  std::vector<Run> Runs;
  std::vector<BoxPair> Pairs;

private:
  /// A box of sources whose field a box of points receives.
  struct Seen
  {
    int Offset = 0, Source = 0, Mirror = 0;
  };
  struct Surroundings;
  void SplitSources(const std::vector<std::uint64_t>& keys, int leaf);
  void SplitPoints(const std::vector<std::uint64_t>& keys, const std::vector<int>& rootStart,
    const Progress& progress);
  void AddLeaf(int box, std::vector<int> near);
  void AddChunks(int firstBox, const std::vector<std::vector<Seen>>& seen);
};

} // namespace shape
