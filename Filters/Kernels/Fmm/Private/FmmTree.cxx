#include "Fmm/Private/FmmTree.h"

#include "Fmm/FmmLatticeOrder.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace shape
{

namespace
{

/// Number of boxes of points whose translations are grouped by operator.
constexpr int ChunkBoxes = 64;

/// Returns the indices where the keys of [begin, end), all in one box of `level`, change octant.
std::array<int, 9> Octants(const std::vector<std::uint64_t>& keys, int begin, int end, int level)
{
  const int shift = 3 * (FmmLatticeOrder::Halvings - 1 - level);
  std::array<int, 9> start{};
  start[0] = begin;
  for (std::uint64_t octant = 0; octant < 8; ++octant)
  {
    start[octant + 1] =
      static_cast<int>(std::partition_point(keys.begin() + start[octant], keys.begin() + end,
                         [&](std::uint64_t key) { return (key >> shift & 7) <= octant; }) -
        keys.begin());
  }
  return start;
}

/// Splits box `at` of the list into its octants that are not empty.
void AppendChildren(
  std::vector<FmmTree::Box>& boxes, int at, const std::vector<std::uint64_t>& keys)
{
  const FmmTree::Box box = boxes[at];
  const std::array<int, 9> start = Octants(keys, box.Begin, box.End, box.Level);
  boxes[at].FirstChild = static_cast<int>(boxes.size());
  for (int octant = 0; octant < 8; ++octant)
  {
    if (start[octant] < start[octant + 1])
    {
      FmmTree::Box child;
      child.Level = box.Level + 1;
      for (int c = 0; c < 3; ++c)
      {
        child.Cell[c] = 2 * box.Cell[c] + (octant >> c & 1);
      }
      child.Begin = start[octant];
      child.End = start[octant + 1];
      child.Parent = at;
      boxes.push_back(child);
    }
  }
  boxes[at].ChildCount = static_cast<int>(boxes.size()) - boxes[at].FirstChild;
}

bool Touch(const FmmTree::Box& a, const FmmTree::Box& b)
{
  return std::abs(a.Cell[0] - b.Cell[0]) <= 1 && std::abs(a.Cell[1] - b.Cell[1]) <= 1 &&
    std::abs(a.Cell[2] - b.Cell[2]) <= 1;
}

} // namespace

/// The sources around a box of points.
struct FmmTree::Surroundings
{
  std::vector<int> Touching; ///< boxes of sources of the same size that touch it
  std::vector<int> Larger;   ///< leaves of sources that touch one of its ancestors
};

FmmTree::FmmTree(
  const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points, int leaf, const Progress& progress)
{
  // Outline:
  // 1. The root cube of the sources, in coordinates scaled to about one.
  // 2. Sources in Morton order; boxes with more than `leaf` of them are split.
  // 3. Points in the same order; their boxes are split, and the interaction lists follow.
  const Eigen::RowVector3d low = sources.colwise().minCoeff();
  const Eigen::RowVector3d high = sources.colwise().maxCoeff();
  const double largest = std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff());
  // The root needs an extent even if all sources coincide. A small one would scale far points to
  // distances whose squares single precision cannot hold (InverseDistanceSum).
  const double spread = (high - low).maxCoeff();
  const double extent = std::max({ spread > 0.0 ? spread : largest, 1e-9 * largest, 1e-280 });
  this->Scale = std::ldexp(1.0, -1 - std::ilogb(extent));
  this->Side = this->Scale * extent;
  const Eigen::RowVector3d middle = this->Scale * 0.5 * (low + high);
  // If coordinates are much larger than the extent, they have no digits left for the smallest
  // boxes. Subtracting the centre is exact, because both have about the same size.
  constexpr double distant = 8.0;
  this->Shift = largest > distant * extent ? middle : Eigen::RowVector3d::Zero().eval();
  this->Origin = (middle - this->Shift).array() - 0.5 * this->Side;

  // Step 2: boxes of sources.
  const Lattice lattice{ this->Origin, this->Side };
  const auto scaled = [&](const Eigen::MatrixXd& positions)
  { return ((this->Scale * positions).rowwise() - this->Shift).eval(); };
  FmmLatticeOrder order = OrderOnLattice(scaled(sources), lattice);
  this->SourceOrder = std::move(order.Ids);
  this->SplitSources(order.Keys, leaf);
  progress(0.25);
  // Step 3: boxes of points.
  order = OrderOnLattice(scaled(points), lattice);
  this->PointOrder = std::move(order.Ids);
  progress(0.5);
  this->FarPoints = order.RootStart[0];
  this->SplitPoints(order.Keys, order.RootStart, progress.Part(0.5, 1.0));
  progress(1.0);
}

