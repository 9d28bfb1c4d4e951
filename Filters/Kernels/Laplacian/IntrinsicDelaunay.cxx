#include "Laplacian/IntrinsicDelaunay.h"

#include "Base/Errors.h"
#include "Laplacian/Private/TuftedCover.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shape
{
namespace
{

/// Minimum excess of the sum of two edges over the third, relative to the mean edge.
constexpr double DelaunaySlack = 1e-6;
/// An edge weight below 0 by less than this is accepted, so rounding cannot flip an edge
/// repeatedly.
constexpr double MinimumWeight = -1e-9;
constexpr int None = -1;

/// Flips edges by lengths alone. Half-edge 3 t + k runs from corner k of triangle t to the next.
class Flipper
{
public:
  Flipper(const GluedTriangles& glued, const Eigen::MatrixXd& points)
    : Begins(glued.Triangles.size())
    , Twins(glued.Twins)
    , Lengths(glued.Triangles.size())
  {
    const Eigen::MatrixXi& triangles = glued.Triangles;
    for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const std::size_t side = 3 * t + k;
        this->Begins[side] = triangles(t, k);
        this->Lengths[side] =
          (points.row(triangles(t, (k + 1) % 3)) - points.row(triangles(t, k))).norm();
      }
    }
    this->Mollify();
  }

  void FlipAll()
  {
    // Sharp and Crane 2020, section 3.1: as long as an edge is not Delaunay, it is flipped. A flip
    // can make only the four edges around it non-Delaunay.
    std::vector<int> queue;
    std::vector<char> waits(this->Begins.size(), 1);
    for (int side = static_cast<int>(this->Begins.size()) - 1; side >= 0; --side)
    {
      queue.push_back(side);
    }
    // Far more flips than any known surface needs.
    std::size_t left = 1000 * this->Begins.size() + 1000;
    while (!queue.empty())
    {
      const int side = queue.back();
      queue.pop_back();
      waits[side] = 0;
      if (!this->IsFlippable(side) || this->Weight(side) >= MinimumWeight)
      {
        continue;
      }
      if (left-- == 0)
      {
        throw SolveFailure("the edge flips of the intrinsic Delaunay triangulation do not end; "
                           "remesh the surface");
      }
      const int twin = this->Twins[side];
      this->Flip(side);
      for (const int near :
        { NextHalfEdge(side), PreviousHalfEdge(side), NextHalfEdge(twin), PreviousHalfEdge(twin) })
      {
        if (!waits[near])
        {
          waits[near] = 1;
          queue.push_back(near);
        }
      }
    }
  }

  IntrinsicTriangles Triangles() const
  {
    const Eigen::Index count = static_cast<Eigen::Index>(this->Begins.size()) / 3;
    IntrinsicTriangles result{ Eigen::MatrixXi(count, 3), Eigen::MatrixXd(count, 3) };
    for (Eigen::Index t = 0; t < count; ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        result.Triangles(t, k) = this->Begins[3 * t + k];
        result.Sides(t, k) = this->Lengths[3 * t + (k + 1) % 3];
      }
    }
    return result;
  }

