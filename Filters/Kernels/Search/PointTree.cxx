#include "Search/PointTree.h"

#include "Mesh/SurfaceWork.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <limits>
#include <utility>

namespace shape
{
namespace
{

using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using NearestTree = nanoflann::KDTreeEigenMatrixAdaptor<Rows, 3>;
using Found = std::vector<std::pair<double, int>>; // squared distance, point

/// The k nearest points; at equal distance those of lower index.
class NearestSet
{
public:
  explicit NearestSet(std::size_t count)
    : Count(count)
  {
  }
  bool full() const { return true; } // NOLINT(readability-identifier-naming): nanoflann's names
  bool addPoint(double square, Eigen::Index point) // NOLINT(readability-identifier-naming)
  {
    const std::pair<double, int> item(square, static_cast<int>(point));
    this->Items.insert(std::upper_bound(this->Items.begin(), this->Items.end(), item), item);
    if (this->Items.size() > this->Count)
    {
      this->Items.pop_back();
    }
    return true;
  }
  double worstDist() const // NOLINT(readability-identifier-naming)
  {
    // The next larger double, so that points at equal distance are offered, too.
    return this->Items.size() < this->Count
      ? std::numeric_limits<double>::max()
      : std::nextafter(this->Items.back().first, std::numeric_limits<double>::max());
  }

  Found Items;

private:
  std::size_t Count;
};

/// The nearest accepted point; at equal distance the one of lower index.
class AcceptedSet
{
public:
  AcceptedSet(const std::function<bool(int)>& accepts, double square)
    : Accepts(accepts)
    , Square(square)
  {
  }
  bool full() const { return true; }               // NOLINT(readability-identifier-naming)
  bool addPoint(double square, Eigen::Index point) // NOLINT(readability-identifier-naming)
  {
    const int number = static_cast<int>(point);
    const bool nearer =
      square < this->Square || (square == this->Square && this->Point >= 0 && number < this->Point);
    if (nearer && this->Accepts(number))
    {
      this->Square = square;
      this->Point = number;
    }
    return true;
  }
  double worstDist() const // NOLINT(readability-identifier-naming)
  {
    return this->Point < 0 ? this->Square
                           : std::nextafter(this->Square, std::numeric_limits<double>::max());
  }

  int Point = -1;

private:
  const std::function<bool(int)>& Accepts;
  double Square;
};

} // namespace

struct PointTree::Index
{
  explicit Index(const Eigen::MatrixXd& points)
    : Points(points)
    , Nodes(3, std::cref(this->Points), 10)
  {
  }
  Rows Points;
  NearestTree Nodes;
};

PointTree::PointTree(const Eigen::MatrixXd& points)
  : Impl(std::make_unique<Index>(points))
{
  SurfaceWork::Note(SurfaceWork::Kind::SearchTree, points);
}

PointTree::~PointTree() = default;
PointTree::PointTree(PointTree&&) noexcept = default;
PointTree& PointTree::operator=(PointTree&&) noexcept = default;

std::vector<int> PointTree::Nearest(const Eigen::RowVector3d& position, int count) const
{
  NearestSet set(count);
  this->Impl->Nodes.index->findNeighbors(set, position.data(), nanoflann::SearchParams());
  std::vector<int> points;
  for (const auto& [square, point] : set.Items)
  {
    points.push_back(point);
  }
  return points;
}

int PointTree::NearestOf(
  const Eigen::RowVector3d& position, const std::function<bool(int)>& accepts, double within) const
{
  AcceptedSet set(accepts, std::min(within * within, std::numeric_limits<double>::max()));
  this->Impl->Nodes.index->findNeighbors(set, position.data(), nanoflann::SearchParams());
  return set.Point;
}

std::vector<int> PointTree::Within(const Eigen::RowVector3d& position, double radius) const
{
  // The next larger double, because nanoflann excludes points at exactly this distance.
  std::vector<std::pair<Eigen::Index, double>> found;
  this->Impl->Nodes.index->radiusSearch(position.data(),
    std::nextafter(radius * radius, std::numeric_limits<double>::max()), found,
    nanoflann::SearchParams(32, 0.0F, false));
  std::vector<int> points;
  for (const auto& item : found)
  {
    points.push_back(static_cast<int>(item.first));
  }
  std::sort(points.begin(), points.end());
  return points;
}

} // namespace shape
