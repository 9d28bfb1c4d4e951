#include "Mesh/Surface.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/SoundTriangles.h"

#include <mutex>

namespace shape
{
namespace
{

// One type for each cached quantity.
struct KeptHalfEdges
{
  std::vector<HalfEdge> Sorted;
};
struct KeptTwins
{
  std::vector<int> OfHalfEdges;
};
struct KeptAreaVectors
{
  Eigen::MatrixXd OfTriangles;
};
/// Throws unless the coordinates are finite and of a usable size, and there is an area.
struct KeptSoundness
{
};

/// "the boundary has 3 open loops (first at point 118)"
std::string Found(const std::string& name, int count, const std::string& singular,
  const std::string& plural, int first)
{
  return name + " has " + std::to_string(count) + " " + (count == 1 ? singular : plural) +
    " (first at point " + std::to_string(first) + "); ";
}

void RequireSize(const Surface& surface, const std::string& name)
{
  const double size = ComputeLongestBoxEdge(surface);
  if (size == 0.0)
  {
    throw InvalidInput(
      name + " has no area, because all its points coincide; check its coordinates");
  }
  RequireExtent(surface, name);
  if (!HasArea(surface))
  {
    throw InvalidInput(
      name + " has no area, because its points lie on lines; check its coordinates");
  }
}

/// The topology of a surface that has triangles and finite coordinates.
const Topology& TopologyOfSound(
  const Surface& surface, const std::string& name, const std::string& needed)
{
  surface.Cached<KeptSoundness>(
    [&]()
    {
      if (surface.Triangles().rows() == 0)
      {
        throw InvalidInput(name + " has no triangles; give " + needed);
      }
      RequireFinite(surface.Points(), name);
      RequireIndices(surface);
      RequireSize(surface, name);
      return KeptSoundness();
    });
  return surface.Topology();
}

/// Whether no orientation of the triangles is consistent across all edges, as on a Moebius strip.
bool IsOneSided(const Surface& surface)
{
  // Two sets per triangle, one for each orientation; those that agree across an edge are joined.
  const auto m = static_cast<int>(surface.Triangles().rows());
  DisjointSets sheets(2 * m);
  const std::vector<HalfEdge>& sides = surface.HalfEdges();
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    const HalfEdge& p = sides[i];
    const HalfEdge& q = sides[i + 1];
    if (p.Low() == q.Low() && p.High() == q.High())
    {
      const int turned = p.Begin == q.Begin ? m : 0;
      sheets.Merge(p.Triangle, q.Triangle + turned);
      sheets.Merge(p.Triangle + m, q.Triangle + m - turned);
    }
  }
  for (int t = 0; t < m; ++t)
  {
    if (sheets.Find(t) == sheets.Find(t + m))
    {
      return true;
    }
  }
  return false;
}

/// Each defect has its own message with the remedy; one-sided surfaces cannot be reoriented.
void CheckManifold(const Surface& surface, const Topology& topology, const std::string& name)
{
  if (topology.NonManifoldEdges > 0)
  {
    throw InvalidInput(Found(name, topology.NonManifoldEdges, "edge with three or more triangles",
                         "edges with three or more triangles", topology.FirstNonManifold) +
      "keep the outer surface alone");
  }
  if (topology.NonManifoldPoints > 0)
  {
    throw InvalidInput(Found(name, topology.NonManifoldPoints, "point where two sheets touch",
                         "points where two sheets touch", topology.FirstPinchedPoint) +
      "split them with Shape Fill Holes");
  }
  if (topology.MisorientedEdges > 0 && IsOneSided(surface))
  {
    throw InvalidInput(name +
      " is one-sided, like a Moebius strip: its triangles cannot all face " +
      "the same way (they do not at point " + std::to_string(topology.FirstMisoriented) +
      "); cut it open across the strip");
  }
  if (topology.MisorientedEdges > 0)
  {
    throw InvalidInput(
      Found(name, topology.MisorientedEdges, "edge between triangles of opposite orientation",
        "edges between triangles of opposite orientation", topology.FirstMisoriented) +
      "make them agree with Generate Surface Normals (Consistency on)");
  }
}

} // namespace

struct Surface::Data
{
  struct Entry
  {
    std::once_flag Made;
    std::shared_ptr<const void> Value;
  };

  Mesh Triangulation;
  std::mutex Lock; ///< of the list, not of what is made: one quantity may ask for another
  std::vector<std::pair<std::type_index, std::shared_ptr<Entry>>> Entries; ///< a few

  /// The entry of a type, which is made if there is none.
  std::shared_ptr<Entry> Get(std::type_index type)
  {
    const std::lock_guard<std::mutex> guard(this->Lock);
    for (const auto& [other, entry] : this->Entries)
    {
      if (other == type)
      {
        return entry;
      }
    }
    return this->Entries.emplace_back(type, std::make_shared<Entry>()).second;
  }
};

