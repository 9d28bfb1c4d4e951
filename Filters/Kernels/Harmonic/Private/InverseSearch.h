#pragma once

#include "Harmonic/PiecewiseHarmonicMap.h"
#include "Harmonic/PointCharges.h"

#include <functional>
#include <utility>

// Inside InverseMap: the search for places whose images are given.
namespace shape
{

/// Progress through a number of steps that nobody knows: each takes a tenth of what is left.
class Steps
{
public:
  explicit Steps(Progress progress)
    : Whole(std::move(progress))
  {
  }
  Progress Next()
  {
    const double begin = this->Done;
    this->Done += 0.1 * (1.0 - begin);
    return this->Whole.Part(begin, this->Done);
  }

private:
  Progress Whole;
  double Done = 0.0;
};

/// The map whose values are searched for; the one it is made from must live as long.
struct SearchedMap
{
  using Function =
    std::function<Eigen::MatrixXd(const Eigen::MatrixXd& points, const Progress& progress)>;
  Function Evaluate;  ///< n x 3
  Function Jacobians; ///< n x 9

  SearchedMap(const PointCharges& map);
  SearchedMap(const PiecewiseHarmonicMap& map);
};

/// Positions on their way to preimages of targets (each n x 3).
struct Search
{
  Eigen::MatrixXd Positions;
  Eigen::MatrixXd Targets;
  Eigen::MatrixXd Values; ///< f at the places
  Eigen::VectorXd Misses; ///< |Values - Targets|
};

struct Limits
{
  double Goal;    ///< a miss that is small enough
  double MaxStep; ///< how far one step goes at most
  int Iterations;
};

/// The search that begins at `places`.
Search StartSearch(const SearchedMap& map, const Eigen::MatrixXd& positions,
  const Eigen::MatrixXd& targets, const Progress& progress);

/// Newton's method from every place: until it misses by no more than the goal and gets no closer.
void IterateNewton(const SearchedMap& map, Search& search, const Limits& limits, Steps& progress);

/// From places whose images move in straight lines to the targets: each step is found by Newton's
/// method, twice as long as the last where that succeeds, and half as long where it fails.
Search WalkToTargets(const SearchedMap& map, const Eigen::MatrixXd& starts,
  const Eigen::MatrixXd& targets, const Limits& limits, Steps& progress);

/// Row i of a result of Jacobians, as a matrix.
Eigen::Matrix3d GetJacobian(const Eigen::MatrixXd& jacobians, Eigen::Index i);

} // namespace shape
