#include "Correspondence/Conformal/Private/SampleTriples.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace shape
{
namespace
{

bool IsSimilarLength(double one, double other, double tolerance)
{
  return one > 0.0 && other > 0.0 && std::abs(one - other) <= tolerance * std::max(one, other);
}

} // namespace

std::vector<TriplePair> FindSimilarTriples(const Eigen::MatrixXd& betweenA,
  const Eigen::MatrixXd& betweenB, int generators, double tolerance, int paired)
{
  const auto ofA = static_cast<int>(std::min<Eigen::Index>(generators, betweenA.rows())),
             ofB = static_cast<int>(std::min<Eigen::Index>(generators, betweenB.rows()));
  const auto mayMeet = [&](int i, int l) { return i == l || (i >= paired && l >= paired); };
  const auto agree = [&](int i, int l, int j, int m)
  {
    const bool areGiven = std::max({ i, j, l, m }) < paired;
    return l != m && mayMeet(j, m) &&
      (areGiven || IsSimilarLength(betweenA(i, j), betweenB(l, m), tolerance));
  };
  std::vector<TriplePair> pairs;
  for (int i = 0; i < ofA; ++i)
  {
    for (int j = i + 1; j < ofA; ++j)
    {
      for (int l = 0; l < ofB; ++l)
      {
        for (int m = 0; m < ofB; ++m)
        {
          if (!mayMeet(i, l) || !agree(i, l, j, m))
          {
            continue;
          }
          for (int k = j + 1; k < ofA; ++k)
          {
            for (int n = 0; n < ofB; ++n)
            {
              if (agree(i, l, k, n) && agree(j, m, k, n))
              {
                pairs.push_back({ { i, j, k }, { l, m, n } });
              }
            }
          }
        }
      }
    }
  }
  return pairs;
}

/// Selection sampling, which depends on no library's distributions.
std::vector<TriplePair> SelectTriples(const std::vector<TriplePair>& all, int count)
{
  std::mt19937 random(1);
  std::vector<TriplePair> some;
  auto wanted = static_cast<std::size_t>(count);
  for (std::size_t i = 0; i < all.size() && wanted > 0; ++i)
  {
    if (random() * (1.0 / 4294967296.0) * static_cast<double>(all.size() - i) <
      static_cast<double>(wanted))
    {
      some.push_back(all[i]);
      --wanted;
    }
  }
  return some;
}

} // namespace shape
