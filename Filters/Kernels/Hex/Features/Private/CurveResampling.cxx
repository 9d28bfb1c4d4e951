#include "Hex/Features/Private/CurveResampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// A polyline parameterised by arc length.
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

  /// Returns the arc lengths at bends of more than an angle, the sharpest first.
  std::vector<double> Turns(double degrees) const
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

  /// Returns the part between two arc lengths; on a closed line these may exceed its range.
  Eigen::MatrixXd Part(double begin, double end) const
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

  /// Whether the part between two arc lengths turns by more than about 3 degrees: of an arc of a
  /// circle, 1 - chord / length is about the square of its angle divided by 24.
  bool Bends(double begin, double end) const
  {
    constexpr double maximum = 1e-4;
    return (this->At(end) - this->At(begin)).norm() < (1.0 - maximum) * (end - begin);
  }

  /// Returns the arc length at the point closest to a position.
  double Nearest(const Eigen::RowVector3d& position) const
  {
    Eigen::Index nearest = 0;
    (this->Points.rowwise() - position).rowwise().squaredNorm().minCoeff(&nearest);
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
  std::vector<double> Lengths; ///< arc length at each point; if closed, also back at the first
};

/// Points of a chain by arc length on a curve; some are fixed at bends.
class Spread
{
public:
  /// own: arc length of each point on the chain. first: where the chain begins on the curve.
  Spread(const ArcLength& along, std::vector<double> own, double whole, double first,
    double direction, bool isClosed)
    : Along(along)
    , Own(std::move(own))
    , Scale(direction * along.Length() / whole)
    , Closed(isClosed)
  {
    for (const double length : this->Own)
    {
      this->Lengths.push_back(first + this->Scale * length);
    }
    this->Unmoved = this->Lengths;
    this->Fixed.assign(this->Own.size(), 0);
    if (!isClosed)
    {
      this->Fixed.front() = this->Fixed.back() = 1;
    }
    constexpr double sharp = 20.0; // degrees
    // The sharpest bends first: they get the points closest to them.
    for (const double turn : along.Turns(sharp))
    {
      this->FixAt(turn);
    }
    this->Share();
  }

  CurvePositions Result() const
  {
    CurvePositions result;
    result.Positions.resize(static_cast<Eigen::Index>(this->Lengths.size()), 3);
    for (std::size_t i = 0; i < this->Lengths.size(); ++i)
    {
      const double here = this->Lengths[i];
      double low = here, high = here;
      if (!this->Fixed[i])
      {
        const auto bound = [&](double reach)
        {
          const double maximum = reach * this->Step();
          low = std::max(here - maximum, this->Bound(i, this->Scale > 0.0 ? -1 : 1, -1.0));
          high = std::min(here + maximum, this->Bound(i, this->Scale > 0.0 ? 1 : -1, 1.0));
        };
        // In mean steps. Where the curve bends, edges of the chain must differ little in length:
        // the distance between both grows with the square of the longest edge.
        constexpr double straight = 4.0, curved = 0.4;
        bound(straight);
        if (this->Along.Bends(low, high))
        {
          bound(curved);
        }
      }
      result.Positions.row(static_cast<Eigen::Index>(i)) = this->Along.At(here);
      result.Spans.push_back(this->Along.Part(low, high));
    }
    return result;
  }

private:
  double Step() const
  {
    return this->Along.Length() / static_cast<double>(this->Own.size() - (this->Closed ? 0 : 1));
  }

  /// On a closed curve, returns the arc length of the same position closest to another arc length.
  double NextTo(double length, double other) const
  {
    return this->Closed
      ? length + this->Along.Length() * std::round((other - length) / this->Along.Length())
      : length;
  }

