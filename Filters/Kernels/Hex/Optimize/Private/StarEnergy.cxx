#include "Hex/Optimize/Private/StarEnergy.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace shape
{
namespace
{

using Eigen::Vector3d;

/// For each corner of a hexahedron and each two of its neighbours, the corner beside both.
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

/// The edges of a corner and what they come to.
struct CornerEdges
{
  CornerEdges(const Vector3d& a, const Vector3d& b, const Vector3d& c, double minimum)
    : A(a)
    , B(b)
    , C(c)
    , Normal(b.cross(c))
    , Minimum(a.dot(this->Normal) < 0.0 ? 0.0 : minimum)
    , Lengths(std::sqrt(this->Square(a) * this->Square(b) * this->Square(c)))
    , Scaled(a.dot(this->Normal) / this->Lengths)
  {
  }

  double Square(const Vector3d& edge) const { return edge.squaredNorm() + this->Minimum; }

  /// The derivative of the scaled determinant by the first edge.
  Vector3d Slope() const { return this->Normal / this->Lengths - this->Along(this->A); }
  /// Minus that by all three: by the place of the corner itself.
  Vector3d SlopeAtCorner() const
  {
    return this->Along(this->A) + this->Along(this->B) + this->Along(this->C) -
      (this->Normal + this->C.cross(this->A) + this->A.cross(this->B)) / this->Lengths;
  }
  Vector3d Along(const Vector3d& edge) const { return this->Scaled / this->Square(edge) * edge; }

  Vector3d A, B, C, Normal;
  double Minimum, Lengths, Scaled;
};

void Add(const CornerEdges& edges, const Vector3d& slope, double inverseSquares, double sharpness,
  StarEnergy::Expansion& sum)
{
  const double term = std::exp(sharpness * (1.0 - edges.Scaled));
  sum.Value += term;
  sum.Gradient -= sharpness * term * slope;
  sum.Curvature.noalias() += sharpness * sharpness * term * slope * slope.transpose();
  // Of the second derivative of s: near a right corner it is -1 / length^2 across the edge.
  constexpr double share = 0.7, minimum = 0.1;
  sum.Curvature.diagonal().array() +=
    sharpness * term * share * std::max(minimum, edges.Scaled) * inverseSquares;
}

} // namespace

StarEnergy::StarEnergy(const Eigen::Matrix3Xd& points, const Corners& hexahedra,
  const Eigen::VectorXd& leastSquares, const std::vector<std::array<int, 2>>& around)
{
  this->Views.reserve(around.size());
  for (const auto& [hex, corner] : around)
  {
    View& view = this->Views.emplace_back();
    for (int k = 0; k < 3; ++k)
    {
      view.Ends[k] = points.col(hexahedra(hex, HexNeighbours[corner][k]));
      view.Across[k] = points.col(hexahedra(hex, shape::Across[corner][k]));
    }
    view.MinimumSquare = leastSquares(hex);
  }
}

Eigen::VectorXd StarEnergy::MinimumSquares(const HexMesh& mesh)
{
  constexpr double share = 0.05;
  Eigen::VectorXd squares(mesh.Hexahedra.rows());
  for (Eigen::Index hex = 0; hex < squares.size(); ++hex)
  {
    const double minimum = share * ComputeMeanEdgeLength(mesh, hex);
    squares(hex) = std::max(minimum * minimum, std::numeric_limits<double>::min());
  }
  return squares;
}

double StarEnergy::Value(const Vector3d& x, double sharpness) const
{
  double sum = 0.0;
  for (const View& view : this->Views)
  {
    const CornerEdges own(view.Ends[0] - x, view.Ends[1] - x, view.Ends[2] - x, view.MinimumSquare);
    sum += std::exp(sharpness * (1.0 - own.Scaled));
    for (int k = 0; k < 3; ++k)
    {
      const Vector3d& end = view.Ends[k];
      const CornerEdges beside(x - end, view.Across[(k + 1) % 3] - end,
        view.Across[(k + 2) % 3] - end, view.MinimumSquare);
      sum += std::exp(sharpness * (1.0 - beside.Scaled));
    }
  }
  return sum;
}

StarEnergy::Expansion StarEnergy::Expand(const Vector3d& x, double sharpness) const
{
  Expansion sum;
  for (const View& view : this->Views)
  {
    const CornerEdges own(view.Ends[0] - x, view.Ends[1] - x, view.Ends[2] - x, view.MinimumSquare);
    Add(own, own.SlopeAtCorner(),
      1.0 / own.Square(own.A) + 1.0 / own.Square(own.B) + 1.0 / own.Square(own.C), sharpness, sum);
    for (int k = 0; k < 3; ++k)
    {
      const Vector3d& end = view.Ends[k];
      const CornerEdges beside(x - end, view.Across[(k + 1) % 3] - end,
        view.Across[(k + 2) % 3] - end, view.MinimumSquare);
      Add(beside, beside.Slope(), 1.0 / beside.Square(beside.A), sharpness, sum);
    }
  }
  return sum;
}

double StarEnergy::Reach(const Vector3d& x) const
{
  double squared = 0.0;
  for (const View& view : this->Views)
  {
    for (const Vector3d& end : view.Ends)
    {
      squared = std::max(squared, (end - x).squaredNorm());
    }
  }
  return std::sqrt(squared);
}

} // namespace shape
