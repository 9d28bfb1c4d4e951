#include "Fill/LoopChoice.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace shape
{

double ComputeLoopLength(const Eigen::MatrixXd& points, const std::vector<int>& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += (points.row(loop[(i + 1) % loop.size()]) - points.row(loop[i])).norm();
  }
  return length;
}

std::vector<int> ChooseLoops(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& loops, const LoopChoice& choice)
{
  RequireOption(choice.MaximumLength >= 0.0 && std::isfinite(choice.MaximumLength), "MaximumLength",
    choice.MaximumLength, "at least 0 and finite");
  std::vector<int> chosen(loops.size());
  std::iota(chosen.begin(), chosen.end(), 0);
  if (choice.Loops == LoopChoice::LoopsType::Longest && chosen.size() > 1)
  {
    chosen.resize(1);
  }
  if (choice.Loops == LoopChoice::LoopsType::Chosen)
  {
    chosen = choice.Indices;
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    for (const int loop : chosen)
    {
      if (loop < 0 || loop >= static_cast<int>(loops.size()))
      {
        throw InvalidInput("there is no loop " + std::to_string(loop) + "; the surface has " +
          std::to_string(loops.size()) + " loops, numbered from 0, the longest");
      }
    }
  }
  const auto isTooLong = [&](int loop)
  {
    return choice.MaximumLength > 0.0 &&
      ComputeLoopLength(points, loops[loop]) > choice.MaximumLength;
  };
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(), isTooLong), chosen.end());
  return chosen;
}

double ComputeNonplanarity(const Eigen::MatrixXd& points)
{
  // Three points always lie in a plane.
  constexpr Eigen::Index planar = 3;
  if (points.rows() <= planar)
  {
    return 0.0;
  }
  const Eigen::MatrixXd ways = points.rowwise() - points.colwise().mean();
  // The last right singular vector is the normal of the least-squares plane.
  const Eigen::JacobiSVD<Eigen::MatrixXd> axes(ways, Eigen::ComputeThinV);
  const double radius = ways.rowwise().norm().maxCoeff();
  return radius > 0.0 ? (ways * axes.matrixV().col(2)).cwiseAbs().maxCoeff() / (2.0 * radius) : 0.0;
}

void RequireLoops(const Eigen::MatrixXd& points, const std::vector<std::vector<int>>& loops)
{
  RequireFinite(points, "the surface");
  for (const std::vector<int>& loop : loops)
  {
    if (loop.size() < 3)
    {
      throw InvalidInput("a loop has " + std::to_string(loop.size()) +
        " points, but needs at least 3; leave this loop out");
    }
    for (const int point : loop)
    {
      if (point < 0 || point >= points.rows())
      {
        throw InvalidInput("a loop contains point " + std::to_string(point) +
          ", but the surface has " + std::to_string(points.rows()) +
          " points; number points from 0");
      }
    }
  }
}

} // namespace shape
