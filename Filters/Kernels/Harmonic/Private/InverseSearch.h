#pragma once

#include "Harmonic/PiecewiseHarmonicMap.h"
#include "Harmonic/PointCharges.h"

#include <functional>
#include <utility>

// Private to InverseMap: the search for positions with given images.
namespace shape
{

/// Progress through an unknown number of steps. Each step takes a share of the
/// remaining progress.
class Steps
{
public:
  explicit Steps(Progress progress, double share = 0.1)
    : Whole(std::move(progress))
    , Share(share)
  {
  }
  Progress Next()
  {
    const double begin = this->Done;
    this->Done += this->Share * (1.0 - begin);
    return this->Whole.Part(begin, this->Done);
  }

private:
  Progress Whole;
  double Share;
  double Done = 0.0;
};

/// The map to invert. It keeps a reference to the map passed to the constructor, which must outlive
/// it.
struct SearchedMap
{
  using Function =
    std::function<Eigen::MatrixXd(const Eigen::MatrixXd& points, const Progress& progress)>;
  Function Evaluate;  ///< n x 3
  Function Jacobians; ///< n x 9

  SearchedMap(const PointCharges& map);
  SearchedMap(const PiecewiseHarmonicMap& map);
};

/// The state of an iteration towards the preimages of n targets.
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

/// Runs Newton's method from every position until the miss is at most the goal and no longer
/// decreases.
void IterateNewton(const SearchedMap& map, Search& search, const Limits& limits, Steps& progress);

/// Moves the images of `starts` to the targets on straight lines, step by step, and follows the
/// preimages by Newton's method. The next step is twice as long after a successful step, and half
/// as long after a failed one.
Search WalkToTargets(const SearchedMap& map, const Eigen::MatrixXd& starts,
  const Eigen::MatrixXd& targets, const Limits& limits, Steps& progress);

} // namespace shape
