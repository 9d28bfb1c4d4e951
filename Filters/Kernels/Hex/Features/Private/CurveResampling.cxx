#include "Hex/Features/Private/CurveResampling.h"

#include "Hex/Features/Private/ArcLength.h"
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

/// Returns the arc length of each point of a chain and, if it is closed, of its first point again.
/// Edges whose ends lie at the same position, because one is a copy of the other, get a length.
std::vector<double> MeasureChain(const Eigen::MatrixXd& chain, bool isClosed)
{
  constexpr double shortest = 0.5; // of the mean length
  const Eigen::Index count = chain.rows(), edges = count - (isClosed ? 0 : 1);
  Eigen::VectorXd own(edges);
  for (Eigen::Index i = 0; i < edges; ++i)
  {
    own(i) = (chain.row((i + 1) % count) - chain.row(i)).norm();
  }
  const double mean = std::max(own.mean(), std::numeric_limits<double>::min());
  std::vector<double> lengths = { 0.0 };
  for (const double length : own.cwiseMax(shortest * mean).eval())
  {
    lengths.push_back(lengths.back() + length);
  }
  return lengths;
}

/// Points of a chain by arc length on a curve; some are fixed at bends.
class Spread
{
public:
  /// own: arc length of each point on the chain (MeasureChain). first: where the chain begins on
  /// the curve. tolerance: the distance between curve and chain that is small enough.
  /// shortest: the least fraction of its length that an edge keeps where points move to bends.
  Spread(const ArcLength& along, const std::vector<double>& own, double first, double direction,
    bool isClosed, double tolerance, double shortest)
    : Along(&along)
    , Scale(direction * along.Length() / own.back())
    , Closed(isClosed)
    , Tolerance(tolerance)
    , Shortest(shortest)
  {
    for (std::size_t i = 0; i + (isClosed ? 1 : 0) < own.size(); ++i)
    {
      this->Lengths.push_back(first + this->Scale * own[i]);
    }
    this->Unmoved = this->Lengths;
    this->Fixed.assign(this->Lengths.size(), 0);
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

  /// Returns the position of each point of the chain (n x 3).
  Eigen::MatrixXd Positions() const
  {
    Eigen::MatrixXd positions(static_cast<Eigen::Index>(this->Lengths.size()), 3);
    for (std::size_t i = 0; i < this->Lengths.size(); ++i)
    {
      positions.row(static_cast<Eigen::Index>(i)) = this->Along->At(this->Lengths[i]);
    }
    return positions;
  }

  CurvePositions Result() const
  {
    CurvePositions result;
    result.Positions = this->Positions();
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
      result.Spans.push_back(this->Along->Part(low, high));
    }
    return result;
  }

  /// Returns the largest distance of an edge of the chain from its part of the curve.
  double MaximumDeviation() const { return this->Deviations().maxCoeff(); }

  /// Returns arc lengths on the chain (MeasureChain) with shorter edges where an edge is farther
  /// from the curve than the tolerance: the distance falls with the square of the length.
  std::vector<double> Refined(const std::vector<double>& own) const
  {
    constexpr double least = 0.6, safety = 0.8; // of the length; of the tolerance
    const Eigen::VectorXd deviations = this->Deviations();
    Eigen::VectorXd factors(deviations.size());
    for (Eigen::Index edge = 0; edge < factors.size(); ++edge)
    {
      factors(edge) = deviations(edge) > this->Tolerance
        ? std::max(least, std::sqrt(safety * this->Tolerance / deviations(edge)))
        : 1.0;
    }
    std::vector<double> refined = { 0.0 };
    const Eigen::Index count = factors.size();
    for (Eigen::Index edge = 0; edge < count; ++edge)
    {
      // Neighbours follow half way, so that lengths change gradually.
      const bool hasBefore = this->Closed || edge > 0, hasAfter = this->Closed || edge + 1 < count;
      const double beside = std::min(hasBefore ? factors((edge + count - 1) % count) : 1.0,
        hasAfter ? factors((edge + 1) % count) : 1.0);
      refined.push_back(refined.back() +
        std::min(factors(edge), 0.5 * (1.0 + beside)) * (own[edge + 1] - own[edge]));
    }
    return refined;
  }

private:
  /// Returns the deviation of each edge of the chain.
  Eigen::VectorXd Deviations() const
  {
    Eigen::VectorXd deviations(static_cast<Eigen::Index>(this->Edges()));
    for (std::size_t edge = 0; edge < this->Edges(); ++edge)
    {
      deviations(static_cast<Eigen::Index>(edge)) =
        this->Deviation(this->Lengths[edge], this->After(edge));
    }
    return deviations;
  }

