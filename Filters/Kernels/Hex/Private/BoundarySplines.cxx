#include "Hex/Private/BoundarySplines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace shape
{
namespace
{

/// A side of a block.
struct BlockSide
{
  Eigen::MatrixXi Nodes; ///< along the two other axes, in ascending order
  int Axis, End;         ///< End: 0 is the lower side along the axis, 1 the upper one
};

BlockSide TakeSide(const GridBlock& block, int axis, int end)
{
  const int one = axis == 0 ? 1 : 0, other = axis == 2 ? 1 : 2;
  BlockSide side{ Eigen::MatrixXi(block.Counts(one), block.Counts(other)), axis, end };
  Eigen::RowVector3i at;
  at(axis) = end * (block.Counts(axis) - 1);
  for (at(other) = 0; at(other) < block.Counts(other); ++at(other))
  {
    for (at(one) = 0; at(one) < block.Counts(one); ++at(one))
    {
      side.Nodes(at(one), at(other)) =
        block.Nodes(at(0) + block.Counts(0) * (at(1) + block.Counts(1) * at(2)));
    }
  }
  return side;
}

/// The sides that only one block has. Each side is a side of one other block or lies on the
/// boundary (FindHexGrid).
std::vector<BlockSide> FindOuterSides(const std::vector<GridBlock>& blocks)
{
  std::vector<BlockSide> sides;
  std::map<std::vector<int>, int> uses;
  const auto key = [](const BlockSide& side)
  {
    // The first quad is in one side of each of at most two blocks.
    std::vector<int> quad = { side.Nodes(0, 0), side.Nodes(1, 0), side.Nodes(0, 1),
      side.Nodes(1, 1) };
    std::sort(quad.begin(), quad.end());
    return quad;
  };
  for (const GridBlock& block : blocks)
  {
    for (int side = 0; side < 6; ++side)
    {
      sides.push_back(TakeSide(block, side / 2, side % 2));
      ++uses[key(sides.back())];
    }
  }
  sides.erase(std::remove_if(sides.begin(), sides.end(),
                [&](const BlockSide& side) { return uses[key(side)] > 1; }),
    sides.end());
  return sides;
}

/// Numbers control points. Those of an edge are named by its ends and the node beside the first,
/// and by their place from there.
class ControlNumbers
{
public:
  int Count() const { return static_cast<int>(this->NumberOf.size()); }

  /// Control point (i, j) of `counts` on side number `side`.
  int Find(int side, const Eigen::MatrixXi& nodes, const std::array<int, 2>& counts, int i, int j)
  {
    const bool isEndI = i == 0 || i == counts[0] - 1, isEndJ = j == 0 || j == counts[1] - 1;
    const Eigen::Index row = i == 0 ? 0 : nodes.rows() - 1, column = j == 0 ? 0 : nodes.cols() - 1;
    if (isEndI && isEndJ)
    {
      return this->Number({ -1, nodes(row, column), 0, 0, 0 });
    }
    if (isEndI)
    {
      return this->OnEdge(nodes.row(row).transpose(), counts[1], j);
    }
    if (isEndJ)
    {
      return this->OnEdge(nodes.col(column), counts[0], i);
    }
    return this->Number({ side, i, j, 0, 0 });
  }

private:
  using Name = std::array<int, 5>;

  int Number(const Name& name)
  {
    return this->NumberOf.try_emplace(name, static_cast<int>(this->NumberOf.size())).first->second;
  }

  int OnEdge(const Eigen::VectorXi& nodes, int count, int i)
  {
    const Eigen::Index last = nodes.size() - 1;
    return nodes(0) < nodes(last)
      ? this->Number({ -2, nodes(0), nodes(last), nodes(1), i })
      : this->Number({ -2, nodes(last), nodes(0), nodes(last - 1), count - 1 - i });
  }

  std::map<Name, int> NumberOf;
};

/// Second differences of points (rows) along sides.
Eigen::SparseMatrix<double> ListDifferences(
  const std::vector<BlockSide>& sides, Eigen::Index points)
{
  std::vector<Eigen::Triplet<double>> entries;
  int row = 0;
  // The next point in each direction on sides that face one way: 2 a is down axis a, 2 a + 1 up.
  std::map<std::array<int, 3>, int> next;
  for (const BlockSide& side : sides)
  {
    const int facing = 2 * side.Axis + side.End;
    const std::array<int, 2> axes = { side.Axis == 0 ? 1 : 0, side.Axis == 2 ? 1 : 2 };
    const auto link = [&](int axis, int from, int to)
    {
      next[{ from, 2 * axis + 1, facing }] = to;
      next[{ to, 2 * axis, facing }] = from;
    };
    for (int j = 0; j < static_cast<int>(side.Nodes.cols()); ++j)
    {
      for (int i = 0; i < static_cast<int>(side.Nodes.rows()); ++i)
      {
        if (i > 0)
        {
          link(axes[0], side.Nodes(i - 1, j), side.Nodes(i, j));
        }
        if (j > 0)
        {
          link(axes[1], side.Nodes(i, j - 1), side.Nodes(i, j));
        }
        if (i > 0 && j > 0)
        {
          // The mixed difference counts twice in the energy of a thin plate.
          const double weight = std::sqrt(2.0);
          entries.emplace_back(row, side.Nodes(i, j), weight);
          entries.emplace_back(row, side.Nodes(i - 1, j), -weight);
          entries.emplace_back(row, side.Nodes(i, j - 1), -weight);
          entries.emplace_back(row++, side.Nodes(i - 1, j - 1), weight);
        }
      }
    }
  }
  for (const auto& [key, after] : next)
  {
    const auto [point, direction, facing] = key;
    if (direction % 2 == 0)
    {
      continue;
    }
    if (const auto before = next.find({ point, direction - 1, facing }); before != next.end())
    {
      entries.emplace_back(row, before->second, 1.0);
      entries.emplace_back(row, point, -2.0);
      entries.emplace_back(row++, after, 1.0);
    }
  }
  Eigen::SparseMatrix<double> differences(row, points);
  differences.setFromTriplets(entries.begin(), entries.end());
  return differences;
}

} // namespace

BoundarySplines::BoundarySplines(
  const std::vector<GridBlock>& blocks, Eigen::Index points, const BlockSplineOptions& options)
{
  const std::vector<BlockSide> sides = FindOuterSides(blocks);
  ControlNumbers numbers;
  std::vector<char> isDone(points, 0);
  std::vector<Eigen::Triplet<double>> entries;
  for (int number = 0; number < static_cast<int>(sides.size()); ++number)
  {
    const Eigen::MatrixXi& nodes = sides[number].Nodes;
    const Eigen::MatrixXd along[] = { ComputeNodeBasis(static_cast<int>(nodes.rows()), options),
      ComputeNodeBasis(static_cast<int>(nodes.cols()), options) };
    const std::array<int, 2> counts = { static_cast<int>(along[0].cols()),
      static_cast<int>(along[1].cols()) };
    for (int row = 0; row < static_cast<int>(nodes.rows()); ++row)
    {
      for (int column = 0; column < static_cast<int>(nodes.cols()); ++column)
      {
        if (std::exchange(isDone[nodes(row, column)], 1))
        {
          continue;
        }
        this->Points.push_back(nodes(row, column));
        for (int i = 0; i < counts[0]; ++i)
        {
          for (int j = 0; j < counts[1]; ++j)
          {
            if (const double value = along[0](row, i) * along[1](column, j); value != 0.0)
            {
              entries.emplace_back(
                nodes(row, column), numbers.Find(number, nodes, counts, i, j), value);
            }
          }
        }
      }
    }
  }
  std::sort(this->Points.begin(), this->Points.end());
  this->Basis.resize(points, numbers.Count());
  this->Basis.setFromTriplets(entries.begin(), entries.end());
  this->Differences = ListDifferences(sides, points) * this->Basis;
}

} // namespace shape
