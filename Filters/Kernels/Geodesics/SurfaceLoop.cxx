#include "Geodesics/SurfaceLoop.h"

#include "Base/Errors.h"

#include <string>

namespace shape
{

SurfaceLoop LoopThrough(const Eigen::MatrixXd& points, const SurfaceLocator& locator,
  SurfacePaths& paths, const Progress& progress)
{
  std::vector<SurfacePlace> places;
  std::vector<Eigen::RowVector3d> positions;
  int guess = -1;
  for (const auto& point : points.rowwise())
  {
    const ClosestPlace place = locator.FindOne(point, guess);
    guess = place.Triangle;
    if (positions.empty() || positions.back() != place.Position)
    {
      places.push_back({ place.Triangle, place.Barycentric });
      positions.push_back(place.Position);
    }
  }
  if (places.size() > 1 && positions.front() == positions.back())
  {
    places.pop_back();
  }
  if (places.size() < 3)
  {
    throw InvalidInput("the loop has " + std::to_string(places.size()) +
      " different places on the surface; draw a closed curve through at least 3");
  }
  SurfaceLoop loop;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double done = static_cast<double>(i) / static_cast<double>(places.size());
    const SurfacePath path = paths.Find(places[i], places[(i + 1) % places.size()],
      Progress(
        [&](double)
        {
          progress(done);
          return true;
        }));
    loop.Places.insert(loop.Places.end(), path.Places.begin(), path.Places.end() - 1);
    loop.Triangles.insert(loop.Triangles.end(), path.Triangles.begin(), path.Triangles.end());
  }
  progress(1.0);
  return loop;
}

} // namespace shape
