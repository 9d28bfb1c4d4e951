#include "Skeleton/Private/Contraction.h"

#include "Laplacian/CotangentWeights.h"
#include "Linear/SparseSolve.h"
#include "Remesh/EditableSurface.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// The weight of a fixed point's place: cotangent weights are at most a few million.
constexpr double FixedWeight = 1e10;
/// The cosine of the angle beyond which a triangle is flat (section 4 of the paper: 110 degrees).
const double FlatCosine = std::cos(110.0 * M_PI / 180.0);
/// The flow ends if the area changes by less than this share of the first area in an iteration.
constexpr double SteadyShare = 1e-4;
/// It also ends if the area is less than this share of the first area.
constexpr double NoArea = 0.005;
/// After this number of iterations, in which tubes have become thin and fixed, both weights fall by
/// this factor in each further one: the balls would keep apart the sheets of flat parts.
constexpr int ConstantIterations = 8;
constexpr double Fall = 0.75;
/// The smallest factor of the weights.
constexpr double LeastFactor = 1e-3;

using Eigen::Vector3d;

/// One iteration is Flow, Collapse, Split and Fix, in this order.
class Contraction
{
public:
  Contraction(
    const Mesh& surface, const Eigen::MatrixXd& centres, const ContractionOptions& options)
    : Options(options)
    , Edited(surface)
    , Fixed(surface.Points.rows(), false)
  {
    for (const auto& centre : centres.rowwise())
    {
      this->Centres.emplace_back(centre.transpose());
    }
  }

  void LowerWeights() { this->Factor = std::max(LeastFactor, Fall * this->Factor); }

  void Flow(const Progress& progress)
  {
    const EditableSurface::Compacted now = this->Edited.Compact();
    const Mesh& mesh = now.Surface;
    const TriangleAngles angles = ComputeTriangleAngles(mesh);
    Eigen::SparseMatrix<double> system = BuildPositiveStiffness(
      BuildCotangentStiffness(mesh.Triangles, angles.Cotangents, mesh.Points.rows()), 0.0);
    Eigen::MatrixXd right(mesh.Points.rows(), 3);
    std::vector<Vector3d> centres;
    std::vector<bool> fixed;
    for (Eigen::Index i = 0; i < right.rows(); ++i)
    {
      const int point = now.Points[i];
      centres.push_back(this->Centres[point]);
      fixed.push_back(this->Fixed[point]);
      const double stay = fixed.back() ? FixedWeight : this->Factor * this->Options.VelocityWeight;
      const double attract = fixed.back() ? 0.0 : this->Factor * this->Options.MedialWeight;
      system.coeffRef(i, i) += stay + attract;
      right.row(i) = stay * mesh.Points.row(i) + attract * centres.back().transpose();
    }
    SparseCholesky cholesky;
    cholesky.Factorize(system, progress.Part(0.0, 0.8));
    this->Edited =
      EditableSurface({ cholesky.Solve(right, progress.Part(0.8, 1.0)), mesh.Triangles });
    this->Centres = std::move(centres);
    this->Fixed = std::move(fixed);
  }

  void Collapse()
  {
    bool any = true;
    while (any)
    {
      any = false;
      for (const auto& [length, a, b] : this->ShortEdges())
      {
        any = (this->IsShort(a, b) && this->TryCollapse(a, b)) || any;
      }
    }
  }

  /// Splits edges that face two obtuse angles, at the foot of the more obtuse corner.
  void Split()
  {
    for (int t = 0, count = this->Edited.TriangleCount(); t < count; ++t)
    {
      for (int k = 0; k < 3 && this->Edited.Corners(t)[0] >= 0; ++k)
      {
        const int a = this->Edited.Corners(t)[k], b = this->Edited.Corners(t)[(k + 1) % 3];
        if (a<b&& this->Edited.Length(a, b)> 2.0 * this->Options.ShortestEdge)
        {
          this->TrySplit(a, b);
        }
      }
    }
  }

  /// Fixes the corners of short cycles of three edges that bound no triangle.
  void Fix()
  {
    for (const auto& [length, a, b] : this->ShortEdges())
    {
      const std::vector<int> common = this->CommonNeighbours(a, b);
      for (const int c : common)
      {
        if (common.size() > 2 && this->IsShort(a, c) && this->IsShort(b, c) &&
          !this->HasTriangle(a, b, c))
        {
          this->Fixed[a] = this->Fixed[b] = this->Fixed[c] = true;
        }
      }
    }
  }

  double Area() const
  {
    double sum = 0.0;
    for (int t = 0; t < this->Edited.TriangleCount(); ++t)
    {
      const EditableSurface::Triangle& corners = this->Edited.Corners(t);
      sum += corners[0] < 0 ? 0.0 : 0.5 * this->Edited.AreaVector(corners).norm();
    }
    return sum;
  }

  Mesh Result() const { return this->Edited.Compact().Surface; }

private:
  using Edge = std::tuple<double, int, int>; ///< length and both points