Surface::Surface()
  : Surface(Mesh{ Eigen::MatrixXd(0, 3), Eigen::MatrixXi(0, 3) })
{
}

Surface::Surface(Mesh mesh)
  : Impl(std::make_shared<Data>())
{
  this->Impl->Triangulation = std::move(mesh);
}

Surface::Surface(Eigen::MatrixXd points, Eigen::MatrixXi triangles)
  : Surface(Mesh{ std::move(points), std::move(triangles) })
{
}

const Mesh& Surface::AsMesh() const
{
  return this->Impl->Triangulation;
}

const std::shared_ptr<const void>& Surface::Find(
  std::type_index type, const std::function<std::shared_ptr<const void>()>& make) const
{
  const std::shared_ptr<Data::Entry> entry = this->Impl->Get(type);
  std::call_once(entry->Made, [&]() { entry->Value = make(); });
  return entry->Value; // the list, which outlives this call, holds the entry, too
}

Surface Surface::WithPoints(Eigen::MatrixXd points) const
{
  if (points.rows() != this->Points().rows())
  {
    throw InvalidInput("a surface has " + std::to_string(this->Points().rows()) +
      " points, but there are " + std::to_string(points.rows()) +
      " new positions; give one row for each point");
  }
  Surface moved(std::move(points), this->Triangles());
  // These follow from the triangles alone. An entry that is not made yet is shared, too, and made
  // once.
  for (const std::type_index type : { std::type_index(typeid(KeptHalfEdges)),
         std::type_index(typeid(KeptTwins)), std::type_index(typeid(shape::Topology)) })
  {
    moved.Impl->Entries.emplace_back(type, this->Impl->Get(type));
  }
  return moved;
}

const std::vector<HalfEdge>& Surface::HalfEdges() const
{
  return this
    ->Cached<KeptHalfEdges>(
      [&]()
      {
        RequireIndices(*this);
        return KeptHalfEdges{ SortHalfEdges(this->Triangles(), this->Points().rows()) };
      })
    ->Sorted;
}

const std::vector<int>& Surface::Twins() const
{
  return this->Cached<KeptTwins>([&]() { return KeptTwins{ FindTwins(this->HalfEdges()) }; })
    ->OfHalfEdges;
}

const Topology& Surface::Topology() const
{
  return *this->Cached<shape::Topology>(
    [&]() { return ComputeTopology(*this, this->HalfEdges()); });
}

const Eigen::MatrixXd& Surface::AreaVectors() const
{
  return this
    ->Cached<KeptAreaVectors>([&]() { return KeptAreaVectors{ shape::ComputeAreaVectors(*this) }; })
    ->OfTriangles;
}

std::vector<Mesh> SplitComponents(const Surface& surface)
{
  const Mesh& mesh = surface;
  const Topology& topology = surface.Topology();
  std::vector<std::vector<int>> triangles(topology.Components), points(topology.Components);
  std::vector<int> newId(mesh.Points.rows(), -1);
  for (int i = 0; i < mesh.Points.rows(); ++i)
  {
    if (topology.ComponentId(i) >= 0)
    {
      std::vector<int>& own = points[topology.ComponentId(i)];
      newId[i] = static_cast<int>(own.size());
      own.push_back(i);
    }
  }
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    triangles[topology.ComponentId(mesh.Triangles(t, 0))].push_back(t);
  }
  std::vector<Mesh> components;
  for (int c = 0; c < topology.Components; ++c)
  {
    components.push_back({ mesh.Points(points[c], Eigen::all),
      mesh.Triangles(triangles[c], Eigen::all).unaryExpr([&](int i) { return newId[i]; }) });
  }
  return components;
}

bool HasArea(const Surface& surface)
{
  // Far above the rounding of points on a line, and far below the area of any sliver in use.
  constexpr double minimumShare = 1e-14;
  const double size = ComputeLongestBoxEdge(surface);
  return surface.AreaVectors().rowwise().norm().maxCoeff() > minimumShare * size * size;
}

Topology RequireTriangles(const Surface& surface, const std::string& name)
{
  return TopologyOfSound(surface, name, "a surface");
}

Topology RequireManifold(const Surface& surface, const std::string& name)
{
  const Topology& topology = TopologyOfSound(surface, name, "a surface");
  CheckManifold(surface, topology, name);
  return topology;
}

Topology RequireClosedSurface(const Surface& surface, const std::string& name)
{
  const Topology& topology = TopologyOfSound(surface, name, "a closed surface");
  if (topology.BoundaryLoops > 0)
  {
    throw InvalidInput(
      Found(name, topology.BoundaryLoops, "open loop", "open loops", topology.FirstOpenPoint) +
      "close it with Shape Fill Holes, or merge its duplicate points with Clean");
  }
  CheckManifold(surface, topology, name);
  return topology;
}

} // namespace shape
