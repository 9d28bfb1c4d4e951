#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A selection of a surface's boundary loops.
struct LoopChoice
{
  enum class LoopsType
  {
    All,
    Longest,
    Chosen
  };
  LoopsType Loops = LoopsType::All;
  /// If Loops is Chosen: indices of loops in the order of FindBoundaryLoops. Loop 0 is the longest.
  std::vector<int> Indices;
  double MaximumLength = 0.0; ///< of a loop, in the model's units; >= 0; 0 means no maximum
};

/// Returns the indices of the selected loops. Throws InvalidInput if an option is out of range; the
/// message gives the number of loops.
std::vector<int> ChooseLoops(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& loops, const LoopChoice& choice);

/// Returns the length of a closed curve through points.
double ComputeLoopLength(const Eigen::MatrixXd& points, const std::vector<int>& loop);

/// Returns the maximum distance of points (n x 3) from the plane that fits them best, divided by
/// twice the maximum distance of a point from the mean of all points.
double ComputeNonplanarity(const Eigen::MatrixXd& points);

/// Throws InvalidInput if a loop has fewer than 3 points or a point that is out of range, or if a
/// coordinate is not finite.
void RequireLoops(const Eigen::MatrixXd& points, const std::vector<std::vector<int>>& loops);

} // namespace shape
