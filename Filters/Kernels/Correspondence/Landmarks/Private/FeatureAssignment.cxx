#include "Correspondence/Landmarks/Private/FeatureAssignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace shape
{
namespace
{

constexpr double LevelTolerance = 0.5; // of the logarithms of levels

/// All pairs of features that may correspond, and the agreement of every two pairs.
class Agreement
{
public:
  Agreement(const Eigen::MatrixXd& distancesA, const Eigen::MatrixXd& distancesB,
    const Eigen::VectorXd& levelsA, const Eigen::VectorXd& levelsB, double tolerance)
  {
    for (int i = 0; i < static_cast<int>(levelsA.size()); ++i)
    {
      for (int j = 0; j < static_cast<int>(levelsB.size()); ++j)
      {
        if (std::abs(std::log(levelsA(i) / levelsB(j))) < LevelTolerance)
        {
          this->Pairs.push_back({ i, j });
        }
      }
    }
    const int count = this->Count();
    this->Gain.setConstant(count, count, -1.0);
    for (int p = 0; p < count; ++p)
    {
      for (int q = 0; q < count; ++q)
      {
        const auto [a, b] = this->Pairs[p];
        const auto [c, d] = this->Pairs[q];
        if (a != c && b != d)
        {
          const double own = distancesA(a, c), other = distancesB(b, d);
          const double difference = (own - other) / std::max(own, other) / tolerance;
          // Minus a half: a pair of pairs that agrees by less lowers the score.
          this->Gain(p, q) = std::exp(-0.5 * difference * difference) - 0.5;
        }
      }
    }
  }

  int Count() const { return static_cast<int>(this->Pairs.size()); }

  /// Adds pairs to `chosen` as long as one raises the score.
  /// Greedy: always the pair with the largest gain from all chosen ones.
  void Extend(std::vector<int>& chosen) const
  {
    Eigen::VectorXd gains = Eigen::VectorXd::Zero(this->Count());
    std::vector<char> isFree(this->Count(), 1);
    const auto take = [&](int p)
    {
      gains += this->Gain.col(p);
      for (int q = 0; q < this->Count(); ++q)
      {
        isFree[q] &=
          this->Pairs[q][0] != this->Pairs[p][0] && this->Pairs[q][1] != this->Pairs[p][1];
      }
    };
    std::for_each(chosen.begin(), chosen.end(), take);
    for (;;)
    {
      int best = -1;
      for (int q = 0; q < this->Count(); ++q)
      {
        if (isFree[q] && gains(q) > (best < 0 ? 0.0 : gains(best)))
        {
          best = q;
        }
      }
      if (best < 0)
      {
        return;
      }
      chosen.push_back(best);
      take(best);
    }
  }

  // The diagonal of Gain is -1, since a pair excludes itself: its sum over the chosen is added
  // back.
  double Score(const std::vector<int>& chosen) const
  {
    return 0.5 * (this->Gain(chosen, chosen).sum() + static_cast<double>(chosen.size()));
  }

  std::vector<std::array<int, 2>> Pairs;
  Eigen::MatrixXd Gain; ///< of two pairs; -1 if they exclude each other
};

} // namespace

std::vector<FeatureAssignment> AssignFeatures(const Eigen::MatrixXd& distancesA,
  const Eigen::MatrixXd& distancesB, const Eigen::VectorXd& levelsA, const Eigen::VectorXd& levelsB,
  double tolerance, int count, const Progress& progress)
{
  const Agreement agreement(distancesA, distancesB, levelsA, levelsB, tolerance);
  std::map<std::vector<int>, double> found;
  // Two pairs agree on one distance, three on three: the smallest seed that is rarely a
  // coincidence.
  for (int p = 0; p < agreement.Count(); ++p)
  {
    progress(static_cast<double>(p) / agreement.Count());
    for (int q = p + 1; q < agreement.Count(); ++q)
    {
      for (int r = q + 1; agreement.Gain(p, q) > 0.0 && r < agreement.Count(); ++r)
      {
        if (agreement.Gain(p, r) > 0.0 && agreement.Gain(q, r) > 0.0)
        {
          std::vector<int> chosen = { p, q, r };
          agreement.Extend(chosen);
          std::sort(chosen.begin(), chosen.end());
          // Many seeds grow to the same assignment; it is stored once.
          found.try_emplace(chosen, agreement.Score(chosen));
        }
      }
    }
  }
  std::vector<FeatureAssignment> assignments;
  for (const auto& [chosen, score] : found)
  {
    FeatureAssignment assignment{ {}, score };
    for (const int p : chosen)
    {
      assignment.Pairs.push_back(agreement.Pairs[p]);
    }
    assignments.push_back(std::move(assignment));
  }
  std::stable_sort(assignments.begin(), assignments.end(),
    [](const auto& one, const auto& other) { return one.Score > other.Score; });
  assignments.resize(std::min<std::size_t>(assignments.size(), count));
  return assignments;
}

} // namespace shape
