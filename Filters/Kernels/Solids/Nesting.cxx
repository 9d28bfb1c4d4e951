#include "Solids/Nesting.h"

#include "Base/Errors.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace shape
{

namespace
{

using Eigen::RowVector3d;

/// A connected piece of the surface.
struct Component
{
  std::vector<int> Triangles;
  Eigen::AlignedBox3d Box;
  Eigen::KdBVH<double, 3, int> Tree; ///< of triangles
};

/// The components, each with a tree of its triangles' boxes.
std::vector<Component> Split(const Mesh& mesh, const Topology& topology)
{
  std::vector<Component> components(topology.Components);
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    components[topology.ComponentId(mesh.Triangles(t, 0))].Triangles.push_back(t);
  }
  for (Component& component : components)
  {
    std::vector<Eigen::AlignedBox3d> boxes;
    boxes.reserve(component.Triangles.size());
    for (const int t : component.Triangles)
    {
      const Eigen::Matrix3d corners = GetCorners(mesh, t);
      boxes.emplace_back(corners.colwise().minCoeff(), corners.colwise().maxCoeff());
      component.Box.extend(boxes.back());
    }
    component.Tree.init(
      component.Triangles.begin(), component.Triangles.end(), boxes.begin(), boxes.end());
  }
  return components;
}

/// The visitor of Eigen's search in two trees: whether a triangle of one meets one of the other.
struct Meeting
{
  const Mesh& Searched;
  const Progress& Report;
  double Done; ///< what is reported while the search lasts
  bool Found = false;
  int Visits = 0;

  // Eigen's search calls these by their names. NOLINTBEGIN(readability-identifier-naming)
  bool intersectVolumeVolume(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b)
  {
    if (++this->Visits % 65536 == 0)
    {
      this->Report(this->Done);
    }
    return a.intersects(b);
  }
  bool intersectVolumeObject(const Eigen::AlignedBox3d& box, int triangle) const
  {
    const Eigen::Matrix3d corners = GetCorners(this->Searched, triangle);
    return box.intersects({ corners.colwise().minCoeff(), corners.colwise().maxCoeff() });
  }
  bool intersectObjectVolume(int triangle, const Eigen::AlignedBox3d& box) const
  {
    return this->intersectVolumeObject(box, triangle);
  }
  bool intersectObjectObject(int a, int b)
  {
    this->Found = DoTrianglesIntersect(this->Searched, a, b);
    return this->Found; // true ends the search
  }
  // NOLINTEND(readability-identifier-naming)
};

/// Whether a component faces outwards; `apex` is one of its points.
bool IsFacingOutwards(const Mesh& mesh, const Component& component, const RowVector3d& apex)
{
  double sixVolumes = 0.0;
  for (const int t : component.Triangles)
  {
    const Eigen::Matrix3d corners = GetCorners(mesh, t).rowwise() - apex;
    sixVolumes += corners.determinant();
  }
  return sixVolumes > 0.0;
}

/// The data cached in a surface: itself with components inverted, or nothing if none had to be.
struct KeptOrientation
{
  std::optional<Surface> Inverted;
};

/// The depth of a component is the number of others around it: at an even depth it faces outwards.
KeptOrientation Orient(const Surface& surface, const std::string& name, const Progress& progress)
{
  const Mesh& mesh = surface;
  const std::vector<Component> components = Split(mesh, RequireClosedSurface(surface, name));
  std::vector<int> inverted;
  for (std::size_t i = 0; i < components.size(); ++i)
  {
    const RowVector3d position = mesh.Points.row(mesh.Triangles(components[i].Triangles[0], 0));
    const double done = static_cast<double>(i) / static_cast<double>(components.size());
    int depth = 0;
    for (std::size_t j = 0; j < components.size(); ++j)
    {
      if (i == j || !components[i].Box.intersects(components[j].Box))
      {
        continue;
      }
      Meeting meeting{ mesh, progress, done };
      if (i < j)
      {
        Eigen::BVIntersect(components[i].Tree, components[j].Tree, meeting);
      }
      if (meeting.Found)
      {
        throw InvalidInput(name + " has components that touch or cross (those of points " +
          std::to_string(mesh.Triangles(components[i].Triangles[0], 0)) + " and " +
          std::to_string(mesh.Triangles(components[j].Triangles[0], 0)) +
          "); move them apart, or unite them");
      }
      // The magnitude, because the other component may face either way.
      depth += components[j].Box.contains(components[i].Box) &&
        std::abs(ComputeWindingNumber(
          mesh.Points, mesh.Triangles(components[j].Triangles, Eigen::all), position)) > 0.5;
    }
    if (IsFacingOutwards(mesh, components[i], position) != (depth % 2 == 0))
    {
      inverted.insert(
        inverted.end(), components[i].Triangles.begin(), components[i].Triangles.end());
    }
    progress(static_cast<double>(i + 1) / static_cast<double>(components.size()));
  }
  if (inverted.empty())
  {
    return {};
  }
  Mesh oriented = mesh;
  for (const int t : inverted)
  {
    std::swap(oriented.Triangles(t, 1), oriented.Triangles(t, 2));
  }
  return { Surface(std::move(oriented)) };
}

} // namespace

Surface OrientByNesting(const Surface& surface, const std::string& name, const Progress& progress)
{
  return surface.Cached<KeptOrientation>([&]() { return Orient(surface, name, progress); })
    ->Inverted.value_or(surface);
}

} // namespace shape
