#include "Distance/TargetDistance.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{

namespace
{

/// The genus of each component of a closed surface, ascending. Each triangle has three half edges.
std::vector<int> GenusOfComponents(const Surface& surface, const std::string& name)
{
  const Topology topology = RequireClosedSurface(surface, name);
  std::vector<int> points(topology.Components, 0), triangles(topology.Components, 0);
  for (const int component : topology.ComponentId)
  {
    if (component >= 0)
    {
      ++points[component];
    }
  }
  for (Eigen::Index t = 0; t < surface.Triangles().rows(); ++t)
  {
    ++triangles[topology.ComponentId(surface.Triangles()(t, 0))];
  }
  std::vector<int> genus(topology.Components);
  for (std::size_t c = 0; c < genus.size(); ++c)
  {
    // Euler's formula: V - E + F = 2 - 2 g with E = 3 F / 2.
    genus[c] = (2 - points[c] + triangles[c] / 2) / 2;
  }
  std::sort(genus.begin(), genus.end());
  return genus;
}

/// "1 component of genus 0", "3 components of genus 0, 0, 2".
std::string Described(const std::vector<int>& genus)
{
  std::string words = std::to_string(genus.size()) +
    (genus.size() == 1 ? " component" : " components") + " of genus ";
  constexpr std::size_t listed = 8;
  for (std::size_t c = 0; c < std::min(listed, genus.size()); ++c)
  {
    words += (c == 0 ? "" : ", ") + std::to_string(genus[c]);
  }
  return words + (genus.size() > listed ? ", ..." : "");
}

} // namespace

double ComputeTargetDistance(const Surface& boundary, const Eigen::MatrixXd& targets,
  const Surface& target, const Progress& progress)
{
  const std::vector<int> from = GenusOfComponents(boundary, "the Boundary");
  const std::vector<int> onto = GenusOfComponents(target, "the Target");
  if (from != onto)
  {
    throw InvalidInput("the Boundary has " + Described(from) + " and the Target has " +
      Described(onto) +
      ": no continuous one-to-one map between them exists; give a Target of the same genus, or "
      "close handles that are noise first");
  }
  const Eigen::VectorXd distances = SurfaceLocator(target).Find(targets, progress).Distances;
  return std::sqrt(distances.squaredNorm() / distances.size()) / ComputeLongestBoxEdge(target);
}

} // namespace shape