private:
  void Mollify()
  {
    double sum = 0.0;
    for (const double length : this->Lengths)
    {
      sum += length;
    }
    // Sharp and Crane 2020, section 4.5: one raise for all edges, so lengths of shared edges stay
    // equal.
    const double slack = DelaunaySlack * sum / static_cast<double>(this->Lengths.size());
    double raise = 0.0;
    for (std::size_t t = 0; t < this->Lengths.size(); t += 3)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double excess =
          this->Lengths[t + (k + 1) % 3] + this->Lengths[t + (k + 2) % 3] - this->Lengths[t + k];
        raise = std::max(raise, slack - excess);
      }
    }
    for (double& length : this->Lengths)
    {
      length += raise;
    }
  }

  /// False on the boundary, and if a triangle is glued to itself there, because two angles of one
  /// triangle add up to less than pi.
  bool IsFlippable(int side) const
  {
    const int twin = this->Twins[side];
    return twin != None && twin / 3 != side / 3;
  }

  /// Returns the cosine of the angle at the start of a half-edge, between it and the previous one.
  double Cosine(int side) const
  {
    const double a = this->Lengths[side], b = this->Lengths[PreviousHalfEdge(side)],
                 c = this->Lengths[NextHalfEdge(side)];
    return std::clamp((a * a + (b - c) * (b + c)) / (2.0 * a * b), -1.0, 1.0);
  }

  double Cotangent(int side) const
  {
    const double cosine = this->Cosine(PreviousHalfEdge(side));
    // The bound keeps a degenerate triangle's cotangent finite.
    return cosine / std::sqrt(std::max(1.0 - cosine * cosine, 1e-24));
  }

  /// Returns the weight of the edge: the mean of the cotangents of the two opposite angles.
  double Weight(int side) const
  {
    return 0.5 * (this->Cotangent(side) + this->Cotangent(this->Twins[side]));
  }

  /// Replaces an edge by the other diagonal of its two triangles.
  ///
  ///          c                     c            side: a -> b, twin: b -> a
  ///        /   \                 / | \          becomes d -> c and c -> d, opposite a and b
  ///       a --- b      ->       a  |  b
  ///        \   /                 \ | /
  ///          d                     d
  void Flip(int side)
  {
    const int twin = this->Twins[side];
    const int bc = NextHalfEdge(side), ca = PreviousHalfEdge(side), ad = NextHalfEdge(twin),
              db = PreviousHalfEdge(twin);
    // The new edge joins c and d. Its length follows from the law of cosines at a, where both
    // angles add up: cos(x + y) = cos x cos y - sin x sin y.
    const double cosine = this->Cosine(side), other = this->Cosine(ad);
    const double sines = std::sqrt((1.0 - cosine * cosine) * (1.0 - other * other));
    const double ac = this->Lengths[ca], length = this->Lengths[ad];
    const double across = std::sqrt(
      std::max(ac * ac + length * length - 2.0 * ac * length * (cosine * other - sines), 0.0));
    const int a = this->Begins[side], b = this->Begins[twin], c = this->Begins[ca],
              d = this->Begins[db];
    const std::array<int, 4> outside = { this->Twins[bc], this->Twins[ca], this->Twins[ad],
      this->Twins[db] };
    const std::array<double, 4> lengths = { this->Lengths[bc], this->Lengths[ca], this->Lengths[ad],
      this->Lengths[db] };
    // The triangle of `side` becomes d -> c, c -> a, a -> d; that of `twin` c -> d, d -> b, b -> c.
    const std::array<int, 4> positions = { PreviousHalfEdge(twin), NextHalfEdge(side),
      PreviousHalfEdge(side), NextHalfEdge(twin) };
    const std::array<int, 4> begins = { b, c, a, d };
    this->Begins[side] = d;
    this->Begins[twin] = c;
    this->Lengths[side] = this->Lengths[twin] = across;
    const std::array<int, 4> before = { bc, ca, ad, db };
    for (int i = 0; i < 4; ++i)
    {
      this->Begins[positions[i]] = begins[i];
      this->Lengths[positions[i]] = lengths[i];
    }
    for (int i = 0; i < 4; ++i)
    {
      // Half-edges of the two triangles may be glued to each other.
      const auto own = std::find(before.begin(), before.end(), outside[i]);
      const int twinOf = own == before.end() ? outside[i] : positions[own - before.begin()];
      this->Twins[positions[i]] = twinOf;
      if (twinOf != None)
      {
        this->Twins[twinOf] = positions[i];
      }
    }
  }

  std::vector<int> Begins; ///< start point of each half-edge
  std::vector<int> Twins;  ///< opposite half-edge of each half-edge
  std::vector<double> Lengths;
};

} // namespace

IntrinsicTriangles BuildIntrinsicDelaunay(const Surface& surface)
{
  const bool isManifold = AreEdgesManifold(surface.HalfEdges());
  Flipper flipper(
    isManifold ? GluedTriangles{ surface.Triangles(), surface.Twins() } : BuildTuftedCover(surface),
    surface.Points());
  flipper.FlipAll();
  return flipper.Triangles();
}

std::shared_ptr<const IntrinsicLaplacian> GetIntrinsicLaplacian(const Surface& surface)
{
  return surface.Cached<IntrinsicLaplacian>(
    [&]()
    {
      const Eigen::Index points = surface.Points().rows();
      IntrinsicLaplacian laplacian;
      laplacian.Flat = BuildIntrinsicDelaunay(surface);
      laplacian.Angles = ComputeAnglesFromLengths(laplacian.Flat.Sides);
      const Eigen::MatrixXi& triangles = laplacian.Flat.Triangles;
      laplacian.Copies = triangles.rows() == surface.Triangles().rows() ? 1 : 2;
      laplacian.Stiffness =
        BuildCotangentStiffness(triangles, laplacian.Angles.Cotangents, points) / laplacian.Copies;
      laplacian.Masses =
        ComputeLumpedMasses(triangles, laplacian.Angles.Areas, points) / laplacian.Copies;
      return laplacian;
    });
}

} // namespace shape