  double Step() const { return this->Along->Length() / static_cast<double>(this->Edges()); }

  /// Returns the arc length of the next point along the chain, beyond the curve's range if the
  /// chain is closed and begins again.
  double After(std::size_t i) const
  {
    return i + 1 < this->Lengths.size()
      ? this->Lengths[i + 1]
      : this->Lengths.front() + std::copysign(this->Along->Length(), this->Scale);
  }

  /// Returns the arc length of the point before along the chain, as After.
  double Before(std::size_t i) const
  {
    return i > 0 ? this->Lengths[i - 1]
                 : this->Lengths.back() - std::copysign(this->Along->Length(), this->Scale);
  }

  /// The number of edges of the chain.
  std::size_t Edges() const { return this->Lengths.size() - (this->Closed ? 0 : 1); }

  double Deviation(double one, double other) const
  {
    return this->Along->Deviation(std::min(one, other), std::max(one, other));
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
            this->Along->Deviation(low - by, high + by) <=
              std::max(this->Tolerance, slack * this->Along->Deviation(low, high));
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
    constexpr double near = 0.6; // steps
    constexpr std::size_t most = 4;
    std::vector<std::vector<double>> choices;
    for (std::size_t i = 0; i < this->Lengths.size(); ++i)
    {
      const double here = this->Lengths[i];
      choices.push_back({ here });
      if (!this->Fixed[i])
      {
        // Edges may be much longer than the mean: every bend has to be near a point.
        double low = here - near * this->Step(), high = here + near * this->Step();
        for (const double other : { this->Before(i), this->After(i) })
        {
          low = std::min(low, here + near * (other - here));
          high = std::max(high, here + near * (other - here));
        }
        std::vector<double> bends = this->Along->BendsBetween(low, high);
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
        around.push_back({ first + std::copysign(this->Along->Length(), this->Scale) });
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
    const double length = this->After(edge) - this->Lengths[edge];
    const double ratio = (end - begin) / length, deviation = this->Deviation(begin, end);
    if (!(ratio >= this->Shortest))
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
      ? length + this->Along->Length() * std::round((other - length) / this->Along->Length())
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
        return { wrapped, turns * this->Along->Length() * (this->Scale > 0.0 ? 1.0 : -1.0) };
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

  const ArcLength* Along;
  double Scale;
  bool Closed;
  double Tolerance;
  double Shortest;
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
  const std::vector<double> lengths = MeasureChain(chain, curve.Closed);
  const double nearest = curve.Closed ? along.Nearest(chain.row(0)) : 0.0;
  // The chain and the curve may run in opposite directions: the one that moves the points less is
  // taken.
  constexpr double uneven = 0.3, even = 0.6;
  const auto spread = [&](double direction, const std::vector<double>& own, double shortest)
  {
    const double first = curve.Closed || direction > 0.0 ? nearest : along.Length();
    return Spread(along, own, first, direction, curve.Closed, tolerance, shortest);
  };
  const auto movement = [&](const Spread& points)
  { return (points.Positions() - chain).rowwise().norm().sum(); };
  Spread points = spread(1.0, lengths, uneven);
  double direction = 1.0;
  if (Spread other = spread(-1.0, lengths, uneven); movement(other) < movement(points))
  {
    points = std::move(other);
    direction = -1.0;
  }
  // Points gather where the curve bends, if that brings all edges near it. Otherwise there are too
  // few points, and uneven edges would only make worse hexahedra.
  constexpr int rounds = 4;
  std::vector<double> refined = lengths;
  for (int round = 0; round < rounds && points.MaximumDeviation() > tolerance; ++round)
  {
    refined = points.Refined(refined);
    points = spread(direction, refined, uneven);
  }
  return points.MaximumDeviation() <= tolerance ? points.Result()
                                                : spread(direction, lengths, even).Result();
}

} // namespace shape