  bool IsShort(int a, int b) const
  {
    return this->Edited.Contains(a) && this->Edited.Contains(b) &&
      this->Edited.Length(a, b) < this->Options.ShortestEdge;
  }

  std::vector<Edge> ShortEdges() const
  {
    std::vector<Edge> found;
    for (int t = 0; t < this->Edited.TriangleCount(); ++t)
    {
      const EditableSurface::Triangle& corners = this->Edited.Corners(t);
      for (int k = 0; corners[0] >= 0 && k < 3; ++k)
      {
        const int a = corners[k], b = corners[(k + 1) % 3];
        if (a < b && this->IsShort(a, b))
        {
          found.emplace_back(this->Edited.Length(a, b), a, b);
        }
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  std::vector<int> CommonNeighbours(int a, int b) const
  {
    std::vector<int> ofA, ofB, common;
    this->Edited.FindNeighbours(a, ofA);
    this->Edited.FindNeighbours(b, ofB);
    std::set_intersection(
      ofA.begin(), ofA.end(), ofB.begin(), ofB.end(), std::back_inserter(common));
    return common;
  }

  bool HasTriangle(int a, int b, int c) const
  {
    const std::vector<int> both = this->Edited.TrianglesOf(a, b);
    return std::any_of(both.begin(), both.end(),
      [&](int t) { return EditableSurface::Has(this->Edited.Corners(t), c); });
  }

  bool TryCollapse(int a, int b)
  {
    if (this->Fixed[a] && this->Fixed[b])
    {
      return false;
    }
    const std::vector<int> common = this->CommonNeighbours(a, b);
    // The link condition.
    if (this->Edited.TrianglesOf(a, b).size() != 2 || common.size() != 2 ||
      this->Edited.Around(common[0]).size() <= 3 || this->Edited.Around(common[1]).size() <= 3)
    {
      return false;
    }
    Vector3d place = 0.5 * (this->Edited.Position(a) + this->Edited.Position(b));
    if (this->Fixed[a] || this->Fixed[b])
    {
      place = this->Edited.Position(this->Fixed[a] ? a : b);
    }
    // The new point keeps the nearer centre, as in the paper.
    if ((this->Centres[a] - place).squaredNorm() < (this->Centres[b] - place).squaredNorm())
    {
      this->Centres[b] = this->Centres[a];
    }
    this->Fixed[b] = this->Fixed[a] || this->Fixed[b];
    this->Edited.Collapse(a, b);
    this->Edited.Move(b, place);
    return true;
  }

  double CosineAt(int corner, int a, int b) const
  {
    const Vector3d u = this->Edited.Position(a) - this->Edited.Position(corner),
                   v = this->Edited.Position(b) - this->Edited.Position(corner);
    return u.dot(v) / std::max(u.norm() * v.norm(), 1e-300);
  }

  void TrySplit(int a, int b)
  {
    const std::vector<int> both = this->Edited.TrianglesOf(a, b);
    int c = this->Edited.Opposite(both[0], a, b), d = this->Edited.Opposite(both[1], a, b);
    const double atC = this->CosineAt(c, a, b), atD = this->CosineAt(d, a, b);
    if (atC > FlatCosine || atD > FlatCosine)
    {
      return;
    }
    const Vector3d from = this->Edited.Position(a), edge = this->Edited.Position(b) - from;
    const Vector3d corner = this->Edited.Position(atC < atD ? c : d);
    const double share = std::clamp((corner - from).dot(edge) / edge.squaredNorm(), 0.1, 0.9);
    const int middle = this->Edited.Split(a, b);
    this->Edited.Move(middle, from + share * edge);
    this->Centres.emplace_back((1.0 - share) * this->Centres[a] + share * this->Centres[b]);
    this->Fixed.push_back(this->Fixed[a] && this->Fixed[b]);
  }

  ContractionOptions Options;
  double Factor = 1.0; ///< of both weights
  EditableSurface Edited;
  std::vector<Vector3d> Centres;
  std::vector<bool> Fixed;
};

} // namespace

Mesh ContractSurface(const Mesh& surface, const Eigen::MatrixXd& centres,
  const ContractionOptions& options, const Progress& progress)
{
  Contraction contraction(surface, centres, options);
  const double first = contraction.Area();
  double before = first;
  for (int i = 0; i < options.MaximumIterations; ++i)
  {
    const double count = options.MaximumIterations;
    contraction.Flow(progress.Part(i / count, (i + 0.9) / count));
    contraction.Collapse();
    contraction.Split();
    contraction.Fix();
    const double area = contraction.Area();
    if (area < NoArea * first || std::abs(before - area) < SteadyShare * first)
    {
      break;
    }
    before = area;
    if (i >= ConstantIterations)
    {
      contraction.LowerWeights();
    }
  }
  progress(1.0);
  return contraction.Result();
}

} // namespace shape
