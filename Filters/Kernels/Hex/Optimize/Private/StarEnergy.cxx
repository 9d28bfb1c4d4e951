#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Hex/Optimize/Private/StarEnergy.cxx"
// These would only repeat what AVX-512 and SSE4 compile to.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>

#include "Hex/Optimize/Private/StarEnergy.h"

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shape
{
// No names without a namespace here: the dispatch below takes addresses from every target.
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Not more, so that AVX2 and AVX-512 give the same bits: sweeps amplify the last ones.
using Tag = hn::CappedTag<double, 4>;
using Lanes = hn::Vec<Tag>;

/// A vector in each lane.
struct Vector
{
  Lanes X, Y, Z;

  HWY_ATTR Lanes Dot(const Vector& other) const
  {
    return hn::MulAdd(this->X, other.X, hn::MulAdd(this->Y, other.Y, hn::Mul(this->Z, other.Z)));
  }
  HWY_ATTR Vector Cross(const Vector& other) const
  {
    return { hn::MulSub(this->Y, other.Z, hn::Mul(this->Z, other.Y)),
      hn::MulSub(this->Z, other.X, hn::Mul(this->X, other.Z)),
      hn::MulSub(this->X, other.Y, hn::Mul(this->Y, other.X)) };
  }
  HWY_ATTR Vector Plus(const Vector& other) const
  {
    return { hn::Add(this->X, other.X), hn::Add(this->Y, other.Y), hn::Add(this->Z, other.Z) };
  }
  HWY_ATTR Vector Minus(const Vector& other) const
  {
    return { hn::Sub(this->X, other.X), hn::Sub(this->Y, other.Y), hn::Sub(this->Z, other.Z) };
  }
  HWY_ATTR Vector Times(Lanes factor) const
  {
    return { hn::Mul(this->X, factor), hn::Mul(this->Y, factor), hn::Mul(this->Z, factor) };
  }
};

HWY_ATTR inline Vector Load(const StarBlock::Vectors& vectors, int k, int i)
{
  const Tag d;
  return { hn::LoadU(d, &vectors[k][0][i]), hn::LoadU(d, &vectors[k][1][i]),
    hn::LoadU(d, &vectors[k][2][i]) };
}

HWY_ATTR inline Vector Load(const double* x)
{
  const Tag d;
  return { hn::Set(d, x[0]), hn::Set(d, x[1]), hn::Set(d, x[2]) };
}

/// Computes what does not depend on the position of the point.
void PrepareFor(StarBlock* blocks, int count)
{
  const Tag d;
  for (StarBlock* block = blocks; block != blocks + count; ++block)
  {
    for (int i = 0; i < StarBlock::Size; i += static_cast<int>(hn::Lanes(d)))
    {
      const Lanes minimum = hn::LoadU(d, &block->MinimumSquares[i]);
      for (int k = 0; k < 3; ++k)
      {
        const Vector end = Load(block->Ends, k, i);
        const Vector one = Load(block->Across, (k + 1) % 3, i).Minus(end),
                     other = Load(block->Across, (k + 2) % 3, i).Minus(end);
        const Vector normal = other.Cross(one);
        hn::StoreU(normal.X, d, &block->Normals[k][0][i]);
        hn::StoreU(normal.Y, d, &block->Normals[k][1][i]);
        hn::StoreU(normal.Z, d, &block->Normals[k][2][i]);
        const Lanes first = one.Dot(one), second = other.Dot(other);
        hn::StoreU(hn::Mul(first, second), d, &block->Squares[k][i]);
        hn::StoreU(hn::Mul(hn::Add(first, minimum), hn::Add(second, minimum)), d,
          &block->LongerSquares[k][i]);
      }
    }
  }
}

/// What the corners of hexahedra around a position have in common.
struct StarLanes
{
  Vector Edges[3]; ///< from the position
  Lanes Minimum, Weight;
};

HWY_ATTR inline StarLanes LoadStar(const StarBlock& block, int i, const Vector& position)
{
  const Tag d;
  return { { Load(block.Ends, 0, i).Minus(position), Load(block.Ends, 1, i).Minus(position),
             Load(block.Ends, 2, i).Minus(position) },
    hn::LoadU(d, &block.MinimumSquares[i]), hn::LoadU(d, &block.Weights[i]) };
}

/// The corner that is the point: its edges, and the quantities derived from them.
struct OwnCorner
{
  HWY_ATTR OwnCorner(const Vector (&edges)[3], Lanes minimum)
    : Normal(edges[1].Cross(edges[2]))
  {
    const Tag d;
    const Lanes determinant = edges[0].Dot(this->Normal);
    const Lanes added = hn::IfThenZeroElse(hn::Lt(determinant, hn::Zero(d)), minimum);
    for (int k = 0; k < 3; ++k)
    {
      this->Squares[k] = hn::Add(edges[k].Dot(edges[k]), added);
    }
    this->Lengths =
      hn::Sqrt(hn::Mul(this->Squares[0], hn::Mul(this->Squares[1], this->Squares[2])));
    this->Scaled = hn::Div(determinant, this->Lengths);
  }

  Vector Normal;
  Lanes Squares[3], Lengths, Scaled;
};

/// The corner at the end of edge k: the same, as functions of this edge.
struct EndCorner
{
  HWY_ATTR EndCorner(const StarBlock& block, int k, int i, const Vector& edge, Lanes minimum)
    : Normal(Load(block.Normals, k, i))
  {
    const Tag d;
    const Lanes determinant = edge.Dot(this->Normal);
    const auto negative = hn::Lt(determinant, hn::Zero(d));
    this->Square = hn::Add(edge.Dot(edge), hn::IfThenZeroElse(negative, minimum));
    const Lanes others = hn::IfThenElse(
      negative, hn::LoadU(d, &block.Squares[k][i]), hn::LoadU(d, &block.LongerSquares[k][i]));
    this->Lengths = hn::Sqrt(hn::Mul(this->Square, others));
    this->Scaled = hn::Div(determinant, this->Lengths);
  }

  Vector Normal;
  Lanes Square, Lengths, Scaled;
};

/// exp(sharpness (1 - s)), or 0 in unused entries.
HWY_ATTR inline Lanes Term(Lanes scaled, Lanes sharpness, Lanes weight)
{
  const Tag d;
  return hn::Mul(weight, hn::Exp(d, hn::NegMulAdd(sharpness, scaled, sharpness)));
}

double ValueFor(const StarBlock* blocks, int count, const double* x, double sharpness)
{
  const Tag d;
  const Vector position = Load(x);
  const Lanes sharp = hn::Set(d, sharpness);
  Lanes sum = hn::Zero(d);
  for (const StarBlock* block = blocks; count > 0; ++block, count -= StarBlock::Size)
  {
    for (int i = 0; i < StarBlock::Size && i < count; i += static_cast<int>(hn::Lanes(d)))
    {
      const auto [edges, minimum, weight] = LoadStar(*block, i, position);
      sum = hn::Add(sum, Term(OwnCorner(edges, minimum).Scaled, sharp, weight));
      for (int k = 0; k < 3; ++k)
      {
        sum = hn::Add(sum, Term(EndCorner(*block, k, i, edges[k], minimum).Scaled, sharp, weight));
      }
    }
  }
  return hn::GetLane(hn::SumOfLanes(d, sum));
}

/// The sums of an expansion, in each lane.
struct ExpansionSums
{
  HWY_ATTR explicit ExpansionSums(double sharpness)
    : Sharpness(hn::Set(Tag(), sharpness))
  {
    this->Value = this->Diagonal = hn::Zero(Tag());
    this->Gradient = { this->Value, this->Value, this->Value };
    for (Lanes& entry : this->Curvature)
    {
      entry = this->Value;
    }
  }

  /// Adds a corner. slope: the derivative of s. inverseSquares: the sum of 1 / length^2 of the
  /// edges that end at x.
  HWY_ATTR void Add(Lanes scaled, const Vector& slope, Lanes inverseSquares, Lanes weight)
  {
    const Tag d;
    const Lanes term = Term(scaled, this->Sharpness, weight);
    // With t = exp(k (1 - s)): t' = -k t s', and t'' = k^2 t s' s'^T - k t s''.
    const Lanes first = hn::Mul(this->Sharpness, term), second = hn::Mul(this->Sharpness, first);
    this->Value = hn::Add(this->Value, term);
    this->Gradient = this->Gradient.Minus(slope.Times(first));
    const Vector scaledSlope = slope.Times(second);
    this->Curvature[0] = hn::MulAdd(scaledSlope.X, slope.X, this->Curvature[0]);
    this->Curvature[1] = hn::MulAdd(scaledSlope.Y, slope.Y, this->Curvature[1]);
    this->Curvature[2] = hn::MulAdd(scaledSlope.Z, slope.Z, this->Curvature[2]);
    this->Curvature[3] = hn::MulAdd(scaledSlope.X, slope.Y, this->Curvature[3]);
    this->Curvature[4] = hn::MulAdd(scaledSlope.X, slope.Z, this->Curvature[4]);
    this->Curvature[5] = hn::MulAdd(scaledSlope.Y, slope.Z, this->Curvature[5]);
    // For the second derivative of s: near a right angle it is -1 / length^2 across the edge.
    constexpr double share = 0.7, minimum = 0.1;
    const Lanes bent = hn::Mul(hn::Set(d, share), hn::Max(hn::Set(d, minimum), scaled));
    this->Diagonal = hn::MulAdd(hn::Mul(first, bent), inverseSquares, this->Diagonal);
  }

  const Lanes Sharpness;
  Lanes Value, Diagonal, Curvature[6];
  Vector Gradient;
};

void ExpandFor(const StarBlock* blocks, int count, const double* x, double sharpness,
  StarEnergy::Expansion& expansion)
{
  const Tag d;
  const Vector position = Load(x);
  const Lanes one = hn::Set(d, 1.0);
  ExpansionSums sums(sharpness);
  Lanes longest = hn::Zero(d);
  for (const StarBlock* block = blocks; count > 0; ++block, count -= StarBlock::Size)
  {
    for (int i = 0; i < StarBlock::Size && i < count; i += static_cast<int>(hn::Lanes(d)))
    {
      const auto [edges, minimum, weight] = LoadStar(*block, i, position);
      const OwnCorner own(edges, minimum);
      const Vector normals =
        own.Normal.Plus(edges[2].Cross(edges[0])).Plus(edges[0].Cross(edges[1]));
      Vector slope = normals.Times(hn::Neg(hn::Div(one, own.Lengths)));
      Lanes inverses = hn::Zero(d);
      for (int k = 0; k < 3; ++k)
      {
        const Lanes inverse = hn::Div(one, own.Squares[k]);
        slope = slope.Plus(edges[k].Times(hn::Mul(own.Scaled, inverse)));
        inverses = hn::Add(inverses, inverse);
        longest = hn::Max(longest, edges[k].Dot(edges[k]));
      }
      sums.Add(own.Scaled, slope, inverses, weight);
      for (int k = 0; k < 3; ++k)
      {
        const EndCorner end(*block, k, i, edges[k], minimum);
        const Lanes inverse = hn::Div(one, end.Square);
        sums.Add(end.Scaled,
          edges[k]
            .Times(hn::Mul(end.Scaled, inverse))
            .Minus(end.Normal.Times(hn::Div(one, end.Lengths))),
          inverse, weight);
      }
    }
  }
  const auto total = [&](Lanes lanes) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, lanes)); };
  expansion.Value = total(sums.Value);
  expansion.Gradient << total(sums.Gradient.X), total(sums.Gradient.Y), total(sums.Gradient.Z);
  const double xy = total(sums.Curvature[3]), xz = total(sums.Curvature[4]),
               yz = total(sums.Curvature[5]);
  expansion.Curvature << total(sums.Curvature[0]), xy, xz, //
    xy, total(sums.Curvature[1]), yz,                      //
    xz, yz, total(sums.Curvature[2]);
  expansion.Curvature.diagonal().array() += total(sums.Diagonal);
  expansion.Reach = hn::GetLane(hn::Sqrt(hn::MaxOfLanes(d, longest)));
}

} // namespace HWY_NAMESPACE
} // namespace shape
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <limits>

