#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Search/TriangleTree.cxx"
// What AVX-512 and SSE4 compile to, these would only repeat.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>

#include "Search/TriangleTree.h"

#include <hwy/highway.h>

#include <array>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace shape
{
// No names without a namespace here: the dispatch below takes addresses from every target.
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

constexpr float SquareRounding = 1e-6F; // eight times that of one operation

/// Sets the bits of the lanes in which `isLow` is true, from bit i.
template <class Tag, class Mask>
std::uint32_t BitsOf(Tag d, Mask isLow, int i)
{
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(d, isLow, bytes.data());
  return (std::uint32_t(bytes[0]) | std::uint32_t(bytes[1]) << 8) << i;
}

/// Computes the distances of a point from 16 balls; negative inside. Returns a bit for each ball:
/// whether its distance is below the bound.
std::uint32_t GapsFor(const float* point, int dimension, const float* centres, const float* radii,
  float bound, float* gaps)
{
  constexpr int size = TriangleBlocks::Size;
  const hn::CappedTag<float, size> d;
  std::uint32_t low = 0;
  for (int i = 0; i < size; i += static_cast<int>(hn::Lanes(d)))
  {
    auto sum = hn::Zero(d);
    for (int k = 0; k < dimension; ++k)
    {
      const auto way = hn::Sub(hn::Set(d, point[k]), hn::LoadU(d, centres + k * size + i));
      sum = hn::MulAdd(way, way, sum);
    }
    const auto gap = hn::Sub(hn::Sqrt(sum), hn::LoadU(d, radii + i));
    hn::StoreU(gap, d, gaps + i);
    low |= BitsOf(d, hn::Lt(gap, hn::Set(d, bound)), i);
  }
  return low;
}

/// Computes the squared distances of a point from the triangles of a block, less the possible
/// rounding error: the minimum over the projection onto the plane, if it is inside, and the nearest
/// points of the three edges. Returns a bit for each triangle: whether it is within the bound.
std::uint32_t SquaresFor(
  const TriangleBlocks& blocks, int block, const float* point, float bound, float* squares)
{
  constexpr int size = TriangleBlocks::Size;
  const hn::CappedTag<float, size> d;
  using Vector = hn::Vec<decltype(d)>;
  const int dimension = blocks.Dimension;
  const std::ptrdiff_t first = std::ptrdiff_t(block) * dimension * size;
  const float* products = blocks.Products.data() + std::ptrdiff_t(block) * 3 * size;
  const Vector zero = hn::Zero(d), one = hn::Set(d, 1.0F), two = hn::Set(d, 2.0F),
               most = hn::Set(d, bound * bound);
  std::uint32_t low = 0;
  for (int i = 0; i < size; i += static_cast<int>(hn::Lanes(d)))
  {
    Vector u = zero, v = zero, square = zero;
    for (int k = 0; k < dimension; ++k)
    {
      const std::ptrdiff_t at = first + k * size + i;
      const Vector w = hn::Sub(hn::Set(d, point[k]), hn::LoadU(d, blocks.Corners.data() + at));
      u = hn::MulAdd(w, hn::LoadU(d, blocks.FirstEdges.data() + at), u);
      v = hn::MulAdd(w, hn::LoadU(d, blocks.SecondEdges.data() + at), v);
      square = hn::MulAdd(w, w, square);
    }
    const Vector a = hn::LoadU(d, products + i), b = hn::LoadU(d, products + size + i),
                 c = hn::LoadU(d, products + 2 * size + i);
    // The difference to the corner's squared distance: s (s a + 2 t b - 2 u) + t (t c - 2 v).
    const auto farther = [&](Vector s, Vector t)
    {
      const Vector inner = hn::MulAdd(s, a, hn::Mul(two, hn::Sub(hn::Mul(t, b), u)));
      return hn::MulAdd(s, inner, hn::Mul(t, hn::NegMulAdd(two, v, hn::Mul(t, c))));
    };
    const auto share = [&](Vector along, Vector length)
    {
      const Vector ratio = hn::Min(hn::Max(hn::Div(along, length), zero), one);
      return hn::IfThenElseZero(hn::Gt(length, zero), ratio);
    };
    const Vector across =
      share(hn::Add(hn::Sub(v, u), hn::Sub(a, b)), hn::Add(hn::NegMulAdd(two, b, a), c));
    Vector minimum = hn::Min(farther(share(u, a), zero), farther(zero, share(v, c)));
    minimum = hn::Min(minimum, farther(hn::Sub(one, across), across));
    const Vector determinant = hn::NegMulAdd(b, b, hn::Mul(a, c));
    const Vector s = hn::Div(hn::NegMulAdd(b, v, hn::Mul(c, u)), determinant),
                 t = hn::Div(hn::NegMulAdd(b, u, hn::Mul(a, v)), determinant);
    // For a triangle without area s and t are not finite, and no comparison is true.
    const auto inside =
      hn::And(hn::And(hn::Ge(s, zero), hn::Ge(t, zero)), hn::Le(hn::Add(s, t), one));
    minimum = hn::IfThenElse(inside, hn::Min(minimum, farther(s, t)), minimum);
    // The possible rounding error: close to a triangle the sum cancels larger numbers.
    const Vector large = hn::Add(square, hn::Add(a, c));
    const Vector sum = hn::NegMulAdd(hn::Set(d, SquareRounding), large, hn::Add(square, minimum));
    const Vector least = hn::Max(zero, sum);
    hn::StoreU(least, d, squares + i);
    low |= BitsOf(d, hn::Le(least, most), i);
  }
  return low;
}

} // namespace HWY_NAMESPACE
} // namespace shape
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "Base/Errors.h"
#include "Search/Private/TriangleProjection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shape
{

HWY_EXPORT(GapsFor);
HWY_EXPORT(SquaresFor);

namespace
{

constexpr int Block = TriangleBlocks::Size;
constexpr int Multiple = 4; // numbers that one instruction may take
constexpr int MaximumDimensions = 64;
using Four = Eigen::Array<double, Multiple, 1>;

/// Returns the maximum error of a distance in single precision for coordinates up to `largest`.
float RoundingOf(double largest, int dimension)
{
  constexpr double roundings = 8.0; // of differences, a sum of squares and a root
  return static_cast<float>(roundings * std::sqrt(static_cast<double>(dimension)) *
    static_cast<double>(std::numeric_limits<float>::epsilon()) * largest);
}

int BlocksOf(int count)
{
  return (count + Block - 1) / Block;
}

} // namespace

TriangleTree::TriangleTree(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points)
  : Triangles(triangles)
  , Dimension((static_cast<int>(points.cols()) + Multiple - 1) / Multiple * Multiple)
  , Order(triangles.rows())
  , Coordinates(points.rows() * this->Dimension, 0.0)
  , Products(triangles.rows(), 3)
{
  RequireOption(
    this->Dimension <= MaximumDimensions, "the dimension", this->Dimension, "at most 64");
  std::iota(this->Order.begin(), this->Order.end(), 0);
  const Eigen::MatrixXd centres = points(triangles.col(0), Eigen::all) +
    points(triangles.col(1), Eigen::all) + points(triangles.col(2), Eigen::all);
  this->Split(0, static_cast<int>(triangles.rows()), centres);
  // The last block is filled with its last triangle.
  this->Order.resize(static_cast<std::size_t>(BlocksOf(static_cast<int>(triangles.rows()))) * Block,
    this->Order.back());
  this->Blocks.Dimension = static_cast<int>(points.cols());
  int items = static_cast<int>(this->Order.size()) / Block;
  const std::size_t numbers = this->Order.size() * this->Blocks.Dimension;
  this->Blocks.Corners.resize(numbers);
  this->Blocks.FirstEdges.resize(numbers);
  this->Blocks.SecondEdges.resize(numbers);
  this->Blocks.Products.resize(this->Order.size() * 3);
  do
  {
    const int blocks = BlocksOf(items);
    const auto positions = static_cast<std::size_t>(blocks) * Block;
    this->Blocks.Levels.push_back({ std::vector<float>(positions * this->Blocks.Dimension, 0.0F),
      std::vector<float>(positions, -std::numeric_limits<float>::infinity()) });
    items = blocks;
  } while (items > 1);
  this->Move(points);
}

void TriangleTree::Split(int first, int count, const Eigen::MatrixXd& centres)
{
  if (count <= Block)
  {
    return;
  }
  // Splits into whole blocks, the first half a power of two, so that balls are around neighbours.
  int half = Block;
  while (2 * half < count)
  {
    half *= 2;
  }
  const auto begin = this->Order.begin() + first, middle = begin + half, end = begin + count;
  const Eigen::MatrixXd own = centres(std::vector<int>(begin, end), Eigen::all);
  Eigen::Index axis = 0;
  (own.colwise().maxCoeff() - own.colwise().minCoeff()).maxCoeff(&axis);
  std::nth_element(
    begin, middle, end, [&](int a, int b) { return centres(a, axis) < centres(b, axis); });
  this->Split(first, half, centres);
  this->Split(first + half, count - half, centres);
}

void TriangleTree::Move(const Eigen::MatrixXd& points)
{
  const int d = this->Dimension;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    for (Eigen::Index k = 0; k < points.cols(); ++k)
    {
      this->Coordinates[i * d + k] = points(i, k);
    }
  }
  this->Blocks.Rounding = RoundingOf(points.cwiseAbs().maxCoeff(), d);
  this->MoveBlocks();
  this->MoveBalls();
}

