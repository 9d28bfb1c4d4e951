#include "Solids/SurfaceComplex.h"

#include "Base/Errors.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/CoincidentPoints.h"
#include "Mesh/Topology.h"
#include "Mesh/UsedPoints.h"

#include <algorithm>
#include <locale>
#include <sstream>

namespace shape
{
namespace
{

/// The same triangles over the first points at each position, without those that collapse.
Mesh Joined(const Mesh& mesh, int& duplicates, int& firstDuplicate)
{
  const std::vector<int> first = FindCoincidentPoints(mesh.Points);
  Mesh joined{ mesh.Points, mesh.Triangles };
  for (int& point : joined.Triangles.reshaped())
  {
    point = first[point];
  }
  for (int i = 0; i < mesh.Points.rows(); ++i)
  {
    if (first[i] != i)
    {
      firstDuplicate = duplicates++ == 0 ? i : firstDuplicate;
    }
  }
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < joined.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i c = joined.Triangles.row(t);
    if (c(0) != c(1) && c(1) != c(2) && c(2) != c(0))
    {
      joined.Triangles.row(kept++) = c;
    }
  }
  joined.Triangles.conservativeResize(kept, 3);
  return joined;
}

std::string Position(const Eigen::RowVector3d& position)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(8);
  text << "(" << position(0) << ", " << position(1) << ", " << position(2) << ")";
  return text.str();
}

/// The surface that a triangle of the complex belongs to.
int Owner(const SurfaceComplex& complex, int triangle)
{
  const auto after =
    std::upper_bound(complex.FirstTriangle.begin(), complex.FirstTriangle.end(), triangle);
  return static_cast<int>(after - complex.FirstTriangle.begin()) - 1;
}

[[noreturn]] void ReportCrossings(const SurfaceComplex& complex,
  const std::vector<std::string>& names, double unit, const std::vector<Crossing>& crossings)
{
  const int a = Owner(complex, crossings[0].First), b = Owner(complex, crossings[0].Second);
  std::string positions;
  int count = 0;
  constexpr int listed = 5;
  for (const Crossing& crossing : crossings)
  {
    if (Owner(complex, crossing.First) != a || Owner(complex, crossing.Second) != b)
    {
      continue;
    }
    if (count++ < listed)
    {
      positions += (positions.empty() ? "" : ", ") +
        std::to_string(crossing.First - complex.FirstTriangle[a]) + " and " +
        std::to_string(crossing.Second - complex.FirstTriangle[b]) + " near " +
        Position(unit * crossing.Position);
    }
  }
  const std::string pairs = std::to_string(count) + (count == 1 ? " pair" : " pairs") +
    " of triangles (" + (count > listed ? "the first: " : "") + positions + "); ";
  if (a == b)
  {
    throw InvalidInput(names[a] + " crosses or touches itself at " + pairs +
      "look at these cells with Find Data, and repair the surface there: move its points apart, or "
      "remesh it");
  }
  throw InvalidInput(names[b] + " crosses or touches " + names[a] + " at " + pairs +
    "in each pair, the first triangle belongs to " + names[a] + ", the second to " + names[b] +
    "; move " + names[b] + " away or leave it out");
}

} // namespace

void RequireClosed(const Surface& surface, const std::string& name)
{
  try
  {
    RequireClosedSurface(surface, name);
  }
  catch (const InvalidInput&)
  {
    if (surface.Triangles().rows() == 0 || !surface.Points().allFinite())
    {
      throw;
    }
    const Topology& topology = surface.Topology();
    int duplicates = 0, first = -1;
    const Mesh joined = Joined(surface, duplicates, first);
    if (topology.BoundaryLoops == 0 || duplicates == 0 || joined.Triangles.rows() == 0 ||
      ComputeTopology(joined).BoundaryLoops > 0)
    {
      throw;
    }
    throw InvalidInput(name + " has " + std::to_string(topology.BoundaryLoops) +
      (topology.BoundaryLoops == 1 ? " open loop" : " open loops") + ", but only because " +
      std::to_string(duplicates) + " of its points coincide with others (first point " +
      std::to_string(first) + "); merge them with Clean");
  }
}

SurfaceComplex JoinSurfaces(const std::vector<Surface>& surfaces)
{
  Eigen::Index triangles = 0;
  SurfaceComplex complex;
  for (const Surface& surface : surfaces)
  {
    complex.FirstTriangle.push_back(static_cast<int>(triangles));
    triangles += surface.Triangles().rows();
  }
  Mesh all = JoinMeshes({ surfaces.begin(), surfaces.end() });
  // Only used points are compared, so that no unused point is the representative.
  const Eigen::Index points = all.Points.rows();
  const std::vector<int> kept = FindUsedPoints(all.Triangles, points);
  const Eigen::MatrixXd positions = all.Points(kept, Eigen::all);
  const std::vector<int> first = FindCoincidentPoints(positions);
  std::vector<int> distinct, newIndex(points, -1), original;
  for (int i = 0; i < static_cast<int>(kept.size()); ++i)
  {
    if (first[i] == i)
    {
      newIndex[kept[i]] = static_cast<int>(distinct.size());
      distinct.push_back(i);
      if (kept[i] < surfaces[0].Points().rows())
      {
        original.push_back(kept[i]);
      }
    }
    newIndex[kept[i]] = newIndex[kept[first[i]]];
  }
  for (int& point : all.Triangles.reshaped())
  {
    point = newIndex[point];
  }
  complex.Surfaces = { positions(distinct, Eigen::all), all.Triangles };
  complex.OriginalPoint =
    Eigen::Map<Eigen::VectorXi>(original.data(), static_cast<Eigen::Index>(original.size()));
  return complex;
}

void RequireConformingComplex(const SurfaceComplex& complex, const std::vector<std::string>& names,
  double unit, const Progress& progress)
{
  const std::vector<int> flat = FindDegenerateTriangles(complex.Surfaces);
  if (!flat.empty())
  {
    const int owner = Owner(complex, flat[0]);
    const auto count =
      std::count_if(flat.begin(), flat.end(), [&](int t) { return Owner(complex, t) == owner; });
    const Eigen::RowVector3i corners = complex.Surfaces.Triangles.row(flat[0]);
    throw InvalidInput(names[owner] + " has " + std::to_string(count) +
      (count == 1 ? " triangle" : " triangles") + " without area (first triangle " +
      std::to_string(flat[0] - complex.FirstTriangle[owner]) + " near " +
      Position(unit * complex.Surfaces.Points(corners, Eigen::all).colwise().mean()) +
      "); remove them with Clean (a tolerance above 0), or remesh");
  }
  progress(0.1);
  const std::vector<Crossing> crossings =
    FindSelfIntersections(complex.Surfaces, progress.Part(0.1, 1.0));
  if (!crossings.empty())
  {
    ReportCrossings(complex, names, unit, crossings);
  }
}

} // namespace shape
