#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Selects some of a surface's loops.
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
  double MaximumLength = 0.0; ///< of a loop, in the model's units; 0: any. >= 0
};

/// The indices of the selected loops. Throws InvalidInput if an option is out of range, with the
/// number of loops.
std::vector<int> ChooseLoops(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& loops, const LoopChoice& choice);

/// The length of a closed curve through points.
double ComputeLoopLength(const Eigen::MatrixXd& points, const std::vector<int>& loop);

/// The maximum distance of points (n x 3) from the plane that fits them best, over twice their
/// maximum distance from their mean.
double ComputeNonplanarity(const Eigen::MatrixXd& points);

/// Throws InvalidInput if a loop has fewer than 3 points or one out of range, or if a coordinate is
/// not finite.
void RequireLoops(const Eigen::MatrixXd& points, const std::vector<std::vector<int>>& loops);

} // namespace shape
