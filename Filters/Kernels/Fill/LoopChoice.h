#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Which loops of a surface are meant.
struct LoopChoice
{
  enum class LoopsType
  {
    All,
    Longest,
    Chosen
  };
  LoopsType Loops = LoopsType::All;
  std::vector<int> Indices; ///< for Chosen: in the order of FindBoundaryLoops, the longest being 0
  double MaximumLength = 0.0; ///< around the loop, in the model's units; 0: any. >= 0
};

/// The chosen ones of a surface's loops, by index. Throws InvalidInput where an option is out of
/// range, with the number of loops.
std::vector<int> ChooseLoops(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& loops, const LoopChoice& choice);

/// How long a closed line through points is.
double ComputeLoopLength(const Eigen::MatrixXd& points, const std::vector<int>& loop);

/// The farthest of points (n x 3) from the plane that fits them best, over their greatest distance
/// from their mean, doubled.
double ComputeNonplanarity(const Eigen::MatrixXd& points);

/// Throws InvalidInput where a loop has fewer than 3 points, one that the surface lacks, or where a
/// coordinate is not finite.
void RequireLoops(const Eigen::MatrixXd& points, const std::vector<std::vector<int>>& loops);

} // namespace shape
