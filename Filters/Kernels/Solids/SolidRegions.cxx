#include "Solids/SolidRegions.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// How far a ray runs until it meets a triangle; infinity if it does not.
double RayLength(
  const Mesh& mesh, Eigen::Index triangle, const RowVector3d& from, const RowVector3d& direction)
{
  const RowVector3d a = mesh.Points.row(mesh.Triangles(triangle, 0));
  const RowVector3d u = mesh.Points.row(mesh.Triangles(triangle, 1)) - a;
  const RowVector3d v = mesh.Points.row(mesh.Triangles(triangle, 2)) - a;
  const RowVector3d normal = u.cross(v);
  const double slope = normal.dot(direction);
  const double length = slope == 0.0 ? -1.0 : normal.dot(a - from) / slope;
  const RowVector3d hit = from + length * direction - a;
  const double area2 = normal.squaredNorm();
  const double first = hit.cross(v).dot(normal) / area2, second = u.cross(hit).dot(normal) / area2;
  return length > 0.0 && first >= 0.0 && second >= 0.0 && first + second <= 1.0
    ? length
    : std::numeric_limits<double>::infinity();
}

} // namespace

SolidRegions::SolidRegions(const std::vector<Surface>& surfaces,
  const std::vector<std::string>& names, const Progress& progress)
  : RegionVolumes(Eigen::VectorXd::Zero(surfaces.size()))
{
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    const Surface& surface = surfaces[s];
    const Topology& topology = surface.Topology();
    std::vector<int> firstPoint(topology.Components, -1);
    for (int i = 0; i < surface.Points().rows(); ++i)
    {
      const int id = topology.ComponentId(i);
      if (id >= 0 && firstPoint[id] == -1)
      {
        firstPoint[id] = i;
      }
    }
    const std::vector<Mesh> split = SplitComponents(surface);
    for (std::size_t c = 0; c < split.size(); ++c)
    {
      Component component;
      component.Surface = OrientOutwards(split[c]);
      component.FirstPoint = firstPoint[c];
      component.Volume = ComputeEnclosedVolume(component.Surface);
      component.Owner = static_cast<int>(s);
      component.Low = component.Surface.Points().colwise().minCoeff();
      component.High = component.Surface.Points().colwise().maxCoeff();
      const double area = 0.5 * component.Surface.AreaVectors().rowwise().norm().sum();
      // Below this the volume is rounding error.
      if (!(component.Volume > 1e-14 * area * (component.High - component.Low).maxCoeff()))
      {
        throw InvalidInput(names[s] + " has a component that encloses no volume (it has point " +
          std::to_string(component.FirstPoint) + "); remove it with Connectivity");
      }
      this->Components.push_back(std::move(component));
    }
  }
  std::stable_sort(this->Components.begin(), this->Components.end(),
    [](const Component& a, const Component& b) { return a.Volume > b.Volume; });
  this->FindParents(progress);
  this->FindRegions(names);
}

bool SolidRegions::IsInside(const RowVector3d& position, const Component& component) const
{
  return (position.array() > component.Low.array()).all() &&
    (position.array() < component.High.array()).all() &&
    ComputeWindingNumber(component.Surface.Points(), component.Surface.Triangles(), position) > 0.5;
}

void SolidRegions::FindParents(const Progress& progress)
{
  for (std::size_t i = 0; i < this->Components.size(); ++i)
  {
    // Components do not cross: the whole component lies where one triangle's centroid does.
    Component& component = this->Components[i];
    const Eigen::RowVector3i corners = component.Surface.Triangles().row(0);
    const RowVector3d position = component.Surface.Points()(corners, Eigen::all).colwise().mean();
    // By ascending volume, so that the first one found is the innermost.
    for (int other = static_cast<int>(i) - 1; other >= 0 && component.Parent == -1; --other)
    {
      if (this->IsInside(position, this->Components[other]))
      {
        component.Parent = other;
      }
    }
    progress(static_cast<double>(i + 1) / this->Components.size());
  }
}

