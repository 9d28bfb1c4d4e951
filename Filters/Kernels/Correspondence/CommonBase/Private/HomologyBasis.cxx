#include "Correspondence/CommonBase/Private/HomologyBasis.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <string>

namespace shape
{
namespace
{

/// Whether each half-edge is on a path of the tree.
std::vector<bool> SidesOfTree(const PathSurface& surface, const std::vector<bool>& isClosing)
{
  std::vector<bool> isTree(surface.SideCount());
  for (int side = 0; side < surface.SideCount(); ++side)
  {
    const int path = surface.PathOf(side);
    isTree[side] = path >= static_cast<int>(isClosing.size()) || (path >= 0 && !isClosing[path]);
  }
  return isTree;
}

/// The half-edge by which each triangle was entered from the first one, or -1.
std::vector<int> DualTree(const PathSurface& surface, const std::vector<bool>& isOnTree)
{
  const int triangles = surface.SideCount() / 3;
  std::vector<int> entered(triangles, -1);
  std::vector<bool> reached(triangles, false);
  std::queue<int> queue;
  queue.push(0);
  reached[0] = true;
  while (!queue.empty())
  {
    const int triangle = queue.front();
    queue.pop();
    for (int side = 3 * triangle; side < 3 * triangle + 3; ++side)
    {
      const int twin = surface.Twin(side);
      if (!isOnTree[side] && !reached[twin / 3])
      {
        reached[twin / 3] = true;
        entered[twin / 3] = twin;
        queue.push(twin / 3);
      }
    }
  }
  return entered;
}

/// The half-edge to each point from its parent in a tree, or -1.
struct PointTree
{
  std::vector<int> Entered;
  std::vector<int> Left; ///< one half-edge of each edge in neither tree
};

PointTree TreeOfPoints(
  const PathSurface& surface, const std::vector<bool>& isOnTree, const std::vector<int>& dual)
{
  const auto isCrossed = [&](int side)
  { return dual[side / 3] == side || dual[surface.Twin(side) / 3] == surface.Twin(side); };
  // The paths first: they are a tree.
  DisjointSets sets(surface.PointCount());
  std::vector<bool> chosen(surface.SideCount(), false);
  PointTree tree{ std::vector<int>(surface.PointCount(), -1), {} };
  for (const bool onPath : { true, false })
  {
    for (int side = 0; side < surface.SideCount(); ++side)
    {
      const int p = surface.Begin(side), q = surface.End(side);
      if (side > surface.Twin(side) || isCrossed(side) || isOnTree[side] != onPath)
      {
        continue;
      }
      if (sets.Find(p) != sets.Find(q))
      {
        sets.Merge(p, q);
        chosen[side] = chosen[surface.Twin(side)] = true;
      }
      else
      {
        tree.Left.push_back(side);
      }
    }
  }
  const int root = surface.Begin(0);
  std::vector<bool> reached(surface.PointCount(), false);
  std::queue<int> queue;
  queue.push(root);
  reached[root] = true;
  while (!queue.empty())
  {
    const int first = surface.Leaving(queue.front());
    queue.pop();
    int side = first;
    do
    {
      const int to = surface.End(side);
      if (chosen[side] && !reached[to])
      {
        reached[to] = true;
        tree.Entered[to] = side;
        queue.push(to);
      }
      side = surface.TurnLeft(side);
    } while (side != first);
  }
  return tree;
}

/// The points from a point to the root of the tree.
std::vector<int> ToRoot(const PathSurface& surface, const PointTree& tree, int point)
{
  std::vector<int> points{ point };
  while (tree.Entered[points.back()] >= 0)
  {
    points.push_back(surface.Begin(tree.Entered[points.back()]));
  }
  return points;
}

/// The loop of an edge and the tree, without the part that it runs twice.
std::vector<int> LoopOf(const PathSurface& surface, const PointTree& tree, int side)
{
  std::vector<int> one = ToRoot(surface, tree, surface.End(side));
  std::vector<int> other = ToRoot(surface, tree, surface.Begin(side));
  while (one.size() > 1 && other.size() > 1 && one[one.size() - 2] == other[other.size() - 2])
  {
    one.pop_back();
    other.pop_back();
  }
  // From the beginning of the edge over its end to the common ancestor, and back down.
  one.insert(one.end(), other.rbegin() + 1, other.rend());
  return one;
}

/// Adds the crossings of a dual path from a triangle to the tree's first one.
void AddCrossings(
  PathSurface& surface, const std::vector<int>& dual, int triangle, int form, int sign)
{
  while (dual[triangle] >= 0)
  {
    const int side = dual[triangle]; // of this triangle, towards the previous one
    surface.SetForm(side, form, static_cast<signed char>(surface.FormsOf(side)[form] + sign));
    triangle = surface.Twin(side) / 3;
  }
}

/// The points' normals, and how far curves may be pushed along them.
struct Offsets
{
  Eigen::MatrixXd Normals;
  double Distance;
};

Offsets OutwardOffsets(const PathSurface& surface)
{
  Offsets offsets{ Eigen::MatrixXd::Zero(surface.PointCount(), 3),
    std::numeric_limits<double>::infinity() };
  for (int side = 0; side < surface.SideCount(); ++side)
  {
    const Eigen::RowVector3d a = surface.PositionOf(surface.Begin(side)),
                             b = surface.PositionOf(surface.End(side)) - a,
                             c = surface.PositionOf(surface.Apex(side)) - a;
    const Eigen::RowVector3d normal = b.cross(c);
    const double angle = std::atan2(normal.norm(), b.dot(c));
    offsets.Normals.row(surface.Begin(side)) += angle * normal.normalized();
    offsets.Distance = std::min(offsets.Distance, b.norm());
  }
  offsets.Normals.rowwise().normalize();
  // Far below the thickness of a part that edges of this length describe.
  offsets.Distance *= 0.02;
  return offsets;
}

Eigen::MatrixXd PositionsOf(
  const PathSurface& surface, const std::vector<int>& loop, const Offsets& offsets, double factor)
{
  Eigen::MatrixXd positions(loop.size(), 3);
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    positions.row(static_cast<Eigen::Index>(i)) =
      surface.PositionOf(loop[i]) + factor * offsets.Distance * offsets.Normals.row(loop[i]);
  }
  return positions;
}

} // namespace

