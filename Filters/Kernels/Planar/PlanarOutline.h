#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace shape
{

/// A closed polygon in the plane, prepared for many point queries. All answers are exact
/// (Geometry/Orientation.h).
class PlanarOutline
{
public:
  /// corners: n x 2, finite, n >= 3, in either orientation.
  explicit PlanarOutline(Eigen::MatrixXd corners);

  const Eigen::MatrixXd& Corners() const { return this->Points; }
  int Size() const { return static_cast<int>(this->Points.rows()); }
  Eigen::RowVector2d Corner(int i) const { return this->Points.row(i % this->Size()); }

  /// Returns 1 if a position is inside (a ray to the right crosses an odd number of edges), 0 if it
  /// is on an edge, else -1.
  int Side(const Eigen::RowVector2d& position) const;

  /// Whether an edge intersects the interior of the triangle, given by its counter-clockwise
  /// corners, one per row.
  bool Crosses(const Eigen::Matrix<double, 3, 2>& triangle) const;

  /// Whether the polygon covers a part of the triangle: an edge intersects the triangle's interior,
  /// or the triangle is inside the polygon.
  bool Covers(const Eigen::Matrix<double, 3, 2>& triangle) const;

  /// Calls body(i) for each edge i, from corner i to the next, if the box of the edge intersects
  /// the box from low to high. Stops when body returns false. Returns false if it stopped, else
  /// true.
  template <typename Body>
  bool ForEachNear(
    const Eigen::RowVector2d& low, const Eigen::RowVector2d& high, const Body& body) const
  {
    if (high.x() < this->Low.x() || low.x() > this->High.x() || high.y() < this->Low.y() ||
      low.y() > this->High.y())
    {
      return true;
    }
    const int first = this->Bin(low.y()), last = this->Bin(high.y());
    for (int bin = first; bin <= last; ++bin)
    {
      for (const int side : this->Bins[bin])
      {
        const Eigen::RowVector2d a = this->Corner(side), b = this->Corner(side + 1);
        // An edge may be in several bins: it is visited in the first one of the query's bins.
        if (bin == std::max(first, this->Bin(std::min(a.y(), b.y()))) &&
          (a.cwiseMin(b).array() <= high.array()).all() &&
          (a.cwiseMax(b).array() >= low.array()).all() && !body(side))
        {
          return false;
        }
      }
    }
    return true;
  }

private:
  int Bin(double y) const;

  Eigen::MatrixXd Points;
  Eigen::RowVector2d Low, High;
  std::vector<std::vector<int>> Bins; ///< for each interval of y, the edges that reach into it
};

} // namespace shape
