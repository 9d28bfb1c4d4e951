#include "Parameterize/Private/VertexRings.h"

#include "Parameterize/SphericalTriangles.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shape
{

namespace
{

void StartWith(std::vector<int>& ring, int first)
{
  std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), first), ring.end());
}

} // namespace

VertexRings::VertexRings(const Eigen::MatrixXi& triangles, int points)
  : Rings(points)
  , Count(points)
{
  // Each triangle at a point gives one step (from, to) of its ring; the steps are chained.
  std::vector<std::vector<std::pair<int, int>>> steps(points);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      steps[triangles(t, corner)].emplace_back(
        triangles(t, (corner + 1) % 3), triangles(t, (corner + 2) % 3));
    }
  }
  for (int i = 0; i < points; ++i)
  {
    std::sort(steps[i].begin(), steps[i].end());
    int next = steps[i].front().first;
    for (std::size_t k = 0; k < steps[i].size(); ++k)
    {
      this->Rings[i].push_back(next);
      next =
        std::lower_bound(steps[i].begin(), steps[i].end(), std::pair<int, int>(next, -1))->second;
    }
  }
}

std::vector<int> VertexRings::RingFrom(int point, int first) const
{
  std::vector<int> ring = this->Rings[point];
  StartWith(ring, first);
  return ring;
}

bool VertexRings::CanMerge(int point, int into) const
{
  const std::vector<int>& other = this->Rings[into];
  const auto shared = [&](int i)
  { return std::find(other.begin(), other.end(), i) != other.end(); };
  return this->Count > 4 &&
    std::count_if(this->Rings[point].begin(), this->Rings[point].end(), shared) == 2;
}

std::vector<int> VertexRings::Merge(int point, int into)
{
  std::vector<int> ring = this->RingFrom(point, into);
  std::vector<int>& target = this->Rings[into];
  StartWith(target, point);
  // In the ring of `into`, `point` is replaced by the part of its ring that `into` does not share.
  std::vector<int> merged(ring.begin() + 2, ring.end() - 1);
  merged.insert(merged.end(), target.begin() + 1, target.end());
  target = std::move(merged);
  for (std::size_t k = 1; k < ring.size(); ++k)
  {
    std::vector<int>& around = this->Rings[ring[k]];
    const auto position = std::find(around.begin(), around.end(), point);
    // The two common neighbours lose a neighbour; the others get `into` instead.
    if (k == 1 || k + 1 == ring.size())
    {
      around.erase(position);
    }
    else
    {
      *position = into;
    }
  }
  this->Rings[point].clear();
  --this->Count;
  return ring;
}

void VertexRings::Restore(int point, const std::vector<int>& ring)
{
  const int into = ring[0];
  const int right = ring[1];
  const int left = ring.back();
  std::vector<int>& target = this->Rings[into];
  // The reverse of Merge, ring by ring.
  StartWith(target, right);
  target.erase(target.begin() + 1, target.begin() + (static_cast<int>(ring.size()) - 2));
  target.insert(target.begin() + 1, point);
  for (std::size_t k = 2; k + 1 < ring.size(); ++k)
  {
    std::vector<int>& around = this->Rings[ring[k]];
    *std::find(around.begin(), around.end(), into) = point;
  }
  std::vector<int>& atRight = this->Rings[right];
  atRight.insert(std::find(atRight.begin(), atRight.end(), into), point);
  std::vector<int>& atLeft = this->Rings[left];
  atLeft.insert(std::find(atLeft.begin(), atLeft.end(), into) + 1, point);
  this->Rings[point] = ring;
  ++this->Count;
}

bool IsInStarKernel(
  const Eigen::MatrixXd& points, const Eigen::RowVector3d& position, const std::vector<int>& ring)
{
  for (std::size_t k = 0; k < ring.size(); ++k)
  {
    if (!IsFacingOutwards(position, points.row(ring[k]), points.row(ring[(k + 1) % ring.size()])))
    {
      return false;
    }
  }
  return true;
}

bool MovePointIntoKernel(Eigen::MatrixXd& points, int point, const std::vector<int>& ring)
{
  // Outline:
  // 1. ring[0] sees all edges except the two that begin or end there. So near ring[0] the kernel is
  //    the lune between the planes of these two.
  // 2. The lune is clipped by the planes of the other edges.
  // 3. The mean of the kernel's corners, moved towards ring[0] if rounding puts it outside.
  const auto normalOf = [&](std::size_t k)
  {
    const Eigen::RowVector3d a = points.row(ring[k]);
    const Eigen::RowVector3d b = points.row(ring[(k + 1) % ring.size()]);
    return Eigen::RowVector3d(a.cross(b - a).normalized());
  };
  // Step 1: the lune.
  const Eigen::RowVector3d corner = points.row(ring[0]);
  const Eigen::RowVector3d after = normalOf(0);
  const Eigen::RowVector3d before = normalOf(ring.size() - 1);
  Eigen::RowVector3d right = after.cross(corner);
  Eigen::RowVector3d left = before.cross(corner);
  right *= right.dot(before) < 0.0 ? -1.0 : 1.0;
  left *= left.dot(after) < 0.0 ? -1.0 : 1.0;
  std::vector<Eigen::RowVector3d> kernel = { corner, right.normalized(), -corner,
    left.normalized() };
  // Step 2: clipping.
  for (std::size_t k = 1; k + 1 < ring.size(); ++k)
  {
    const Eigen::RowVector3d normal = normalOf(k);
    const Eigen::RowVector3d foot = points.row(ring[k]);
    std::vector<Eigen::RowVector3d> clipped;
    for (std::size_t i = 0; i < kernel.size(); ++i)
    {
      const Eigen::RowVector3d& p = kernel[i];
      const Eigen::RowVector3d& q = kernel[(i + 1) % kernel.size()];
      const double heightP = normal.dot(p - foot);
      const double heightQ = normal.dot(q - foot);
      if (heightP > 0.0)
      {
        clipped.push_back(p);
      }
      if ((heightP > 0.0) != (heightQ > 0.0))
      {
        clipped.push_back((p + heightP / (heightP - heightQ) * (q - p)).normalized());
      }
    }
    kernel = std::move(clipped);
  }
  // Step 3: a position in the kernel.
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (const Eigen::RowVector3d& p : kernel)
  {
    sum += p;
  }
  // In a long thin kernel rounding may hide the centre; positions nearer to the corner are tried.
  for (double share = 1.0; share > 1e-6 && sum.squaredNorm() > 0.0; share *= 0.5)
  {
    const Eigen::RowVector3d position = (corner + share * (sum.normalized() - corner)).normalized();
    if (IsInStarKernel(points, position, ring))
    {
      points.row(point) = position;
      return true;
    }
  }
  return false;
}

} // namespace shape
