#pragma once

#include "Harmonic/PiecewiseHarmonicMap.h"
#include "Harmonic/PointCharges.h"

#include <functional>
#include <utility>

// Private to InverseMap: the search for positions with given images.
namespace shape
{

/// Progress through an unknown number of steps: each takes a tenth of the remainder.
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

/// The map to invert. It refers to the map that it is constructed from, which must outlive it.
struct SearchedMap
{
  using Function =
    std::function<Eigen::MatrixXd(const Eigen::MatrixXd& points, const Progress& progress)>;
  Function Evaluate;  ///< n x 3
  Function Jacobians; ///< n x 9

  SearchedMap(const PointCharges& map);
  SearchedMap(const PiecewiseHarmonicMap& map);
};

/// Iterates that converge to the preimages of targets (each n x 3).
struct Search
{
  Eigen::MatrixXd Positions;
  Eigen::MatrixXd Targets;
  Eigen::MatrixXd Values; ///< f at Positions
  Eigen::VectorXd Misses; ///< |Values - Targets|
};

struct Limits
{
  double Goal;    ///< a miss at most this large is accepted
  double MaxStep; ///< maximum length of one step
  int Iterations;
};

/// Starts a search at `positions`.
Search StartSearch(const SearchedMap& map, const Eigen::MatrixXd& positions,
  const Eigen::MatrixXd& targets, const Progress& progress);

/// Runs Newton's method from every position, until its miss is at most the goal and no longer
/// decreases.
void IterateNewton(const SearchedMap& map, Search& search, const Limits& limits, Steps& progress);

/// Continues from `starts` while the images move to the targets on straight lines. Newton's method
/// solves each step. A step is twice as long as the last if that succeeded, half as long if it
/// failed.
Search WalkToTargets(const SearchedMap& map, const Eigen::MatrixXd& starts,
  const Eigen::MatrixXd& targets, const Limits& limits, Steps& progress);

/// Returns row i of a result of Jacobians as a matrix.
Eigen::Matrix3d GetJacobian(const Eigen::MatrixXd& jacobians, Eigen::Index i);

} // namespace shape
