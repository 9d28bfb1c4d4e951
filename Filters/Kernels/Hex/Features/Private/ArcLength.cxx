#include "Hex/Features/Private/ArcLength.h"

#include "Geometry/SegmentProjection.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace shape
{

ArcLength::ArcLength(const Mesh& surface, const FeatureCurve& curve)
  : Points(surface.Points(curve.Points, Eigen::all))
  , Closed(curve.Closed)
{
  const Eigen::Index count = this->Points.rows();
  this->Lengths = { 0.0 };
  for (Eigen::Index i = 1; i < count + (this->Closed ? 1 : 0); ++i)
  {
    this->Lengths.push_back(
      this->Lengths.back() + (this->Points.row(i % count) - this->Points.row(i - 1)).norm());
  }
  constexpr double straight = 2.0; // degrees
  this->Bends = this->Turns(straight);
  std::sort(this->Bends.begin(), this->Bends.end());
}

std::vector<double> ArcLength::Turns(double degrees) const
{
  const Eigen::Index count = this->Points.rows();
  std::vector<std::pair<double, double>> turns; // cosine, length
  for (Eigen::Index i = this->Closed ? 0 : 1; i < count - (this->Closed ? 0 : 1); ++i)
  {
    const Eigen::RowVector3d before =
      (this->Points.row(i) - this->Points.row((i + count - 1) % count)).normalized();
    const Eigen::RowVector3d after =
      (this->Points.row((i + 1) % count) - this->Points.row(i)).normalized();
    if (const double cosine = before.dot(after); cosine < std::cos(degrees * M_PI / 180.0))
    {
      turns.emplace_back(cosine, this->Lengths[i]);
    }
  }
  std::sort(turns.begin(), turns.end());
  std::vector<double> lengths;
  for (const auto& [cosine, length] : turns)
  {
    lengths.push_back(length);
  }
  return lengths;
}

Eigen::MatrixXd ArcLength::Part(double begin, double end) const
{
  std::vector<double> lengths = { begin };
  // A closed curve is periodic: the part may begin before it or end after it.
  for (const double turn : { -this->Length(), 0.0, this->Length() })
  {
    for (std::size_t i = 0; i < this->Lengths.size() && (this->Closed || turn == 0.0); ++i)
    {
      const double length = this->Lengths[i] + turn;
      if (length > lengths.back() && length < end)
      {
        lengths.push_back(length);
      }
    }
  }
  if (end > begin)
  {
    lengths.push_back(end);
  }
  Eigen::MatrixXd part(static_cast<Eigen::Index>(lengths.size()), 3);
  for (Eigen::Index i = 0; i < part.rows(); ++i)
  {
    part.row(i) = this->At(lengths[i]);
  }
  return part;
}

std::vector<double> ArcLength::BendsBetween(double begin, double end) const
{
  return this->Between(this->Bends, begin, end);
}

double ArcLength::Deviation(double begin, double end) const
{
  const Eigen::RowVector3d low = this->At(begin), high = this->At(end);
  double maximum = 0.0;
  for (const double point : this->Between(this->Lengths, begin, end))
  {
    const Eigen::RowVector3d on = this->At(point);
    const double share = ProjectOntoSegment(on, low, high);
    maximum = std::max(maximum, (on - low - share * (high - low)).norm());
  }
  return maximum;
}

double ArcLength::Nearest(const Eigen::RowVector3d& position) const
{
  Eigen::Index nearest = 0;
  (this->Points.rowwise() - position).rowwise().squaredNorm().minCoeff(&nearest);
  return this->Lengths[nearest];
}

Eigen::RowVector3d ArcLength::At(double length) const
{
  length = this->Closed ? length - this->Length() * std::floor(length / this->Length())
                        : std::clamp(length, 0.0, this->Length());
  const auto next = std::clamp<std::ptrdiff_t>(
    std::upper_bound(this->Lengths.begin(), this->Lengths.end(), length) - this->Lengths.begin(), 1,
    static_cast<std::ptrdiff_t>(this->Lengths.size()) - 1);
  const double step = this->Lengths[next] - this->Lengths[next - 1];
  const double share = step > 0.0 ? (length - this->Lengths[next - 1]) / step : 0.0;
  return (1.0 - share) * this->Points.row(next - 1) +
    share * this->Points.row(next % this->Points.rows());
}

std::vector<double> ArcLength::Between(
  const std::vector<double>& lengths, double begin, double end) const
{
  std::vector<double> between;
  const double first = this->Closed ? std::floor(begin / this->Length()) : 0.0,
               last = this->Closed ? std::floor(end / this->Length()) : 0.0;
  for (double turn = first; turn <= last; turn += 1.0)
  {
    const double shift = turn * this->Length();
    for (auto length = std::upper_bound(lengths.begin(), lengths.end(), begin - shift);
         length != lengths.end() && *length + shift < end; ++length)
    {
      between.push_back(*length + shift);
    }
  }
  return between;
}

} // namespace shape