Eigen::MatrixXd FmmTree::Ordered(
  const Eigen::MatrixXd& positions, const std::vector<int>& order) const
{
  Eigen::MatrixXd ordered(positions.rows(), 3);
  for (int c = 0; c < 3; ++c)
  {
    for (Eigen::Index i = 0; i < positions.rows(); ++i)
    {
      ordered(i, c) = this->Scale * positions(order[i], c) - this->Shift[c];
    }
  }
  return ordered;
}

Eigen::RowVector3d FmmTree::Centre(const Box& box) const
{
  Eigen::RowVector3d centre;
  for (int c = 0; c < 3; ++c)
  {
    centre[c] = this->Origin[c] + this->Side * std::ldexp(box.Cell[c] + 0.5, -box.Level);
  }
  return centre;
}

double FmmTree::HalfEdgeLength(const Box& box) const
{
  return std::ldexp(this->Side, -1 - box.Level);
}

void FmmTree::SplitSources(const std::vector<std::uint64_t>& keys, int leaf)
{
  Box root;
  root.End = static_cast<int>(keys.size());
  this->SourceBoxes = { root };
  this->SourceLevels = { 0, 1 };
  // The list grows while it is visited: children follow all boxes of their parents' level.
  for (int box = 0; box < static_cast<int>(this->SourceBoxes.size()); ++box)
  {
    if (box == this->SourceLevels.back())
    {
      this->SourceLevels.push_back(static_cast<int>(this->SourceBoxes.size()));
    }
    const Box& at = this->SourceBoxes[box];
    if (at.End - at.Begin > leaf && at.Level < Deepest)
    {
      AppendChildren(this->SourceBoxes, box, keys);
    }
  }
}

