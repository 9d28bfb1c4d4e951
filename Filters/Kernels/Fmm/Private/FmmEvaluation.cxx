#include "Fmm/Private/FmmEvaluation.h"

#include "Base/Parallel.h"
#include "Fmm/Private/OpenCLSum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace shape
{

namespace
{

/// Number of boxes that share one product; small enough to keep all threads busy.
constexpr int Boxes = 16;
/// Number of points in a chunk that needs no boxes.
constexpr int Grain = 1024;

template <typename Real>
void Set(FmmTranslation<Real>& product, const typename FmmOperators<Real>::Operator& matrix)
{
  product.Matrix = matrix.Entries.data();
  product.Rows = matrix.Rows;
  product.Inner = matrix.Columns;
  product.Extents = matrix.Extents.data();
}

template <typename Real>
std::vector<BoxPair> Diagonal(int count)
{
  std::vector<BoxPair> pairs(count);
  for (int i = 0; i < count; ++i)
  {
    pairs[i] = { i, i, 0 };
  }
  return pairs;
}

} // namespace

/// The data of one sum.
template <typename Real>
struct FmmEvaluation<Real>::Workspace
{
  int Columns = 0;
  bool Gradients = false;
  Eigen::MatrixXd Packed; ///< x y z and the charges of each source
  std::vector<Real> Outgoing, Incoming;
  Eigen::MatrixXd Values; ///< in the order of the tree
};

template <typename Real>
FmmEvaluation<Real>::FmmEvaluation(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points,
  const FmmEffort& effort, const Progress& progress)
  : Effort(effort)
  , Operators(effort.Boxes, progress.Part(0.0, 0.5))
  , Tree(sources, points, effort.Leaf, progress.Part(0.5, 1.0))
  , Sources(this->Tree.Ordered(sources, this->Tree.SourceOrder).transpose())
  , Points(this->Tree.Ordered(points, this->Tree.PointOrder))
{
  for (std::size_t box = 0; box < this->Tree.SourceBoxes.size(); ++box)
  {
    if (this->Tree.SourceBoxes[box].ChildCount == 0)
    {
      this->SourceLeaves.push_back(static_cast<int>(box));
    }
  }
  for (std::size_t leaf = 0; leaf < this->Tree.PointLeaves.size(); ++leaf)
  {
    const FmmTree::Box& box = this->Tree.PointBoxes[this->Tree.PointLeaves[leaf]];
    double near = 0.0;
    for (int span = this->Tree.NearStart[leaf]; span < this->Tree.NearStart[leaf + 1]; ++span)
    {
      near += this->Tree.Near[span].End - this->Tree.Near[span].Begin;
    }
    this->NearPairs += near * (box.End - box.Begin);
  }
}

template <typename Real>
Eigen::MatrixXd FmmEvaluation<Real>::Sum(const Eigen::MatrixXd& charges, bool gradients,
  const SumDevice& device, const Progress& progress) const
{
  // Outline (the passes of Ying, Biros and Zorin 2004):
  // 1. Charges are sorted as the tree's sources and scaled by 1 / (4 pi).
  // 2. Upward pass (Collect): from charges to the outgoing coefficients of leaves, and from
  //    children to parents.
  // 3. Downward pass (Translate): from the outgoing coefficients of the V list to incoming
  //    coefficients, and from parents to children.
  // 4. Evaluation: incoming coefficients at the points of each leaf, and near sources directly. An
  //    OpenCL device sums the near sources first.
  // 5. The values are sorted as the given points.
  Workspace work;
  work.Columns = static_cast<int>(charges.cols());
  work.Gradients = gradients;
  // Back from the tree's coordinates: 1 / r takes the scale as a factor, its gradient the square.
  const double factor =
    0.25 / M_PI * (gradients ? this->Tree.Scale * this->Tree.Scale : this->Tree.Scale);
  work.Packed.resize(3 + work.Columns, charges.rows());
  work.Packed.topRows(3) = this->Sources;
  for (Eigen::Index j = 0; j < charges.rows(); ++j)
  {
    work.Packed.col(j).tail(work.Columns) =
      factor * charges.row(this->Tree.SourceOrder[j]).transpose();
  }
  const Eigen::Index values = gradients ? 3 * work.Columns : work.Columns;
  work.Values = Eigen::MatrixXd::Zero(this->Points.rows(), values);
  const std::size_t perBox = static_cast<std::size_t>(work.Columns) * this->Operators.Stride;
  work.Outgoing.assign(this->Tree.SourceBoxes.size() * perBox, Real(0));
  work.Incoming.assign(this->Tree.PointBoxes.size() * perBox, Real(0));
  const bool nearIsSet = ChooseOpenCL(device, this->NearPairs) &&
    this->SetNearOnDevice(work, device, progress.Part(0.0, 0.3));
  const Progress left = nearIsSet ? progress.Part(0.3, 1.0) : progress;
  this->Collect(work, left.Part(0.0, 0.15));
  this->Translate(work, left.Part(0.15, 0.35));
  this->Evaluate(work, nearIsSet, left.Part(0.35, 1.0));

  // Step 5: back to the given order.
  Eigen::MatrixXd result(this->Points.rows(), values);
  for (Eigen::Index c = 0; c < values; ++c)
  {
    for (Eigen::Index i = 0; i < result.rows(); ++i)
    {
      result(this->Tree.PointOrder[i], c) = work.Values(i, c);
    }
  }
  return result;
}

template <typename Real>
Eigen::MatrixXd FmmEvaluation<Real>::Around(
  const FmmTree::Box& box, const Eigen::MatrixXd& cube) const
{
  return (this->Tree.HalfEdgeLength(box) * cube).rowwise() + this->Tree.Centre(box);
}

template <typename Real>
void FmmEvaluation<Real>::Collect(Workspace& work, const Progress& progress) const
{
  // Leaves: the potentials of their charges on the outer cube give the outgoing coefficients, c =
  // Expansion^T potentials. Each product serves a group of leaves.
  const int columns = work.Columns;
  const int points = static_cast<int>(this->Operators.OuterPoints.rows());
  const int pointStride = static_cast<int>(this->Operators.Expansion.rows());
  const int stride = this->Operators.Stride;
  const std::vector<BoxPair> diagonal = Diagonal<Real>(Boxes);
  ParallelFor(
    static_cast<int>(this->SourceLeaves.size()), Boxes,
    [&](int begin, int end)
    {
      Eigen::MatrixXd potentials = Eigen::MatrixXd::Zero(pointStride, Boxes * columns);
      Eigen::MatrixXd numbers = Eigen::MatrixXd::Zero(stride, Boxes * columns);
      for (int leaf = begin; leaf < end; ++leaf)
      {
        const FmmTree::Box& box = this->Tree.SourceBoxes[this->SourceLeaves[leaf]];
        const Eigen::MatrixXd cube = this->Around(box, this->Operators.OuterPoints);
        const SourceSpan span{ box.Begin, box.End };
        InverseDistanceSum sum;
        sum.Sources = work.Packed.data();
        sum.Columns = columns;
        sum.Spans = &span;
        sum.SpanCount = 1;
        sum.Points = cube.data();
        sum.PointStride = sum.PointCount = points;
        auto to = potentials.middleCols((leaf - begin) * columns, columns);
        sum.Values = to.data();
        sum.ValueStride = pointStride;
        sum.Error = this->Effort.BoxError;
        AddPotentials(sum);
        // The operators are in units of half the box's edge, in which 1 / r takes it as a factor.
        to *= this->Tree.HalfEdgeLength(box);
      }
      FmmTranslation<double> product;
      product.Matrix = this->Operators.Collected.data();
      product.RowStride = stride;
      product.Rows = this->Operators.Modes;
      product.Inner = points;
      product.Columns = columns;
      product.In = potentials.data();
      product.InStride = pointStride;
      product.Out = numbers.data();
      product.OutStride = stride;
      AddProducts(product, diagonal.data(), end - begin);
      for (int leaf = begin; leaf < end; ++leaf)
      {
        std::copy_n(numbers.data() + (leaf - begin) * columns * stride, columns * stride,
          work.Outgoing.data() + std::size_t(columns) * stride * this->SourceLeaves[leaf]);
      }
    },
    progress);

  // Levels, the deepest first: a parent adds the translated coefficients of its children. One
  // mirrored operator serves all eight children.
  FmmTranslation<Real> up;
  Set(up, this->Operators.FromChild);
  up.Signs = this->Operators.Signs.data();
  up.Columns = columns;
  up.RowStride = up.SignStride = up.InStride = up.OutStride = stride;
  up.In = up.Out = work.Outgoing.data();
  for (std::size_t level = this->Tree.SourceLevels.size() - 1; level-- > 0;)
  {
    const int first = this->Tree.SourceLevels[level];
    ParallelFor(this->Tree.SourceLevels[level + 1] - first, Boxes,
      [&](int begin, int end)
      {
        std::vector<BoxPair> pairs;
        for (int box = first + begin; box < first + end; ++box)
        {
          const FmmTree::Box& parent = this->Tree.SourceBoxes[box];
          for (int i = parent.FirstChild; i < parent.FirstChild + parent.ChildCount; ++i)
          {
            // FromChild belongs to the child at (-, -, -); the others mirror it.
            pairs.push_back({ box, i, this->Tree.SourceBoxes[i].Octant() });
          }
        }
        AddProducts(up, pairs.data(), static_cast<std::ptrdiff_t>(pairs.size()));
      });
  }
}

template <typename Real>
void FmmEvaluation<Real>::Translate(Workspace& work, const Progress& progress) const
{
  // Levels from the root down. A box first receives the incoming coefficients of its parent, which
  // are complete, then those of its V list. A chunk is written by one thread only.
  FmmTranslation<Real> over;
  over.Signs = this->Operators.Signs.data();
  over.Columns = work.Columns;
  over.RowStride = over.SignStride = over.InStride = over.OutStride = this->Operators.Stride;
  over.In = work.Outgoing.data();
  over.Out = work.Incoming.data();
  FmmTranslation<Real> down = over;
  Set(down, this->Operators.ToChild);
  down.In = work.Incoming.data();
  const auto chunks = static_cast<double>(this->Tree.Chunks.size());
  for (std::size_t level = 0; level + 1 < this->Tree.ChunkLevels.size(); ++level)
  {
    const int first = this->Tree.ChunkLevels[level], last = this->Tree.ChunkLevels[level + 1];
    ParallelFor(
      last - first, 1,
      [&](int begin, int end)
      {
        for (int at = first + begin; at < first + end; ++at)
        {
          const FmmTree::Chunk& chunk = this->Tree.Chunks[at];
          std::vector<BoxPair> pairs;
          for (int box = chunk.FirstBox; box < chunk.LastBox; ++box)
          {
            const FmmTree::Box& child = this->Tree.PointBoxes[box];
            if (child.Parent >= 0)
            {
              pairs.push_back({ box, child.Parent, child.Octant() });
            }
          }
          AddProducts(down, pairs.data(), static_cast<std::ptrdiff_t>(pairs.size()));
          for (int run = chunk.FirstRun; run < chunk.LastRun; ++run)
          {
            const FmmTree::Run& same = this->Tree.Runs[run];
            FmmTranslation<Real> product = over;
            Set(product, this->Operators.Over[same.Offset]);
            AddProducts(product, this->Tree.Pairs.data() + same.Begin, same.End - same.Begin);
          }
        }
      },
      progress.Part(first / chunks, last / chunks));
  }
}

template <typename Real>
void FmmEvaluation<Real>::EvaluateCharges(Workspace& work, const Eigen::MatrixXd& positions,
  const double* charges, int stride, int begin, int end) const
{
  // The charges on a cube are summed as sources.
  Eigen::MatrixXd packed(3 + work.Columns, positions.rows());
  packed.topRows(3) = positions.transpose();
  for (int c = 0; c < work.Columns; ++c)
  {
    packed.row(3 + c) =
      Eigen::Map<const Eigen::RowVectorXd>(charges + std::ptrdiff_t(c) * stride, positions.rows());
  }
  const SourceSpan span{ 0, static_cast<int>(positions.rows()) };
  InverseDistanceSum sum;
  sum.Sources = packed.data();
  sum.Columns = work.Columns;
  sum.Spans = &span;
  sum.SpanCount = 1;
  sum.Points = this->Points.data() + begin;
  sum.PointStride = sum.ValueStride = this->Points.rows();
  sum.PointCount = end - begin;
  sum.Values = work.Values.data() + begin;
  sum.Error = this->Effort.BoxError;
  work.Gradients ? AddGradients(sum) : AddPotentials(sum);
}

template <typename Real>
bool FmmEvaluation<Real>::SetNearOnDevice(
  Workspace& work, const SumDevice& device, const Progress& progress) const
{
  OpenCLSum sum{ work.Packed, this->Points, work.Gradients };
  sum.Spans.assign(this->Tree.Near.begin(), this->Tree.Near.end());
  for (std::size_t leaf = 0; leaf < this->Tree.PointLeaves.size(); ++leaf)
  {
    const FmmTree::Box& box = this->Tree.PointBoxes[this->Tree.PointLeaves[leaf]];
    sum.AddBlocks(box.Begin, box.End, this->Tree.NearStart[leaf], this->Tree.NearStart[leaf + 1]);
  }
  // A point has few near sources: one pass.
  sum.Pass = std::numeric_limits<int>::max();
  std::optional<Eigen::MatrixXd> sums = SumByOpenCL(sum, device, progress);
  if (sums)
  {
    work.Values = std::move(*sums);
  }
  return sums.has_value();
}

template <typename Real>
void FmmEvaluation<Real>::AddNear(Workspace& work, int leaf) const
{
  const FmmTree::Box& box = this->Tree.PointBoxes[this->Tree.PointLeaves[leaf]];
  InverseDistanceSum sum;
  sum.Sources = work.Packed.data();
  sum.Columns = work.Columns;
  sum.Spans = this->Tree.Near.data() + this->Tree.NearStart[leaf];
  sum.SpanCount = this->Tree.NearStart[leaf + 1] - this->Tree.NearStart[leaf];
  sum.Points = this->Points.data() + box.Begin;
  sum.PointStride = sum.ValueStride = this->Points.rows();
  sum.PointCount = box.End - box.Begin;
  sum.Values = work.Values.data() + box.Begin;
  sum.Error = this->Effort.NearError;
  work.Gradients ? AddGradients(sum) : AddPotentials(sum);
}

template <typename Real>
void FmmEvaluation<Real>::Evaluate(Workspace& work, bool nearIsSet, const Progress& progress) const
{
  // The lattice's cubes fill the root's outer cube. Points beyond them receive the field of the
  // equivalent charges on the root's inner cube.
  const int columns = work.Columns;
  const int stride = this->Operators.Stride;
  const auto pointStride = static_cast<int>(this->Operators.Expansion.rows());
  const std::vector<BoxPair> diagonal = Diagonal<Real>(Boxes);
  FmmTranslation<double> product;
  product.RowStride = product.OutStride = pointStride;
  product.Rows = pointStride;
  product.Inner = this->Operators.Modes;
  product.Columns = columns;
  product.InStride = stride;

  if (this->Tree.FarPoints > 0)
  {
    Eigen::MatrixXd numbers = Eigen::MatrixXd::Zero(stride, columns);
    const auto rootStride = static_cast<int>(this->Operators.Inner.rows());
    Eigen::MatrixXd charges = Eigen::MatrixXd::Zero(rootStride, columns);
    std::copy_n(work.Outgoing.data(), columns * stride, numbers.data());
    FmmTranslation<double> root = product;
    root.RowStride = root.OutStride = root.Rows = rootStride;
    root.Matrix = this->Operators.Inner.data();
    root.In = numbers.data();
    root.Out = charges.data();
    AddProducts(root, diagonal.data(), 1);
    const Eigen::MatrixXd cube =
      this->Around(this->Tree.SourceBoxes[0], this->Operators.InnerPoints);
    ParallelFor(
      this->Tree.FarPoints, Grain,
      [&](int begin, int end)
      { this->EvaluateCharges(work, cube, charges.data(), rootStride, begin, end); },
      progress.Part(0.0, 0.1));
  }

  // In a leaf the incoming coefficients give charges on the outer cube with the same field in the
  // box.
  product.Matrix = this->Operators.Expansion.data();
  ParallelFor(
    static_cast<int>(this->Tree.PointLeaves.size()), Boxes,
    [&](int begin, int end)
    {
      Eigen::MatrixXd numbers(stride, Boxes * columns);
      Eigen::MatrixXd charges = Eigen::MatrixXd::Zero(pointStride, Boxes * columns);
      for (int leaf = begin; leaf < end; ++leaf)
      {
        std::copy_n(
          work.Incoming.data() + std::size_t(columns) * stride * this->Tree.PointLeaves[leaf],
          columns * stride, numbers.data() + (leaf - begin) * columns * stride);
      }
      FmmTranslation<double> expand = product;
      expand.In = numbers.data();
      expand.Out = charges.data();
      AddProducts(expand, diagonal.data(), end - begin);
      for (int leaf = begin; leaf < end; ++leaf)
      {
        const FmmTree::Box& box = this->Tree.PointBoxes[this->Tree.PointLeaves[leaf]];
        // A box of level 0 touches the root, so it has no V list and no parent.
        if (box.Level > 0)
        {
          this->EvaluateCharges(work, this->Around(box, this->Operators.OuterPoints),
            charges.data() + (leaf - begin) * columns * pointStride, pointStride, box.Begin,
            box.End);
        }
        if (!nearIsSet)
        {
          this->AddNear(work, leaf);
        }
      }
    },
    progress.Part(this->Tree.FarPoints > 0 ? 0.1 : 0.0, 1.0));
}

template class FmmEvaluation<float>;
template class FmmEvaluation<double>;

} // namespace shape
