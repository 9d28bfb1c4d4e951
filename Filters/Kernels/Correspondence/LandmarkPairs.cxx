#include "Correspondence/LandmarkPairs.h"

#include "Core/Topology.h"
#include "Geometry/ClosestPoint.h"

#include <set>

namespace shape
{

Landmarks LandmarkPairs(const Mesh& a, const Eigen::MatrixXd& placesA, const Mesh& b,
  const Eigen::MatrixXd& placesB, const Progress& progress)
{
  RequireFinite(placesA, "the Landmarks' points");
  RequireFinite(placesB, "the Landmarks' map");
  const Eigen::VectorXi onA = MainCorners(
                          SurfaceLocator(a).Find(placesA, progress.Part(0.0, 0.5)), a.Triangles),
                        onB = MainCorners(
                          SurfaceLocator(b).Find(placesB, progress.Part(0.5, 1.0)), b.Triangles);
  Landmarks pairs;
  std::set<int> ofA, ofB;
  for (Eigen::Index i = 0; i < onA.size(); ++i)
  {
    if (ofA.count(onA(i)) == 0 && ofB.count(onB(i)) == 0)
    {
      ofA.insert(onA(i));
      ofB.insert(onB(i));
      pairs.push_back({ onA(i), onB(i) });
    }
  }
  return pairs;
}

} // namespace shape
