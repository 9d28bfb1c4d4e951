#include "Geometry/FeatureCurves.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>

namespace shape
{

namespace
{

/// From one point of a curve to the next.
constexpr double MaximumSteps = 10000.0;

/// The length of a curve from its beginning to each of its points, as a share of the whole.
Eigen::VectorXd Shares(const Curve& curve, const std::string& name)
{
  RequireFinite(curve, name);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(curve.rows());
  for (Eigen::Index i = 1; i < curve.rows(); ++i)
  {
    shares(i) = shares(i - 1) + (curve.row(i) - curve.row(i - 1)).norm();
  }
  const double length = curve.rows() > 0 ? shares(curve.rows() - 1) : 0.0;
  if (!(length > 0.0))
  {
    throw InvalidInput(name + " has no length; give it two different points or leave it out");
  }
  return shares / length;
}

Eigen::RowVector3d At(const Curve& curve, const Eigen::VectorXd& shares, double share)
{
  const auto next = std::upper_bound(shares.begin() + 1, shares.end() - 1, share);
  const Eigen::Index i = next - shares.begin();
  const double step = shares(i) - shares(i - 1);
  const double t = step > 0.0 ? std::clamp((share - shares(i - 1)) / step, 0.0, 1.0) : 0.0;
  return (1.0 - t) * curve.row(i - 1) + t * curve.row(i);
}

} // namespace

// Restamping (Li et al. 2010, section 4.4): both curves are parameterised by arc length over their
// whole length, and equal parameters correspond.
MatchedCurves MatchCurves(const std::vector<Curve>& sources, const std::vector<Curve>& targets,
  double longestStep, const std::string& name)
{
  if (sources.size() != targets.size())
  {
    throw InvalidInput(name + " has " + std::to_string(sources.size()) +
      " curves and its target has " + std::to_string(targets.size()) +
      "; give each curve one target, in the same order");
  }
  std::vector<Eigen::RowVector3d> points, images;
  std::vector<int> curves;
  std::vector<double> positions;
  for (std::size_t c = 0; c < sources.size(); ++c)
  {
    const std::string which = "curve " + std::to_string(c) + " of ";
    const Eigen::VectorXd shares = Shares(sources[c], which + name);
    const Eigen::VectorXd targetShares = Shares(targets[c], which + "the target of " + name);
    const auto add = [&](double position)
    {
      const auto i = std::min(static_cast<Eigen::Index>(position), sources[c].rows() - 2);
      const double t = position - static_cast<double>(i);
      points.emplace_back((1.0 - t) * sources[c].row(i) + t * sources[c].row(i + 1));
      images.push_back(At(targets[c], targetShares, (1.0 - t) * shares(i) + t * shares(i + 1)));
      curves.push_back(static_cast<int>(c));
      positions.push_back(position);
    };
    for (Eigen::Index i = 0; i + 1 < sources[c].rows(); ++i)
    {
      const double length = (sources[c].row(i + 1) - sources[c].row(i)).norm();
      if (!(length <= MaximumSteps * longestStep))
      {
        throw InvalidInput(which + name +
          " is far longer than the shape it belongs to (at its point " + std::to_string(i) +
          "); check the units of the curve");
      }
      // Further points keep steps below the longest; the curve's own points are kept.
      const int steps = std::max(1, static_cast<int>(std::ceil(length / longestStep)));
      for (int step = 0; step < steps; ++step)
      {
        add(static_cast<double>(i) + static_cast<double>(step) / steps);
      }
    }
    const bool closed = sources[c].row(0) == sources[c].row(sources[c].rows() - 1);
    if (!closed) // else its last point is its first, which is there
    {
      add(static_cast<double>(sources[c].rows() - 1));
    }
  }
  MatchedCurves matched{ Eigen::MatrixXd(points.size(), 3), Eigen::MatrixXd(points.size(), 3),
    Eigen::VectorXi::Map(curves.data(), curves.size()),
    Eigen::VectorXd::Map(positions.data(), positions.size()) };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    matched.Points.row(i) = points[i];
    matched.Targets.row(i) = images[i];
  }
  return matched;
}

} // namespace shape
