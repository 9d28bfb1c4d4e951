#include "Correspondence/TriangleTree.h"

#include "Correspondence/PlaceInTriangle.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace shape
{
namespace
{

constexpr int Leaf = 4;     // triangles
constexpr int Multiple = 4; // numbers that one instruction may take

} // namespace

TriangleTree::TriangleTree(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points)
  : Triangles(triangles)
  , Dimension((static_cast<int>(points.cols()) + Multiple - 1) / Multiple * Multiple)
  , Order(triangles.rows())
  , Coordinates(points.rows() * this->Dimension, 0.0)
  , Products(triangles.rows(), 3)
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  const Eigen::MatrixXd centres = points(triangles.col(0), Eigen::all) +
    points(triangles.col(1), Eigen::all) + points(triangles.col(2), Eigen::all);
  this->Split(0, static_cast<int>(triangles.rows()), centres);
  this->Lower.resize(this->Nodes.size() * this->Dimension);
  this->Upper.resize(this->Nodes.size() * this->Dimension);
  this->Move(points);
}

void TriangleTree::Split(int first, int count, const Eigen::MatrixXd& centres)
{
  const std::size_t node = this->Nodes.size();
  this->Nodes.push_back({ first, count, -1 });
  if (count <= Leaf)
  {
    return;
  }
  const auto begin = this->Order.begin() + first, middle = begin + count / 2, end = begin + count;
  const Eigen::MatrixXd own = centres(std::vector<int>(begin, end), Eigen::all);
  Eigen::Index axis = 0;
  (own.colwise().maxCoeff() - own.colwise().minCoeff()).maxCoeff(&axis);
  std::nth_element(
    begin, middle, end, [&](int a, int b) { return centres(a, axis) < centres(b, axis); });
  this->Split(first, count / 2, centres);
  this->Nodes[node].Right = static_cast<int>(this->Nodes.size());
  this->Split(first + count / 2, count - count / 2, centres);
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
  const auto corner = [&](int triangle, int k)
  {
    return this->Coordinates.data() + static_cast<std::ptrdiff_t>(this->Triangles(triangle, k)) * d;
  };
  for (int t = 0; t < static_cast<int>(this->Triangles.rows()); ++t)
  {
    const double *p = corner(t, 0), *q = corner(t, 1), *r = corner(t, 2);
    double a = 0.0, b = 0.0, c = 0.0;
    for (int k = 0; k < d; ++k)
    {
      const double e = q[k] - p[k], f = r[k] - p[k];
      a += e * e;
      b += e * f;
      c += f * f;
    }
    this->Products.row(t) << a, b, c;
  }
  // Children come after their parents.
  for (int node = static_cast<int>(this->Nodes.size()) - 1; node >= 0; --node)
  {
    double *lower = this->Lower.data() + static_cast<std::ptrdiff_t>(node) * d,
           *upper = this->Upper.data() + static_cast<std::ptrdiff_t>(node) * d;
    std::fill_n(lower, d, std::numeric_limits<double>::infinity());
    std::fill_n(upper, d, -std::numeric_limits<double>::infinity());
    const auto include = [&](const double* low, const double* high)
    {
      for (int k = 0; k < d; ++k)
      {
        lower[k] = std::min(lower[k], low[k]);
        upper[k] = std::max(upper[k], high[k]);
      }
    };
    const Node& own = this->Nodes[node];
    if (own.Right < 0)
    {
      for (int i = own.First; i < own.First + own.Count; ++i)
      {
        for (int k = 0; k < 3; ++k)
        {
          include(corner(this->Order[i], k), corner(this->Order[i], k));
        }
      }
      continue;
    }
    for (const int child : { node + 1, own.Right })
    {
      include(this->Lower.data() + static_cast<std::ptrdiff_t>(child) * d,
        this->Upper.data() + static_cast<std::ptrdiff_t>(child) * d);
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
  double u = 0.0, v = 0.0, square = 0.0;
  for (int k = 0; k < d; ++k)
  {
    const double w = point[k] - p[k];
    u += w * (q[k] - p[k]);
    v += w * (r[k] - p[k]);
    square += w * w;
  }
  const double a = this->Products(triangle, 0), b = this->Products(triangle, 1),
               c = this->Products(triangle, 2);
  const auto [s, t] = PlaceInTriangle(a, b, c, u, v);
  const double distance =
    std::max(0.0, square + s * (s * a + 2.0 * t * b - 2.0 * u) + t * (t * c - 2.0 * v));
  if (distance < best.SquaredDistance)
  {
    best.Triangle = triangle;
    best.Barycentric << std::max(0.0, 1.0 - s - t), s, t;
    best.SquaredDistance = distance;
  }
}

double TriangleTree::SquaredDistance(const double* point, int node) const
{
  const int d = this->Dimension;
  const double *lower = this->Lower.data() + static_cast<std::ptrdiff_t>(node) * d,
               *upper = this->Upper.data() + static_cast<std::ptrdiff_t>(node) * d;
  double sum = 0.0;
  for (int k = 0; k < d; ++k)
  {
    const double outside = std::max(std::max(lower[k] - point[k], point[k] - upper[k]), 0.0);
    sum += outside * outside;
  }
  return sum;
}

NearestTriangle TriangleTree::Find(const Eigen::RowVectorXd& point, int guess) const
{
  std::vector<double> padded(this->Dimension, 0.0);
  std::copy(point.begin(), point.end(), padded.begin());
  const double* from = padded.data();
  NearestTriangle best;
  best.SquaredDistance = std::numeric_limits<double>::infinity();
  this->Test(from, std::max(guess, 0), best);
  struct Waiting
  {
    int Node;
    double SquaredDistance;
  };
  constexpr int deepest = 64; // halves of any number of triangles
  std::array<Waiting, deepest> stack;
  int height = 0;
  stack[height++] = { 0, this->SquaredDistance(from, 0) };
  while (height > 0)
  {
    const Waiting next = stack[--height];
    if (next.SquaredDistance >= best.SquaredDistance)
    {
      continue;
    }
    const Node& node = this->Nodes[next.Node];
    if (node.Right < 0)
    {
      for (int i = node.First; i < node.First + node.Count; ++i)
      {
        this->Test(from, this->Order[i], best);
      }
      continue;
    }
    Waiting near{ next.Node + 1, this->SquaredDistance(from, next.Node + 1) };
    Waiting far{ node.Right, this->SquaredDistance(from, node.Right) };
    if (far.SquaredDistance < near.SquaredDistance)
    {
      std::swap(near, far);
    }
    stack[height++] = far;
    stack[height++] = near;
  }
  return best;
}

} // namespace shape