  /// Moves the closest free point to a bend of the curve, unless the steps between it and other
  /// fixed points would then be less than half or more than twice as long.
  void FixAt(double turn)
  {
    std::size_t nearest = 0;
    double minimum = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < this->Lengths.size(); ++i)
    {
      const double distance = std::abs(this->NextTo(turn, this->Unmoved[i]) - this->Unmoved[i]);
      if (distance < minimum)
      {
        minimum = distance;
        nearest = i;
      }
    }
    const double position = this->NextTo(turn, this->Unmoved[nearest]);
    if (this->Fixed[nearest])
    {
      return;
    }
    for (std::size_t i = 0; i < this->Lengths.size(); ++i)
    {
      const double before =
        this->Unmoved[nearest] - this->NextTo(this->Unmoved[i], this->Unmoved[nearest]);
      const double after = position - this->NextTo(this->Lengths[i], position);
      if (this->Fixed[i] && (after / before < 0.5 || after / before > 2.0))
      {
        return;
      }
    }
    this->Fixed[nearest] = 1;
    this->Lengths[nearest] = position;
  }

  /// Points between fixed ones keep their relative positions between these.
  void Share()
  {
    const std::size_t count = this->Lengths.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      if (this->Fixed[i])
      {
        continue;
      }
      const auto [low, lowShift] = this->FixedBeside(i, -1);
      const auto [high, highShift] = this->FixedBeside(i, 1);
      if (low < 0 || high < 0)
      {
        continue; // a closed curve without a sharp bend
      }
      const double begin = this->Unmoved[low] + lowShift, end = this->Unmoved[high] + highShift;
      const double share = (this->Unmoved[i] - begin) / (end - begin);
      this->Lengths[i] =
        (1.0 - share) * (this->Lengths[low] + lowShift) + share * (this->Lengths[high] + highShift);
    }
  }

  /// Returns the next fixed point in a direction, or -1, and the offset to its arc length if the
  /// chain is closed and the search passed its beginning.
  std::pair<int, double> FixedBeside(std::size_t i, int step) const
  {
    const auto count = static_cast<int>(this->Lengths.size());
    for (int k = 1; k <= count; ++k)
    {
      const int at = static_cast<int>(i) + k * step;
      const int wrapped = (at % count + count) % count;
      if (this->Fixed[wrapped])
      {
        const double turns = at < 0 ? -1.0 : (at >= count ? 1.0 : 0.0);
        return { wrapped, turns * this->Along.Length() * (this->Scale > 0.0 ? 1.0 : -1.0) };
      }
    }
    return { -1, 0.0 };
  }

  double Bound(std::size_t i, int step, double side) const
  {
    const auto [fixed, shift] = this->FixedBeside(i, step);
    return fixed < 0 ? side * std::numeric_limits<double>::infinity()
                     : this->Lengths[fixed] + shift;
  }

  const ArcLength& Along;
  const std::vector<double> Own;
  const double Scale;
  const bool Closed;
  std::vector<double> Lengths; ///< arc lengths on the curve
  std::vector<double> Unmoved; ///< arc lengths before any point was fixed
  std::vector<char> Fixed;
};

} // namespace

CurvePositions DistributeAlongCurve(
  const Eigen::MatrixXd& chain, const Mesh& surface, const FeatureCurve& curve)
{
  const ArcLength along(surface, curve);
  const Eigen::Index count = chain.rows();
  std::vector<double> lengths = { 0.0 };
  for (Eigen::Index i = 1; i < count; ++i)
  {
    lengths.push_back(lengths.back() + (chain.row(i) - chain.row(i - 1)).norm());
  }
  const double whole =
    lengths.back() + (curve.Closed ? (chain.row(0) - chain.row(count - 1)).norm() : 0.0);
  const double nearest = curve.Closed ? along.Nearest(chain.row(0)) : 0.0;
  CurvePositions best;
  double minimum = std::numeric_limits<double>::infinity();
  // The chain and the curve may run in opposite directions: the one that moves the points less is
  // taken.
  for (const double direction : { 1.0, -1.0 })
  {
    const double first = curve.Closed || direction > 0.0 ? nearest : along.Length();
    CurvePositions positions =
      Spread(along, lengths, whole, first, direction, curve.Closed).Result();
    if (const double sum = (positions.Positions - chain).rowwise().norm().sum(); sum < minimum)
    {
      minimum = sum;
      best = std::move(positions);
    }
  }
  return best;
}

} // namespace shape
