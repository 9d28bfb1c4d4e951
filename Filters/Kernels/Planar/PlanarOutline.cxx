#include "Planar/PlanarOutline.h"

#include "Geometry/Orientation.h"

#include <algorithm>
#include <utility>

namespace shape
{

PlanarOutline::PlanarOutline(Eigen::MatrixXd corners)
  : Points(std::move(corners))
  , Low(this->Points.colwise().minCoeff())
  , High(this->Points.colwise().maxCoeff())
  , Bins(this->Points.rows())
{
  for (int side = 0; side < this->Size(); ++side)
  {
    const double a = this->Corner(side).y(), b = this->Corner(side + 1).y();
    const int last = this->Bin(std::max(a, b));
    for (int bin = this->Bin(std::min(a, b)); bin <= last; ++bin)
    {
      this->Bins[bin].push_back(side);
    }
  }
}

int PlanarOutline::Bin(double y) const
{
  const double height = this->High.y() - this->Low.y();
  const double share = height > 0.0 ? (y - this->Low.y()) / height : 0.0;
  const auto last = static_cast<double>(this->Bins.size() - 1);
  return static_cast<int>(std::clamp(share * last, 0.0, last));
}

int PlanarOutline::Side(const Eigen::RowVector2d& position) const
{
  // The parity of the number of edges that the ray to the right crosses.
  bool inside = false, on = false;
  this->ForEachNear(position, { this->High.x(), position.y() },
    [&](int side)
    {
      Eigen::RowVector2d a = this->Corner(side), b = this->Corner(side + 1);
      if (a.y() > b.y())
      {
        std::swap(a, b);
      }
      const int turn = EvaluateOrientation(a, b, position);
      on = turn == 0 && std::min(a.x(), b.x()) <= position.x();
      // Half-open in y, so a corner is counted for one of its two edges.
      inside ^= a.y() <= position.y() && position.y() < b.y() && turn > 0;
      return !on;
    });
  if (on)
  {
    return 0;
  }
  return inside ? 1 : -1;
}

bool PlanarOutline::Crosses(const Eigen::Matrix<double, 3, 2>& triangle) const
{
  return !this->ForEachNear(triangle.colwise().minCoeff(), triangle.colwise().maxCoeff(),
    [&](int side)
    { return !SegmentMeetsTriangle(this->Corner(side), this->Corner(side + 1), triangle); });
}

bool PlanarOutline::Covers(const Eigen::Matrix<double, 3, 2>& triangle) const
{
  // If no edge intersects the triangle, all its positions are on one side of the outline.
  return this->Crosses(triangle) || this->Side(triangle.colwise().mean()) > 0;
}

} // namespace shape
