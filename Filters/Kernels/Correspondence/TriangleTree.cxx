#include "Correspondence/TriangleTree.h"

#include "Core/Errors.h"
#include "Correspondence/PlaceInTriangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace shape
{
namespace
{

constexpr int Leaf = 2;     // triangles
constexpr int Multiple = 4; // numbers that one instruction may take
constexpr int MostDimensions = 64;
using Four = Eigen::Array<double, Multiple, 1>;

double SquaredDistance(const double* a, const double* b, int dimension)
{
  Four sum = Four::Zero();
  for (int k = 0; k < dimension; k += Multiple)
  {
    sum += (Eigen::Map<const Four>(a + k) - Eigen::Map<const Four>(b + k)).square();
  }
  return sum.sum();
}

} // namespace

TriangleTree::TriangleTree(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points)
  : Triangles(triangles)
  , Dimension((static_cast<int>(points.cols()) + Multiple - 1) / Multiple * Multiple)
  , Order(triangles.rows())
  , Coordinates(points.rows() * this->Dimension, 0.0)
  , Products(triangles.rows(), 3)
{
  RequireOption(this->Dimension <= MostDimensions, "the dimension", this->Dimension, "at most 64");
  std::iota(this->Order.begin(), this->Order.end(), 0);
  const Eigen::MatrixXd centres = points(triangles.col(0), Eigen::all) +
    points(triangles.col(1), Eigen::all) + points(triangles.col(2), Eigen::all);
  this->Split(0, static_cast<int>(triangles.rows()), centres);
  this->Centres.resize(this->Nodes.size() * this->Dimension);
  this->Radii.resize(this->Nodes.size());
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
  for (std::size_t node = 0; node < this->Nodes.size(); ++node)
  {
    const Node& own = this->Nodes[node];
    double* centre = this->Centres.data() + node * d;
    std::fill_n(centre, d, 0.0);
    const auto forCorners = [&](const auto& visit)
    {
      for (int i = own.First; i < own.First + own.Count; ++i)
      {
        for (int c = 0; c < 3; ++c)
        {
          visit(corner(this->Order[i], c));
        }
      }
    };
    forCorners(
      [&](const double* place)
      {
        for (int k = 0; k < d; ++k)
        {
          centre[k] += place[k] / (3.0 * own.Count);
        }
      });
    double farthest = 0.0;
    forCorners([&](const double* place)
      { farthest = std::max(farthest, SquaredDistance(place, centre, d)); });
    this->Radii[node] = std::sqrt(farthest);
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

double TriangleTree::Gap(const double* point, int node) const
{
  const double* centre = this->Centres.data() + static_cast<std::ptrdiff_t>(node) * this->Dimension;
  return std::sqrt(SquaredDistance(point, centre, this->Dimension)) - this->Radii[node];
}

NearestTriangle TriangleTree::Find(const Eigen::RowVectorXd& point, int guess) const
{
  std::array<double, MostDimensions> padded{};
  std::copy(point.begin(), point.end(), padded.begin());
  const double* from = padded.data();
  NearestTriangle best;
  best.SquaredDistance = std::numeric_limits<double>::infinity();
  this->Test(from, std::max(guess, 0), best);
  double bound = std::sqrt(best.SquaredDistance);
  struct Waiting
  {
    int Node;
    double Gap;
  };
  constexpr int deepest = 64; // halves of any number of triangles
  std::array<Waiting, deepest> stack;
  int height = 0;
  stack[height++] = { 0, this->Gap(from, 0) };
  while (height > 0)
  {
    const Waiting next = stack[--height];
    if (next.Gap >= bound)
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
      bound = std::sqrt(best.SquaredDistance);
      continue;
    }
    Waiting near{ next.Node + 1, this->Gap(from, next.Node + 1) };
    Waiting far{ node.Right, this->Gap(from, node.Right) };
    if (far.Gap < near.Gap)
    {
      std::swap(near, far);
    }
    stack[height++] = far;
    stack[height++] = near;
  }
  return best;
}

} // namespace shape