double ComputeLinkingNumber(const Eigen::MatrixXd& one, const Eigen::MatrixXd& other)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < one.rows(); ++i)
  {
    const Eigen::RowVector3d p1 = one.row(i), p2 = one.row((i + 1) % one.rows());
    for (Eigen::Index j = 0; j < other.rows(); ++j)
    {
      const Eigen::RowVector3d p3 = other.row(j), p4 = other.row((j + 1) % other.rows());
      const Eigen::RowVector3d r13 = p3 - p1, r14 = p4 - p1, r23 = p3 - p2, r24 = p4 - p2;
      // The solid angle of the quadrilateral of directions between the segments: two triangles.
      const auto solid =
        [](const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c)
      {
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        return 2.0 *
          std::atan2(
            a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
      };
      sum += solid(r13, r14, r24) + solid(r13, r24, r23);
    }
  }
  return sum / (4.0 * M_PI);
}

HomologyBasis FindHomologyBasis(
  PathSurface& surface, const std::vector<bool>& isClosing, const std::string& name)
{
  const std::vector<bool> isOnTree = SidesOfTree(surface, isClosing);
  const std::vector<int> dual = DualTree(surface, isOnTree);
  const PointTree tree = TreeOfPoints(surface, isOnTree, dual);
  HomologyBasis basis;
  const auto count = static_cast<int>(tree.Left.size());
  for (int form = 0; form < count; ++form)
  {
    const int side = tree.Left[form];
    basis.Loops.push_back(LoopOf(surface, tree, side));
    // The dual loop crosses the edge from its twin's triangle, and returns through the tree.
    surface.SetForm(side, form, static_cast<signed char>(surface.FormsOf(side)[form] + 1));
    AddCrossings(surface, dual, side / 3, form, -1);
    AddCrossings(surface, dual, surface.Twin(side) / 3, form, 1);
  }
  const Offsets offsets = OutwardOffsets(surface);
  basis.Linking = Eigen::MatrixXi::Zero(count, count);
  bool isEmbedded = true;
  for (int i = 0; i < count; ++i)
  {
    const Eigen::MatrixXd inner = PositionsOf(surface, basis.Loops[i], offsets, -1.0);
    for (int j = 0; j < count; ++j)
    {
      const double number =
        ComputeLinkingNumber(inner, PositionsOf(surface, basis.Loops[j], offsets, 1.0));
      basis.Linking(i, j) = static_cast<int>(std::lround(number));
      isEmbedded = isEmbedded && std::abs(number - basis.Linking(i, j)) < 0.01;
    }
  }
  // The linking matrix minus its transpose is the intersection form, whose determinant is 1.
  const Eigen::MatrixXd intersections = (basis.Linking - basis.Linking.transpose()).cast<double>();
  isEmbedded =
    isEmbedded && (count == 0 || std::abs(std::abs(intersections.determinant()) - 1.0) < 1e-6);
  if (!isEmbedded)
  {
    throw InvalidInput(name +
      " intersects itself, so its handles and tunnels cannot be distinguished; remove the "
      "self-intersections with Shape Solidify");
  }
  return basis;
}

} // namespace shape
