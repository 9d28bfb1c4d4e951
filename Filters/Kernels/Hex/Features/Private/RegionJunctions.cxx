#include "Hex/Features/Private/RegionJunctions.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

/// Lengths of short curves in cells. Chains of the grid may wind around a point more than curves of
/// the surfaces.
constexpr double ShortestChain = 2.5, ShortestCurve = 1.0;

/// The length of a curve that is not closed.
double LengthOf(const RegionNetwork::Curve& curve, const Eigen::MatrixXd& points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < curve.Points.size(); ++i)
  {
    length += (points.row(curve.Points[i]) - points.row(curve.Points[i - 1])).norm();
  }
  return length;
}

void SortUnique(std::vector<int>& values)
{
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

} // namespace

RegionJunctions::RegionJunctions(const RegionNetwork& network, const Eigen::MatrixXd& points,
  double shortest, const std::vector<char>& isLoose)
  : IsInside(network.Curves.size(), 0)
  , Of(network.Corners.size())
{
  std::map<int, int> indexOf;
  for (const int corner : network.Corners)
  {
    indexOf.emplace(corner, static_cast<int>(indexOf.size()));
  }
  DisjointSets sets(static_cast<int>(network.Corners.size()));
  for (std::size_t i = 0; i < network.Curves.size(); ++i)
  {
    const RegionNetwork::Curve& curve = network.Curves[i];
    if (curve.Closed)
    {
      continue;
    }
    const int begin = indexOf.at(curve.Points.front()), end = indexOf.at(curve.Points.back());
    const bool joins = network.CornerLabels[begin] == network.CornerLabels[end] ||
      (!isLoose.empty() && isLoose[begin] && isLoose[end]);
    if (curve.Labels.size() > 3 || (joins && LengthOf(curve, points) < shortest))
    {
      sets.Merge(begin, end);
      this->IsInside[i] = 1;
    }
  }
  std::map<int, int> numberOf;
  for (int i = 0; i < static_cast<int>(this->Of.size()); ++i)
  {
    this->Of[i] = numberOf.emplace(sets.Find(i), static_cast<int>(numberOf.size())).first->second;
    this->Number[network.Corners[i]] = this->Of[i];
  }
  this->Corners.resize(numberOf.size());
  this->Labels.resize(numberOf.size());
  for (std::size_t i = 0; i < this->Of.size(); ++i)
  {
    this->Corners[this->Of[i]].push_back(network.Corners[i]);
    std::vector<int>& labels = this->Labels[this->Of[i]];
    labels.insert(labels.end(), network.CornerLabels[i].begin(), network.CornerLabels[i].end());
  }
  std::for_each(this->Labels.begin(), this->Labels.end(), SortUnique);
  this->Middles.resize(static_cast<Eigen::Index>(this->Corners.size()), 3);
  for (Eigen::Index i = 0; i < this->Middles.rows(); ++i)
  {
    this->Middles.row(i) = points(this->Corners[i], Eigen::all).colwise().mean();
  }
}

namespace
{

/// Assigns the closest pairs first.
void AssignJunctions(JunctionMatch& match)
{
  std::vector<std::tuple<double, int, int>> pairs;
  for (int i = 0; i < static_cast<int>(match.Own.Labels.size()); ++i)
  {
    for (int j = 0; j < static_cast<int>(match.Wanted.Labels.size()); ++j)
    {
      if (match.Own.Labels[i] == match.Wanted.Labels[j])
      {
        pairs.emplace_back((match.Own.Middles.row(i) - match.Wanted.Middles.row(j)).norm(), i, j);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  std::set<int> taken;
  match.WantedOf.clear();
  for (const auto& [distance, i, j] : pairs)
  {
    if (!match.WantedOf.count(i) && taken.insert(j).second)
    {
      match.WantedOf[i] = j;
    }
  }
}

} // namespace

JunctionMatch MatchJunctions(const RegionNetwork& own, const Eigen::MatrixXd& ownPoints,
  const RegionNetwork& wanted, const Eigen::MatrixXd& wantedPoints, double cellSize)
{
  const double shortestChain = ShortestChain * cellSize, shortestCurve = ShortestCurve * cellSize;
  JunctionMatch match{ { own, ownPoints, shortestChain }, { wanted, wantedPoints, shortestCurve },
    {} };
  AssignJunctions(match);
  if (match.WantedOf.size() == match.Wanted.Corners.size())
  {
    return match;
  }
  std::vector<char> isAlone(own.Corners.size(), 1), isWantedAlone(wanted.Corners.size(), 1);
  std::set<int> found;
  for (const auto& [i, j] : match.WantedOf)
  {
    found.insert(j);
  }
  for (std::size_t i = 0; i < isAlone.size(); ++i)
  {
    isAlone[i] = static_cast<char>(match.WantedOf.count(match.Own.Of[i]) == 0);
  }
  for (std::size_t j = 0; j < isWantedAlone.size(); ++j)
  {
    isWantedAlone[j] = static_cast<char>(found.count(match.Wanted.Of[j]) == 0);
  }
  match.Own = { own, ownPoints, shortestChain, isAlone };
  match.Wanted = { wanted, wantedPoints, shortestCurve, isWantedAlone };
  AssignJunctions(match);
  return match;
}

} // namespace shape