namespace shape
{

HWY_EXPORT(PrepareFor);
HWY_EXPORT(ValueFor);
HWY_EXPORT(ExpandFor);

namespace
{

/// For each corner of a hexahedron and each two of its neighbours, the corner adjacent to both.
constexpr std::array<std::array<int, 3>, 8> CornersAcross()
{
  std::array<std::array<int, 3>, 8> across{};
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int* one = HexNeighbours[HexNeighbours[corner][(k + 1) % 3]];
      const int* other = HexNeighbours[HexNeighbours[corner][(k + 2) % 3]];
      for (int i = 0; i < 9; ++i)
      {
        if (one[i / 3] == other[i % 3] && one[i / 3] != corner)
        {
          across[corner][k] = one[i / 3];
        }
      }
    }
  }
  return across;
}

constexpr auto Across = CornersAcross();

} // namespace

StarEnergy::StarEnergy(const Eigen::Matrix3Xd& points, const Corners& hexahedra,
  const Eigen::VectorXd& leastSquares, const std::vector<std::array<int, 2>>& around)
  : Count(static_cast<int>(around.size()))
  , Blocks((around.size() + StarBlock::Size - 1) / StarBlock::Size, boost::container::default_init)
{
  const int used = this->Count;
  for (int entry = 0; entry < static_cast<int>(this->Blocks.size()) * StarBlock::Size; ++entry)
  {
    StarBlock& block = this->Blocks[entry / StarBlock::Size];
    const int i = entry % StarBlock::Size;
    const auto& [hex, corner] = around[std::min(entry, used - 1)];
    const auto put = [&](StarBlock::Vectors& vectors, int k, int at)
    {
      const double* point = points.col(hexahedra(hex, at)).data();
      for (int c = 0; c < 3; ++c)
      {
        vectors[k][c][i] = point[c];
      }
    };
    for (int k = 0; k < 3; ++k)
    {
      put(block.Ends, k, HexNeighbours[corner][k]);
      put(block.Across, k, shape::Across[corner][k]);
    }
    block.MinimumSquares[i] = leastSquares(hex);
    block.Weights[i] = entry < used ? 1.0 : 0.0;
  }
  HWY_DYNAMIC_DISPATCH(PrepareFor)(this->Blocks.data(), static_cast<int>(this->Blocks.size()));
}

Eigen::VectorXd StarEnergy::MinimumSquares(const HexMesh& mesh)
{
  constexpr double share = 0.05;
  Eigen::VectorXd squares(mesh.Hexahedra.rows());
  for (Eigen::Index hex = 0; hex < squares.size(); ++hex)
  {
    const double minimum = share * ComputeMeanEdgeLength(mesh, hex);
    // Positive even for a hexahedron without extent, because lengths are denominators.
    squares(hex) = std::max(minimum * minimum, std::numeric_limits<double>::min());
  }
  return squares;
}

double StarEnergy::Value(const Eigen::Vector3d& x, double sharpness) const
{
  return HWY_DYNAMIC_DISPATCH(ValueFor)(this->Blocks.data(), this->Count, x.data(), sharpness);
}

StarEnergy::Expansion StarEnergy::Expand(const Eigen::Vector3d& x, double sharpness) const
{
  Expansion expansion;
  HWY_DYNAMIC_DISPATCH(ExpandFor)
  (this->Blocks.data(), this->Count, x.data(), sharpness, expansion);
  return expansion;
}

} // namespace shape

#endif // HWY_ONCE