void TriangleTree::MoveBlocks()
{
  const int d = this->Blocks.Dimension;
  for (std::size_t position = 0; position < this->Order.size(); ++position)
  {
    const int t = this->Order[position];
    std::array<const double*, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = this->Coordinates.data() +
        static_cast<std::ptrdiff_t>(this->Triangles(t, k)) * this->Dimension;
    }
    double a = 0.0, b = 0.0, c = 0.0;
    const std::size_t block = position / Block, lane = position % Block;
    for (int k = 0; k < d; ++k)
    {
      const double p = corners[0][k], e = corners[1][k] - p, f = corners[2][k] - p;
      a += e * e;
      b += e * f;
      c += f * f;
      const std::size_t at = (block * d + k) * Block + lane;
      this->Blocks.Corners[at] = static_cast<float>(p);
      this->Blocks.FirstEdges[at] = static_cast<float>(e);
      this->Blocks.SecondEdges[at] = static_cast<float>(f);
    }
    // The products e.e, e.f and f.f of the edges e and f from the first corner.
    this->Products.row(t) << a, b, c;
    float* products = this->Blocks.Products.data() + block * 3 * Block + lane;
    products[0] = static_cast<float>(a);
    products[Block] = static_cast<float>(b);
    products[2 * Block] = static_cast<float>(c);
  }
}