void SolidRegions::FindRegions(const std::vector<std::string>& names)
{
  for (Component& component : this->Components)
  {
    // count: the components of the same surface around this one. If it is even, this one bounds the
    // surface's region from outside; if it is odd, it bounds a hole in it, and what is outside the
    // enclosing component (own) continues there.
    int around = component.Parent, own = -1, count = 0;
    const int outside = around == -1 ? Void : this->Components[around].Region;
    for (; around != -1; around = this->Components[around].Parent)
    {
      if (this->Components[around].Owner == component.Owner)
      {
        own = own == -1 ? around : own;
        ++count;
      }
    }
    if (component.Owner == 0)
    {
      component.Region = count % 2 == 0 ? 0 : Void;
    }
    else if (outside == Void)
    {
      throw InvalidInput(names[component.Owner] + " lies outside the solid that " + names[0] +
        " bounds (at point " + std::to_string(component.FirstPoint) +
        "); move it inside or leave it out");
    }
    else if (count % 2 == 0)
    {
      component.Region = component.Owner;
    }
    else
    {
      const int beyond = this->Components[own].Parent;
      component.Region = beyond == -1 ? Void : this->Components[beyond].Region;
    }
    if (component.Region != Void)
    {
      this->RegionVolumes(component.Region) += component.Volume;
    }
    if (outside != Void)
    {
      this->RegionVolumes(outside) -= component.Volume;
    }
  }
}

int SolidRegions::InnermostAt(const RowVector3d& position) const
{
  for (int i = static_cast<int>(this->Components.size()) - 1; i >= 0; --i)
  {
    if (this->IsInside(position, this->Components[i]))
    {
      return i;
    }
  }
  return -1;
}

int SolidRegions::RegionAt(const RowVector3d& position) const
{
  const int innermost = this->InnermostAt(position);
  return innermost == -1 ? Void : this->Components[innermost].Region;
}

Eigen::MatrixXd SolidRegions::FindPositionsInVoids() const
{
  std::vector<RowVector3d> positions;
  for (int i = 0; i < static_cast<int>(this->Components.size()); ++i)
  {
    const Component& component = this->Components[i];
    if (component.Region != Void)
    {
      continue;
    }
    // The midpoint of a chord from a large triangle inwards to the next wall: the longest one that
    // proves to lie in this void.
    const Surface& surface = component.Surface;
    const Eigen::MatrixXd& normals = surface.AreaVectors();
    const Eigen::VectorXd areas = normals.rowwise().norm();
    std::vector<int> largest(surface.Triangles().rows());
    std::iota(largest.begin(), largest.end(), 0);
    const auto samples = largest.begin() + std::min<std::ptrdiff_t>(64, largest.size());
    std::partial_sort(largest.begin(), samples, largest.end(),
      [&](int a, int b) { return areas(a) != areas(b) ? areas(a) > areas(b) : a < b; });
    largest.erase(samples, largest.end());
    std::vector<std::pair<double, RowVector3d>> chords;
    for (const int t : largest)
    {
      const Eigen::RowVector3i corners = surface.Triangles().row(t);
      const RowVector3d from = surface.Points()(corners, Eigen::all).colwise().mean();
      const RowVector3d inwards = -normals.row(t).normalized();
      double length = std::numeric_limits<double>::infinity();
      for (int wall = i; wall < static_cast<int>(this->Components.size()); ++wall)
      {
        const Component& other = this->Components[wall];
        for (int u = 0; (wall == i || other.Parent == i) && u < other.Surface.Triangles().rows();
             ++u)
        {
          length = wall == i && u == t
            ? length
            : std::min(length, RayLength(other.Surface, u, from, inwards));
        }
      }
      chords.emplace_back(length, from + 0.5 * length * inwards);
    }
    std::stable_sort(
      chords.begin(), chords.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    const auto found = std::find_if(chords.begin(), chords.end(),
      [&](const auto& chord)
      { return chord.second.allFinite() && this->InnermostAt(chord.second) == i; });
    if (found == chords.end())
    {
      throw SolveFailure("a void inside the solid is too thin to find a position in it (at point " +
        std::to_string(component.FirstPoint) + "); widen or remove it");
    }
    positions.push_back(found->second);
  }
  Eigen::MatrixXd rows(positions.size(), 3);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    rows.row(i) = positions[i];
  }
  return rows;
}

} // namespace shape
