#include "Solids/Nesting.h"

#include "Base/Errors.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/Topology.h"
#include "Search/TriangleBoxes.h"

#include <Eigen/Geometry>

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
};

Eigen::AlignedBox3d BoxOf(const Mesh& mesh, int triangle)
{
  const Eigen::Matrix3d corners = GetCorners(mesh, triangle);
  return { corners.colwise().minCoeff(), corners.colwise().maxCoeff() };
}

std::vector<Component> Split(const Mesh& mesh, const Topology& topology)
{
  std::vector<Component> components(topology.Components);
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    Component& component = components[topology.ComponentId(mesh.Triangles(t, 0))];
    component.Triangles.push_back(t);
    component.Box.extend(BoxOf(mesh, t));
  }
  return components;
}

/// The visitor of Eigen's search in the tree of all triangles: finds the first component that one
/// triangle meets, among those after its own.
struct Meeting
{
  const Mesh& Searched;
  const Eigen::VectorXi& ComponentId; ///< of each point
  int Number = 0;                     ///< the triangle
  Eigen::AlignedBox3d Box;            ///< around it
  int First;                          ///< the component found; the number of components if none

  int ComponentOf(int triangle) const
  {
    return this->ComponentId(this->Searched.Triangles(triangle, 0));
  }

  // Eigen's search calls these by their names. NOLINTBEGIN(readability-identifier-naming)
  bool intersectVolume(const Eigen::AlignedBox3d& box) const { return box.intersects(this->Box); }
  bool intersectObject(int other)
  {
    const int component = this->ComponentOf(other);
    if (component > this->ComponentOf(this->Number) && component < this->First &&
      this->Box.intersects(BoxOf(this->Searched, other)) &&
      DoTrianglesIntersect(this->Searched, this->Number, other))
    {
      this->First = component;
    }
    return false; // go on
  }
  // NOLINTEND(readability-identifier-naming)
};

/// Throws InvalidInput if component `one` meets a later one.
void RequireApart(const Surface& surface, const std::vector<Component>& components, std::size_t one,
  const std::string& name, const Progress& progress)
{
  Eigen::AlignedBox3d later;
  for (std::size_t j = one + 1; j < components.size(); ++j)
  {
    later.extend(components[j].Box);
  }
  if (!components[one].Box.intersects(later))
  {
    return;
  }
  const auto count = static_cast<int>(components.size());
  const std::shared_ptr<const BoxTree> tree = GetTriangleBoxes(surface);
  const Mesh& mesh = surface;
  Meeting meeting{ mesh, surface.Topology().ComponentId, 0, {}, count };
  const std::vector<int>& triangles = components[one].Triangles;
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    if (i % 4096 == 0)
    {
      progress(static_cast<double>(i) / static_cast<double>(triangles.size()));
    }
    meeting.Number = triangles[i];
    meeting.Box = BoxOf(mesh, triangles[i]);
    if (meeting.Box.intersects(later))
    {
      Eigen::BVIntersect(*tree, meeting);
    }
  }
  if (meeting.First < count)
  {
    throw InvalidInput(name + " has components that touch or cross (the components of points " +
      std::to_string(mesh.Triangles(triangles[0], 0)) + " and " +
      std::to_string(mesh.Triangles(components[meeting.First].Triangles[0], 0)) +
      "); move them apart, or unite them");
  }
}

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
    const auto count = static_cast<double>(components.size());
    const auto before = static_cast<double>(i);
    RequireApart(
      surface, components, i, name, progress.Part(before / count, (before + 1.0) / count));
    int depth = 0;
    for (std::size_t j = 0; j < components.size(); ++j)
    {
      // The magnitude, because the other component may face either way.
      depth += i != j && components[j].Box.contains(components[i].Box) &&
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