void TriangleTree::MoveBalls()
{
  const int d = this->Blocks.Dimension;
  using Lanes = Eigen::Array<float, Block, 1>;
  using Numbers = Eigen::Map<const Lanes>;
  const auto put =
    [&](TriangleBlocks::Level& level, std::size_t item, const float* centre, float radius)
  {
    for (int k = 0; k < d; ++k)
    {
      level.Centres[(item / Block * d + k) * Block + item % Block] = centre[k];
    }
    level.Radii[item] = radius + this->Blocks.Rounding;
  };
  std::array<float, MaximumDimensions> centre{};
  const std::size_t blocks = this->Order.size() / Block;
  for (std::size_t block = 0; block < blocks; ++block)
  {
    Lanes first = Lanes::Zero(), second = Lanes::Zero(), third = Lanes::Zero();
    for (int k = 0; k < d; ++k)
    {
      const std::size_t at = (block * d + k) * Block;
      const Numbers p(this->Blocks.Corners.data() + at), e(this->Blocks.FirstEdges.data() + at),
        f(this->Blocks.SecondEdges.data() + at);
      // The mean of the centroids; the radius reaches the farthest corner.
      centre[k] = (p + (e + f) / 3.0F).mean();
      const Lanes way = p - centre[k];
      first += way.square();
      second += (way + e).square();
      third += (way + f).square();
    }
    put(this->Blocks.Levels[0], block, centre.data(),
      std::sqrt(first.max(second).max(third).maxCoeff()));
  }
  for (std::size_t l = 1; l < this->Blocks.Levels.size(); ++l)
  {
    const TriangleBlocks::Level& inner = this->Blocks.Levels[l - 1];
    const std::size_t count = inner.Radii.size() / Block;
    for (std::size_t item = 0; item < count; ++item)
    {
      const Numbers radii(inner.Radii.data() + item * Block);
      // A ball around balls: its radius is the largest sum of a centre's distance and its radius.
      const Lanes there = (radii >= 0.0F).cast<float>();
      Lanes squares = Lanes::Zero();
      for (int k = 0; k < d; ++k)
      {
        const Numbers own(inner.Centres.data() + (item * d + k) * Block);
        centre[k] = (there * own).sum() / there.sum();
        squares += (own - centre[k]).square();
      }
      // An unused ball has a radius below any distance.
      put(this->Blocks.Levels[l], item, centre.data(), (squares.sqrt() + radii).maxCoeff());
    }
  }
}

