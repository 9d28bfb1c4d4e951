#include "Correspondence/Landmarks/Landmarks.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

#include <array>
#include <cmath>
#include <map>
#include <sstream>

namespace shape
{
namespace
{

void RequireNearSurface(const Eigen::VectorXd& distances, double maximum, const std::string& name)
{
  for (Eigen::Index i = 0; i < distances.size(); ++i)
  {
    if (distances(i) > maximum)
    {
      std::ostringstream message;
      message << "landmark " << i + 1 << " is " << distances(i) << " away from " << name
              << "; move it there, or increase Maximum Distance";
      throw InvalidInput(message.str());
    }
  }
}

void RequireDistinct(const Eigen::MatrixXd& positions, const std::string& name)
{
  std::map<std::array<double, 3>, Eigen::Index> seen;
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    const auto [other, isNew] =
      seen.insert({ { positions(i, 0), positions(i, 1), positions(i, 2) }, i });
    if (!isNew)
    {
      throw InvalidInput("landmarks " + std::to_string(other->second + 1) + " and " +
        std::to_string(i + 1) + " have the same position on " + name + "; remove one of them");
    }
  }
}

} // namespace

LandmarksResult ProjectLandmarks(const Surface& surface, const Eigen::MatrixXd& positions,
  const std::string& name, const LandmarksOptions& options, const Progress& progress)
{
  RequireFinite(surface.Points(), name);
  RequireFinite(positions, "the landmarks on " + name);
  RequireOption(options.MaximumDistance >= 0.0 && std::isfinite(options.MaximumDistance),
    "MaximumDistance", options.MaximumDistance, "at least 0 and finite");
  progress(0.1);
  const SurfaceLocator locator(surface);
  progress(0.3);
  LandmarksResult result;
  result.Positions.resize(0, 3);
  if (positions.rows() > 0)
  {
    const ClosestPoints closest = locator.Find(positions, progress.Part(0.3, 0.9));
    RequireNearSurface(
      closest.Distances, options.MaximumDistance * ComputeBoxDiagonal(surface), name);
    RequireDistinct(closest.Positions, name);
    result.Positions = closest.Positions;
    result.LargestDistance = closest.Distances.maxCoeff();
  }
  progress(1.0);
  return result;
}

} // namespace shape
