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
 * them. Points may lie anywhere: the lattice continues outside the root. A box of points is split
 * as long as a box of sources that touches it is split. So the terms of a point's value depend on
 * the sources and on this point alone, not on other points.
 *
 * The interaction lists are those of H. Cheng, L. Greengard, V. Rokhlin, "A fast adaptive multipole
 * algorithm in three dimensions", J. Comput. Phys. 155, 1999. A box receives the field of the boxes
 * of its size that do not touch it and whose parents touch its parent (V list). Closer sources are
 * summed directly. With this splitting rule the W list is empty. The boxes of the X list, larger
 * boxes with few sources, are treated as near.
 */
class FmmTree
{
public:
  static constexpr int Deepest = FmmLatticeOrder::Halvings;

  struct Box
  {
    int Level = 0;
    /// in the lattice of its level, with the root at the origin
    std::array<int, 3> Cell = { 0, 0, 0 };
    int Begin = 0, End = 0; ///< range of its sources or points in the tree's order
    int Parent = -1;        ///< -1: none
    int FirstChild = 0, ChildCount = 0;

    /// Returns the axes along which it is the upper half of its parent, as bits.
    int Octant() const
    {
      return (this->Cell[0] & 1) | (this->Cell[1] & 1) << 1 | (this->Cell[2] & 1) << 2;
    }
  };

  /// Translations [Begin, End) of Pairs, which share one operator.
  struct Run
  {
    int Offset = 0; ///< |x|, |y|, |z| of target - source in base 4
    int Begin = 0, End = 0;
  };

  /// Boxes of points [FirstBox, LastBox) of one level, with the runs [FirstRun, LastRun).
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

  /// Returns sources or points in the tree's order, in scaled coordinates.
  Eigen::MatrixXd Ordered(const Eigen::MatrixXd& positions, const std::vector<int>& order) const;

  double Scale = 1.0; ///< a power of two; scaled coordinates = coordinates * Scale - Shift
  Eigen::RowVector3d Shift = Eigen::RowVector3d::Zero();
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero(); ///< the lowest corner of the root
  double Side = 1.0;                                      ///< edge length of the root, 1/2 to 1
  std::vector<int> SourceOrder, PointOrder;
  std::vector<Box> SourceBoxes, PointBoxes;   ///< level by level; siblings are contiguous
  std::vector<int> SourceLevels, PointLevels; ///< first box of each level, and the end
  std::vector<int> PointLeaves;               ///< boxes of points without children
  std::vector<int> NearStart;                 ///< first entry of each leaf in Near, and the end
  std::vector<SourceSpan> Near;
  int FarPoints = 0;         ///< number of points, first in the order, outside the lattice's cubes
  std::vector<Chunk> Chunks; ///< level by level
  std::vector<int> ChunkLevels;
  std::vector<Run> Runs;
  std::vector<BoxPair> Pairs;

private:
  /// A box of sources whose field another box receives.
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
