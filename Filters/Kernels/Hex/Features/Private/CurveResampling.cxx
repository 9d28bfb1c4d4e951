#include "Hex/Features/Private/CurveResampling.h"

#include "Hex/Features/Private/ChoicePath.h"
#include "Mesh/Extent.h"

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
    constexpr double straight = 2.0; // degrees
    this->Bends = this->Turns(straight);
    std::sort(this->Bends.begin(), this->Bends.end());
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

  /// Returns the arc lengths of the bends strictly between two arc lengths, nearly straight ones
  /// left out; on a closed line these may exceed its range.
  std::vector<double> BendsBetween(double begin, double end) const
  {
    return this->Between(this->Bends, begin, end);
  }

  /// Returns the largest distance of the part between two arc lengths from its chord.
  double Deviation(double begin, double end) const
  {
    const Eigen::RowVector3d low = this->At(begin), chord = this->At(end) - low;
    const double squared = std::max(chord.squaredNorm(), std::numeric_limits<double>::min());
    double maximum = 0.0;
    for (const double point : this->Between(this->Lengths, begin, end))
    {
      const Eigen::RowVector3d off = this->At(point) - low;
      const double share = std::clamp(off.dot(chord) / squared, 0.0, 1.0);
      maximum = std::max(maximum, (off - share * chord).norm());
    }
    return maximum;
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
  /// Returns those of ascending arc lengths on the line that are strictly between two others.
  std::vector<double> Between(const std::vector<double>& lengths, double begin, double end) const
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

  Eigen::MatrixXd Points;
  bool Closed;
  std::vector<double> Lengths; ///< arc length at each point; if closed, also back at the first
  std::vector<double> Bends;   ///< arc lengths at bends, ascending
};

/// Points of a chain by arc length on a curve; some are fixed at bends.
class Spread
{
public:
  /// own: arc length of each point on the chain. first: where the chain begins on the curve.
  /// tolerance: the distance between curve and chain that is small enough.
  Spread(const ArcLength& along, std::vector<double> own, double whole, double first,
    double direction, bool isClosed, double tolerance)
    : Along(along)
    , Own(std::move(own))
    , Scale(direction * along.Length() / whole)
    , Closed(isClosed)
    , Tolerance(tolerance)
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
    this->MoveToBends();
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
        const double maximum = this->Reach(i) * this->Step();
        low = std::max(here - maximum, this->Bound(i, this->Scale > 0.0 ? -1 : 1, -1.0));
        high = std::min(here + maximum, this->Bound(i, this->Scale > 0.0 ? 1 : -1, 1.0));
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

  /// Returns the arc length of the next point along the chain, beyond the curve's range if the
  /// chain is closed and begins again.
  double After(std::size_t i) const
  {
    return i + 1 < this->Lengths.size()
      ? this->Lengths[i + 1]
      : this->Lengths.front() + std::copysign(this->Along.Length(), this->Scale);
  }

  /// The number of edges of the chain.
  std::size_t Edges() const { return this->Lengths.size() - (this->Closed ? 0 : 1); }

  double Deviation(double one, double other) const
  {
    return this->Along.Deviation(std::min(one, other), std::max(one, other));
  }

  /// Returns how far a point may move to each side, in mean steps. Its edges must stay within the
  /// tolerance if their other ends move by the same, or deviate little more than before.
  double Reach(std::size_t i) const
  {
    constexpr double reaches[] = { 4.0, 1.0, 0.4, 0.2, 0.1 };
    constexpr double least = 0.05, slack = 1.2;
    const std::size_t count = this->Lengths.size();
    for (const double reach : reaches)
    {
      bool isNear = true;
      for (const std::size_t edge : { (i + count - 1) % count, i })
      {
        if (edge < this->Edges())
        {
          const double low = std::min(this->Lengths[edge], this->After(edge)),
                       high = std::max(this->Lengths[edge], this->After(edge)),
                       by = reach * this->Step();
          isNear = isNear &&
            this->Along.Deviation(low - by, high + by) <=
              std::max(this->Tolerance, slack * this->Along.Deviation(low, high));
        }
      }
      if (isNear)
      {
        return reach;
      }
    }
    return least;
  }

  /// Returns, for each point, the arc lengths that it may take: its own and, if it is free, those
  /// of the nearest bends.
  std::vector<std::vector<double>> FindChoices() const
  {
    constexpr double near = 0.6; // mean steps
    constexpr std::size_t most = 4;
    std::vector<std::vector<double>> choices;
    for (std::size_t i = 0; i < this->Lengths.size(); ++i)
    {
      const double here = this->Lengths[i];
      choices.push_back({ here });
      if (!this->Fixed[i])
      {
        std::vector<double> bends =
          this->Along.BendsBetween(here - near * this->Step(), here + near * this->Step());
        std::sort(bends.begin(), bends.end(),
          [&](double a, double b) { return std::abs(a - here) < std::abs(b - here); });
        bends.resize(std::min(bends.size(), most));
        choices[i].insert(choices[i].end(), bends.begin(), bends.end());
      }
    }
    return choices;
  }

  /// Moves free points to bends of the curve near them, or leaves them, so that the edges of the
  /// chain deviate little from the curve and keep about their lengths: the shortest path through
  /// the choices of all points. An edge with a bend in its middle would cut it off.
  void MoveToBends()
  {
    const std::vector<std::vector<double>> choices = this->FindChoices();
    const auto cost = [this](std::size_t edge, double begin, double end)
    { return this->EdgeCost(edge, begin, end); };
    ChoicePath best;
    if (!this->Closed)
    {
      best = FindShortestPath(choices, cost);
    }
    else
    {
      // The first point is also the end of the last edge.
      for (const double first : choices[0])
      {
        std::vector<std::vector<double>> around = choices;
        around[0] = { first };
        around.push_back({ first + std::copysign(this->Along.Length(), this->Scale) });
        if (ChoicePath path = FindShortestPath(around, cost); path.Cost < best.Cost)
        {
          best = std::move(path);
          best.Values.pop_back();
        }
      }
    }
    if (std::isfinite(best.Cost))
    {
      this->Lengths = best.Values;
    }
  }

  /// The cost of an edge of the chain whose ends have these arc lengths: it grows with the edge's
  /// deviation from the curve, and with the change of its length.
  double EdgeCost(std::size_t edge, double begin, double end) const
  {
    constexpr double shortest = 0.3; // of its length before
    const double length = this->After(edge) - this->Lengths[edge];
    const double ratio = (end - begin) / length, deviation = this->Deviation(begin, end);
    if (!(ratio >= shortest))
    {
      return std::numeric_limits<double>::infinity();
    }
    const double squared = deviation * deviation / (this->Tolerance * this->Tolerance);
    return squared * squared + (ratio - 1.0) * (ratio - 1.0);
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
  const double Tolerance;
  std::vector<double> Lengths; ///< arc lengths on the curve
  std::vector<double> Unmoved; ///< arc lengths before any point was fixed
  std::vector<char> Fixed;
};

} // namespace

double ComputeCreaseTolerance(const Mesh& surface)
{
  constexpr double share = 0.8e-3;
  return share * ComputeBoxDiagonal(surface.Points);
}

CurvePositions DistributeAlongCurve(
  const Eigen::MatrixXd& chain, const Mesh& surface, const FeatureCurve& curve, double tolerance)
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
      Spread(along, lengths, whole, first, direction, curve.Closed, tolerance).Result();
    if (const double sum = (positions.Positions - chain).rowwise().norm().sum(); sum < minimum)
    {
      minimum = sum;
      best = std::move(positions);
    }
  }
  return best;
}

} // namespace shape