void TriangleTree::Test(const double* point, int triangle, NearestTriangle& best) const
{
  const int d = this->Dimension;
  const auto corner = [&](int k)
  {
    return this->Coordinates.data() + static_cast<std::ptrdiff_t>(this->Triangles(triangle, k)) * d;
  };
  const double *p = corner(0), *q = corner(1), *r = corner(2);
  Four us = Four::Zero(), vs = Four::Zero(), squares = Four::Zero();
  for (int k = 0; k < d; k += Multiple)
  {
    const Eigen::Map<const Four> at(p + k);
    const Four w = Eigen::Map<const Four>(point + k) - at;
    us += w * (Eigen::Map<const Four>(q + k) - at);
    vs += w * (Eigen::Map<const Four>(r + k) - at);
    squares += w * w;
  }
  const double u = us.sum(), v = vs.sum(), square = squares.sum();
  const double a = this->Products(triangle, 0), b = this->Products(triangle, 1),
               c = this->Products(triangle, 2);
  const auto [s, t] = ProjectOntoTriangle(a, b, c, u, v);
  // |w - s e - t f|^2, expanded by the products.
  const double distance =
    std::max(0.0, square + s * (s * a + 2.0 * t * b - 2.0 * u) + t * (t * c - 2.0 * v));
  if (distance < best.SquaredDistance)
  {
    best.Triangle = triangle;
    best.Barycentric << std::max(0.0, 1.0 - s - t), s, t;
    best.SquaredDistance = distance;
  }
}

// 1. The guess gives an upper bound of the distance.
// 2. Balls are opened depth first, the nearest first, if their lower bound is below it.
// 3. Triangles are compared in single precision, less the possible rounding error, so that none is
//    missed. Candidates are tested in double precision and lower the bound.
NearestTriangle TriangleTree::Find(const Eigen::RowVectorXd& point, int guess) const
{
  std::array<double, MaximumDimensions> padded{};
  std::array<float, MaximumDimensions> single;
  for (Eigen::Index k = 0; k < point.size(); ++k)
  {
    padded[k] = point(k);
    single[k] = static_cast<float>(point(k));
  }
  NearestTriangle best;
  best.SquaredDistance = std::numeric_limits<double>::infinity();
  this->Test(padded.data(), std::max(guess, 0), best);
  const float rounding =
    this->Blocks.Rounding + RoundingOf(point.cwiseAbs().maxCoeff(), this->Dimension);
  const auto within = [&]
  { return static_cast<float>(std::sqrt(best.SquaredDistance)) + rounding; };
  float bound = within();
  struct Waiting
  {
    float Gap;
    int Level, Item;
  };
  constexpr int deepest = 8 * Block; // levels of 16 times as many each
  std::array<Waiting, deepest> stack;
  int height = 0;
  alignas(64) std::array<float, Block> numbers;
  const auto open = [&](int level, int block)
  {
    const TriangleBlocks::Level& own = this->Blocks.Levels[level];
    const std::ptrdiff_t first = std::ptrdiff_t(block) * Block;
    std::uint32_t low = HWY_DYNAMIC_DISPATCH(GapsFor)(single.data(), this->Blocks.Dimension,
      own.Centres.data() + first * this->Blocks.Dimension, own.Radii.data() + first, bound,
      numbers.data());
    const int before = height;
    for (; low != 0; low &= low - 1)
    {
      const auto i = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(low));
      // The nearest is popped first.
      int position = height++;
      for (; position > before && stack[position - 1].Gap < numbers[i]; --position)
      {
        stack[position] = stack[position - 1];
      }
      stack[position] = { numbers[i], level, static_cast<int>(first) + i };
    }
  };
  open(static_cast<int>(this->Blocks.Levels.size()) - 1, 0);
  while (height > 0)
  {
    const Waiting next = stack[--height];
    if (next.Gap >= bound)
    {
      continue;
    }
    if (next.Level > 0)
    {
      open(next.Level - 1, next.Item);
      continue;
    }
    std::uint32_t low = HWY_DYNAMIC_DISPATCH(SquaresFor)(
      this->Blocks, next.Item, single.data(), bound, numbers.data());
    for (; low != 0; low &= low - 1)
    {
      const auto i = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero32(low));
      if (numbers[i] <= bound * bound) // which may have fallen
      {
        this->Test(
          padded.data(), this->Order[static_cast<std::size_t>(next.Item) * Block + i], best);
        bound = within();
      }
    }
  }
  return best;
}

} // namespace shape

#endif // HWY_ONCE
