#include "Hex/CurveSpread.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// A polyline by the length along it.
class ArcLength
{
public:
  ArcLength(const Mesh& surface, const FeatureCurve& curve)
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
  }

  double Length() const { return this->Lengths.back(); }

  /// The length to its point closest to a place.
  double Nearest(const Eigen::RowVector3d& place) const
  {
    Eigen::Index nearest = 0;
    (this->Points.rowwise() - place).rowwise().squaredNorm().minCoeff(&nearest);
    return this->Lengths[nearest];
  }

  Eigen::RowVector3d At(double length) const
  {
    length = this->Closed ? length - this->Length() * std::floor(length / this->Length())
                          : std::clamp(length, 0.0, this->Length());
    const auto next = std::clamp<std::ptrdiff_t>(
      std::upper_bound(this->Lengths.begin(), this->Lengths.end(), length) - this->Lengths.begin(),
      1, static_cast<std::ptrdiff_t>(this->Lengths.size()) - 1);
    const double step = this->Lengths[next] - this->Lengths[next - 1];
    const double share = step > 0.0 ? (length - this->Lengths[next - 1]) / step : 0.0;
    return (1.0 - share) * this->Points.row(next - 1) +
      share * this->Points.row(next % this->Points.rows());
  }

private:
  Eigen::MatrixXd Points;
  bool Closed;
  std::vector<double> Lengths; ///< to each point; of a closed one, to the first again, too
};

} // namespace

Eigen::MatrixXd SpreadAlong(
  const Eigen::MatrixXd& chain, const Mesh& surface, const FeatureCurve& curve)
{
  const ArcLength along(surface, curve);
  const Eigen::Index count = chain.rows();
  Eigen::VectorXd lengths = Eigen::VectorXd::Zero(count);
  for (Eigen::Index i = 1; i < count; ++i)
  {
    lengths(i) = lengths(i - 1) + (chain.row(i) - chain.row(i - 1)).norm();
  }
  const double whole =
    lengths(count - 1) + (curve.Closed ? (chain.row(0) - chain.row(count - 1)).norm() : 0.0);
  const double first = curve.Closed ? along.Nearest(chain.row(0)) : 0.0;
  Eigen::MatrixXd best;
  double least = std::numeric_limits<double>::infinity();
  for (const double direction : { 1.0, -1.0 })
  {
    Eigen::MatrixXd places(count, 3);
    const double begin = curve.Closed || direction > 0.0 ? first : along.Length();
    for (Eigen::Index i = 0; i < count; ++i)
    {
      places.row(i) = along.At(begin + direction * along.Length() * lengths(i) / whole);
    }
    if (const double sum = (places - chain).rowwise().norm().sum(); sum < least)
    {
      least = sum;
      best = std::move(places);
    }
  }
  return best;
}

} // namespace shape