void FmmTree::SplitPoints(const std::vector<std::uint64_t>& keys, const std::vector<int>& rootStart,
  const Progress& progress)
{
  // Level by level, each box of points knows the boxes of sources of its size that touch it, and
  // the larger leaves that touch its ancestors:
  // 1. If no box that touches it is split, it is a leaf; all these sources are near.
  // 2. Otherwise its children inherit the larger leaves, and the children of the boxes that touch
  //    it either touch a child or belong to the child's V list.
  std::vector<Surroundings> around;
  for (int root = 0; root < FmmLatticeOrder::Roots; ++root)
  {
    if (rootStart[root] < rootStart[root + 1])
    {
      Box box;
      box.Cell = { root / 9 - 1, root / 3 % 3 - 1, root % 3 - 1 };
      box.Begin = rootStart[root];
      box.End = rootStart[root + 1];
      this->PointBoxes.push_back(box);
      around.push_back({ { 0 }, {} });
    }
  }
  this->PointLevels = { 0 };
  this->ChunkLevels = { 0 };
  int first = 0;
  double pointsInLeaves = this->FarPoints;
  std::vector<std::vector<Seen>> seen(around.size());
  while (first < static_cast<int>(this->PointBoxes.size()))
  {
    this->AddChunks(first, seen);
    const auto last = static_cast<int>(this->PointBoxes.size());
    this->PointLevels.push_back(last);
    this->ChunkLevels.push_back(static_cast<int>(this->Chunks.size()));
    seen.clear();
    std::vector<Surroundings> next;
    for (int at = first; at < last; ++at)
    {
      constexpr int boxesBetweenReports = 256;
      if (at % boxesBetweenReports == 0)
      {
        progress(pointsInLeaves / static_cast<double>(keys.size()));
      }
      Surroundings& here = around[at - first];
      std::vector<int> split;
      for (const int box : here.Touching)
      {
        (this->SourceBoxes[box].ChildCount > 0 ? split : here.Larger).push_back(box);
      }
      // Step 1: a leaf.
      if (split.empty())
      {
        pointsInLeaves += this->PointBoxes[at].End - this->PointBoxes[at].Begin;
        this->AddLeaf(at, std::move(here.Larger));
        continue;
      }
      // Step 2: children.
      AppendChildren(this->PointBoxes, at, keys);
      const Box parent = this->PointBoxes[at];
      for (int child = parent.FirstChild; child < parent.FirstChild + parent.ChildCount; ++child)
      {
        const Box& target = this->PointBoxes[child];
        Surroundings inner;
        inner.Larger = here.Larger;
        std::vector<Seen> from;
        for (const int box : split)
        {
          const int end = this->SourceBoxes[box].FirstChild + this->SourceBoxes[box].ChildCount;
          for (int source = this->SourceBoxes[box].FirstChild; source < end; ++source)
          {
            const Box& other = this->SourceBoxes[source];
            if (Touch(target, other))
            {
              inner.Touching.push_back(source);
              continue;
            }
            // The operator depends on the absolute offset; signs mirror it.
            Seen away{ 0, source, 0 };
            for (int c = 0; c < 3; ++c)
            {
              const int offset = target.Cell[c] - other.Cell[c];
              away.Offset = 4 * away.Offset + std::abs(offset);
              away.Mirror |= offset < 0 ? 1 << c : 0;
            }
            from.push_back(away);
          }
        }
        next.push_back(std::move(inner));
        seen.push_back(std::move(from));
      }
    }
    around.swap(next);
    first = last;
  }
  this->NearStart.push_back(static_cast<int>(this->Near.size()));
}

void FmmTree::AddLeaf(int box, std::vector<int> near)
{
  this->PointLeaves.push_back(box);
  this->NearStart.push_back(static_cast<int>(this->Near.size()));
  std::sort(near.begin(), near.end(),
    [&](int a, int b) { return this->SourceBoxes[a].Begin < this->SourceBoxes[b].Begin; });
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    const Box& from = this->SourceBoxes[near[i]];
    // Ranges that are contiguous in the order become one.
    if (i > 0 && this->Near.back().End == from.Begin)
    {
      this->Near.back().End = from.End;
    }
    else
    {
      this->Near.push_back({ from.Begin, from.End });
    }
  }
}

void FmmTree::AddChunks(int firstBox, const std::vector<std::vector<Seen>>& seen)
{
  const auto count = static_cast<int>(seen.size());
  for (int first = 0; first < count; first += ChunkBoxes)
  {
    const int last = std::min(first + ChunkBoxes, count);
    Chunk chunk;
    chunk.FirstBox = firstBox + first;
    chunk.LastBox = firstBox + last;
    chunk.FirstRun = static_cast<int>(this->Runs.size());
    // A counting sort by offset: translations with the same operator follow each other, so the
    // operator stays in the cache.
    std::array<int, 65> start{};
    for (int box = first; box < last; ++box)
    {
      for (const Seen& from : seen[box])
      {
        ++start[from.Offset + 1];
      }
    }
    const auto before = static_cast<int>(this->Pairs.size());
    for (int offset = 0; offset < 64; ++offset)
    {
      start[offset + 1] += start[offset];
      if (start[offset] < start[offset + 1])
      {
        this->Runs.push_back({ offset, before + start[offset], before + start[offset + 1] });
      }
    }
    this->Pairs.resize(before + start[64]);
    for (int box = first; box < last; ++box)
    {
      for (const Seen& from : seen[box])
      {
        this->Pairs[before + start[from.Offset]++] = { firstBox + box, from.Source, from.Mirror };
      }
    }
    chunk.LastRun = static_cast<int>(this->Runs.size());
    this->Chunks.push_back(chunk);
  }
}

} // namespace shape
