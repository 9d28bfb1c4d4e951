#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace shape
{

/// A closed polygon in the plane that is asked for many places where they lie. All answers are
/// exact (Geometry/Orientation.h).
class PlanarOutline
{
public:
  /// corners: n x 2, finite, n >= 3, in either sense.
  explicit PlanarOutline(Eigen::MatrixXd corners);

  const Eigen::MatrixXd& Corners() const { return this->Points; }
  int Size() const { return static_cast<int>(this->Points.rows()); }
  Eigen::RowVector2d Corner(int i) const { return this->Points.row(i % this->Size()); }

  /// 1 where a place is inside, where an odd number of sides is to its right; 0 on a side; else -1.
  int Side(const Eigen::RowVector2d& position) const;

  /// Whether a side meets the open triangle (counter-clockwise corners, one a row), or it is
  /// Whether a side meets the open triangle (counter-clockwise corners, one a row).
  bool Crosses(const Eigen::Matrix<double, 3, 2>& triangle) const;

  /// Whether that is so, or the triangle is inside.
  bool Covers(const Eigen::Matrix<double, 3, 2>& triangle) const;

  /// Calls body(i) with each side, from corner i to the next, whose box meets the one between low
  /// and high; it returns false to stop. Returns whether it was not stopped.
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
        // A side is in several bins: it is looked at in the first that both have.
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
  std::vector<std::vector<int>> Bins; ///< sides by height
};

} // namespace shape
