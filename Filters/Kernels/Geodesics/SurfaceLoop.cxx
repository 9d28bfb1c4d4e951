#include "Geodesics/SurfaceLoop.h"

#include "Base/Errors.h"

#include <string>

namespace shape
{

SurfaceLoop TraceLoopThrough(const Eigen::MatrixXd& points, const SurfaceLocator& locator,
  SurfacePaths& paths, const Progress& progress)
{
  std::vector<SurfacePoint> stops;
  std::vector<Eigen::RowVector3d> positions;
  int guess = -1;
  for (const auto& point : points.rowwise())
  {
    const ClosestPoint position = locator.FindOne(point, guess);
    guess = position.Triangle;
    if (positions.empty() || positions.back() != position.Position)
    {
      stops.push_back({ position.Triangle, position.Barycentric });
      positions.push_back(position.Position);
    }
  }
  if (stops.size() > 1 && positions.front() == positions.back())
  {
    stops.pop_back();
  }
  if (stops.size() < 3)
  {
    throw InvalidInput("the loop has " + std::to_string(stops.size()) +
      " different positions on the surface; draw a closed curve through at least 3");
  }
  SurfaceLoop loop;
  for (std::size_t i = 0; i < stops.size(); ++i)
  {
    const double done = static_cast<double>(i) / static_cast<double>(stops.size());
    const SurfacePath path = paths.Find(stops[i], stops[(i + 1) % stops.size()],
      Progress(
        [&](double)
        {
          progress(done);
          return true;
        }));
    loop.Positions.insert(loop.Positions.end(), path.Positions.begin(), path.Positions.end() - 1);
    loop.Triangles.insert(loop.Triangles.end(), path.Triangles.begin(), path.Triangles.end());
  }
  progress(1.0);
  return loop;
}

} // namespace shape
