// Damaged surfaces mended by ShapeMap, judged by CGAL, beside CGAL's alpha wrapping of the same
// input.
#include "Cases/CgalMesh.h"
#include "Cases/ModelFile.h"
#include "Driver/Case.h"
#include "Driver/Cost.h"

#include "Distance/HausdorffDistance.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Surface.h"
#include "Mesh/UsedPoints.h"
#include "Search/ClosestPoint.h"
#include "Solidify/Solidify.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/alpha_wrap_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage =
  R"(MODEL [MUTATION ...] [Seed=1] [Wrap=0] [Method=0] [Detail=0] [Gap=0]

Damages a model (OFF, STL, PLY, OBJ) by the mutations in order, and turns the result into a solid (Automatic):
  soup        no two triangles share a point
  reversed    30 % of the triangles
  duplicates  5 % of the triangles once more, with points of their own
  degenerate  1 % of the edges with a triangle without area
  holes       three disks of 0.5 % of the triangles each are removed
  fins        three triangles on edges
  debris      five small spheres beside the model
  crossing    a copy of the model, moved by 5 % of its size

Figures: triangles before and after, kept, mended, made; valid: whether CGAL finds the result a closed
manifold without self-intersections that bounds a volume; same: whether no bit of the input changed;
grid: the spacing of the grid that was used, or 0; distance: the larger Hausdorff distance from the
undamaged model, in % of its longest box edge; crease: the median distance of its creases; away: the
largest distance of a position on the result from the damaged model; far: the larger Hausdorff distance
from that. Method=1 to 4 sets the method: Report, Mend, Solid or Wrap. Detail and Gap are Detail Size and
Gap Size in % of the longest box edge.
With Wrap=1, a row of CGAL's alpha wrapping of the same input if it was changed, whose alpha is chosen such that it has
about as many triangles; its offset is alpha / 30. An input that is refused has no figures, but an error.)";

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace pmp = CGAL::Polygon_mesh_processing;

/// In the order of shape::SolidifyMethod; Report changes nothing.
constexpr std::array<const char*, 5> Methods = { "Automatic", "unchanged", "Mend", "Solid",
  "Wrap" };

/// Random numbers from 0 to 1.
class Chance
{
public:
  explicit Chance(unsigned int seed)
    : Random(seed)
  {
  }
  double operator()() { return std::uniform_real_distribution<double>()(this->Random); }
  int Index(Eigen::Index count)
  {
    return std::min(
      static_cast<int>((*this)() * static_cast<double>(count)), static_cast<int>(count) - 1);
  }

private:
  std::mt19937 Random;
};

/// Appends triangles that share no point with others.
void AppendApart(shape::Mesh& mesh, const std::vector<Eigen::Matrix3d>& triangles)
{
  std::vector<shape::Mesh> parts = { mesh };
  for (const Eigen::Matrix3d& corners : triangles)
  {
    parts.push_back({ corners, Eigen::RowVector3i(0, 1, 2) });
  }
  mesh = shape::JoinMeshes(parts);
}

void MakeSoup(shape::Mesh& mesh, Chance&)
{
  shape::Mesh soup{ Eigen::MatrixXd(3 * mesh.Triangles.rows(), 3), mesh.Triangles };
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    soup.Points.middleRows(3 * t, 3) = shape::GetCorners(mesh, t);
    soup.Triangles.row(t) = Eigen::RowVector3i(0, 1, 2).array() + static_cast<int>(3 * t);
  }
  mesh = std::move(soup);
}

void Reverse(shape::Mesh& mesh, Chance& chance)
{
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    if (chance() < 0.3)
    {
      std::swap(mesh.Triangles(t, 1), mesh.Triangles(t, 2));
    }
  }
}

void Duplicate(shape::Mesh& mesh, Chance& chance)
{
  std::vector<Eigen::Matrix3d> again;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    if (chance() < 0.05)
    {
      again.push_back(shape::GetCorners(mesh, t));
    }
  }
  AppendApart(mesh, again);
}

/// Triangles with two corners at one end of an edge.
void AddDegenerate(shape::Mesh& mesh, Chance& chance)
{
  std::vector<Eigen::Matrix3d> flat;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    if (chance() < 0.015)
    {
      Eigen::Matrix3d corners = shape::GetCorners(mesh, t);
      corners.row(2) = corners.row(1);
      flat.push_back(corners);
    }
  }
  AppendApart(mesh, flat);
}

void CutHoles(shape::Mesh& mesh, Chance& chance)
{
  const Eigen::MatrixXd centres = shape::ComputeCentroids(mesh);
  const auto count = static_cast<std::size_t>(std::ceil(0.005 * centres.rows()));
  std::vector<char> isRemoved(centres.rows(), 0);
  for (int hole = 0; hole < 3; ++hole)
  {
    const Eigen::RowVector3d centre = centres.row(chance.Index(centres.rows()));
    std::vector<int> order(centres.rows());
    std::iota(order.begin(), order.end(), 0);
    const Eigen::VectorXd squares = (centres.rowwise() - centre).rowwise().squaredNorm();
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count),
      order.end(), [&](int a, int b) { return squares(a) < squares(b); });
    for (std::size_t i = 0; i < count; ++i)
    {
      isRemoved[order[i]] = 1;
    }
  }
  std::vector<int> kept;
  for (int t = 0; t < static_cast<int>(isRemoved.size()); ++t)
  {
    if (!isRemoved[t])
    {
      kept.push_back(t);
    }
  }
  mesh = shape::ExtractTriangles(mesh, kept);
}

/// Each stands on an edge and points away from the triangle.
void AddFins(shape::Mesh& mesh, Chance& chance)
{
  std::vector<Eigen::Matrix3d> fins;
  for (int fin = 0; fin < 3; ++fin)
  {
    Eigen::Matrix3d corners = shape::GetCorners(mesh, chance.Index(mesh.Triangles.rows()));
    const Eigen::RowVector3d u = corners.row(1) - corners.row(0),
                             v = corners.row(2) - corners.row(0);
    corners.row(2) = corners.topRows(2).colwise().mean() + u.norm() * u.cross(v).normalized();
    fins.push_back(corners);
  }
  AppendApart(mesh, fins);
}

void AddDebris(shape::Mesh& mesh, Chance& chance)
{
  std::vector<shape::Mesh> parts = { mesh };
  for (int i = 0; i < 5; ++i)
  {
    shape::Mesh octahedron{ Eigen::MatrixXd(6, 3), Eigen::MatrixXi(8, 3) };
    octahedron.Points << Eigen::Matrix3d::Identity(), -Eigen::Matrix3d::Identity();
    octahedron.Triangles << 0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2, 1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5;
    octahedron.Points *= 0.002;
    octahedron.Points.rowwise() += Eigen::RowVector3d(0.7 + 0.05 * i, chance(), chance());
    parts.push_back(octahedron);
  }
  mesh = shape::JoinMeshes(parts);
}

void AddCrossing(shape::Mesh& mesh, Chance& chance)
{
  shape::Mesh moved = mesh;
  moved.Points.rowwise() +=
    0.05 * Eigen::RowVector3d(0.5 + chance(), 0.5 + chance(), 0.5 + chance()).normalized();
  mesh = shape::JoinMeshes({ mesh, moved });
}

const std::map<std::string, std::function<void(shape::Mesh&, Chance&)>> Mutations = {
  { "soup", MakeSoup }, { "reversed", Reverse }, { "duplicates", Duplicate },
  { "degenerate", AddDegenerate }, { "holes", CutHoles }, { "fins", AddFins },
  { "debris", AddDebris }, { "crossing", AddCrossing }
};

/// The points and triangles as CGAL takes them.
struct CgalSoup
{
  explicit CgalSoup(const shape::Mesh& mesh)
  {
    for (const auto& point : mesh.Points.rowwise())
    {
      this->Points.emplace_back(point(0), point(1), point(2));
    }
    for (const auto& triangle : mesh.Triangles.rowwise())
    {
      this->Triangles.push_back({ static_cast<std::size_t>(triangle(0)),
        static_cast<std::size_t>(triangle(1)), static_cast<std::size_t>(triangle(2)) });
    }
  }
  std::vector<Kernel::Point_3> Points;
  std::vector<std::array<std::size_t, 3>> Triangles;
};

/// Whether CGAL finds a closed manifold without self-intersections that bounds a volume.
bool IsValidForCgal(const shape::Mesh& solid)
{
  const CgalSoup soup(solid);
  if (!pmp::is_polygon_soup_a_polygon_mesh(soup.Triangles))
  {
    return false;
  }
  CgalMesh mesh;
  pmp::polygon_soup_to_polygon_mesh(soup.Points, soup.Triangles, mesh);
  return CGAL::is_closed(mesh) && !pmp::does_self_intersect(mesh) && pmp::does_bound_a_volume(mesh);
}

CgalMesh Wrap(const CgalSoup& soup, double alpha)
{
  CgalMesh wrapped;
  CGAL::alpha_wrap_3(soup.Points, soup.Triangles, alpha, alpha / 30.0, wrapped);
  return wrapped;
}

/// The median distance of the middles of a model's creases, edges with angles of more than 40
/// degrees, from a result; 0 without creases.
double DistanceOfCreases(const shape::Surface& model, const shape::Mesh& result)
{
  const std::vector<shape::HalfEdge>& sides = model.HalfEdges();
  const Eigen::MatrixXd normals = model.AreaVectors().rowwise().normalized();
  const double cosine = std::cos(40.0 * M_PI / 180.0);
  std::vector<Eigen::RowVector3d> middles;
  for (std::size_t i = 1; i < sides.size(); ++i)
  {
    const shape::HalfEdge &side = sides[i - 1], &other = sides[i];
    if (side.Low() == other.Low() && side.High() == other.High() &&
      normals.row(side.Triangle).dot(normals.row(other.Triangle)) < cosine)
    {
      middles.emplace_back(0.5 * (model.Points().row(side.Begin) + model.Points().row(side.End)));
    }
  }
  if (middles.empty())
  {
    return 0.0;
  }
  Eigen::MatrixXd positions(static_cast<Eigen::Index>(middles.size()), 3);
  for (std::size_t i = 0; i < middles.size(); ++i)
  {
    positions.row(static_cast<Eigen::Index>(i)) = middles[i];
  }
  Eigen::VectorXd distances = shape::SurfaceLocator(result).Find(positions).Distances;
  std::nth_element(distances.begin(), distances.begin() + distances.size() / 2, distances.end());
  return distances(distances.size() / 2);
}

/// How far a result is from the undamaged model, from its creases, and from the input, in % of the
/// longest box edge.
benchmark::Row MeasureDistances(
  const shape::Mesh& model, const shape::Mesh& input, const shape::Mesh& result)
{
  const shape::HausdorffDistances distances = shape::ComputeHausdorffDistance(input, result);
  const double percent = 100.0 / shape::ComputeLongestBoxEdge(input.Points);
  return benchmark::Row()
    .Add("distance",
      100.0 * shape::ComputeHausdorffDistance(model, result).Larger() /
        shape::ComputeLongestBoxEdge(model.Points))
    .Add("crease",
      100.0 * DistanceOfCreases(model, result) / shape::ComputeLongestBoxEdge(model.Points))
    .Add("away", percent * distances.FromSecond)
    .Add("far", percent * distances.Larger());
}

/// The wrap with about `triangles` triangles, and its cost.
void WrapByCgal(const shape::Mesh& model, const shape::Mesh& input, Eigen::Index triangles,
  benchmark::Figures& figures)
{
  const CgalSoup soup(input);
  double alpha = 0.05;
  CgalMesh wrapped;
  benchmark::Cost cost;
  for (int round = 0; round < 4; ++round)
  {
    cost = benchmark::Measure([&] { wrapped = Wrap(soup, alpha); });
    alpha *=
      std::sqrt(static_cast<double>(wrapped.number_of_faces()) / static_cast<double>(triangles));
  }
  shape::Mesh result{ Eigen::MatrixXd(wrapped.number_of_vertices(), 3),
    Eigen::MatrixXi(wrapped.number_of_faces(), 3) };
  for (const auto vertex : wrapped.vertices())
  {
    const auto& point = wrapped.point(vertex);
    result.Points.row(vertex.idx()) << point.x(), point.y(), point.z();
  }
  for (const auto face : wrapped.faces())
  {
    int corner = 0;
    for (const auto vertex : CGAL::vertices_around_face(wrapped.halfedge(face), wrapped))
    {
      result.Triangles(face.idx(), corner++) = static_cast<int>(vertex.idx());
    }
  }
  figures.Print(benchmark::Row()
                  .Add("method", std::string("CGAL"))
                  .Add("before", input.Triangles.rows())
                  .Add("after", result.Triangles.rows())
                  .Add("valid", static_cast<int>(IsValidForCgal(result)))
                  .Append(MeasureDistances(model, input, result))
                  .Add("cpu", cost.Cpu)
                  .Add("wall", cost.Wall));
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const shape::Mesh model = benchmark::ReadModel(arguments.NextWord());
  const std::vector<std::string> mutations = arguments.RemainingWords();
  Chance chance(static_cast<unsigned int>(arguments.Setting("Seed", 1)));
  const bool wrap = arguments.Setting("Wrap", false);
  const int method = arguments.Setting("Method", 0);
  const double detail = arguments.Setting("Detail", 0.0), gap = arguments.Setting("Gap", 0.0);
  if (method < 0 || method >= static_cast<int>(Methods.size()))
  {
    throw benchmark::UsageError("Method is 0 to 4");
  }
  arguments.RequireAllRead();
  shape::Mesh input = model;
  for (const std::string& mutation : mutations)
  {
    const auto found = Mutations.find(mutation);
    if (found == Mutations.end())
    {
      throw benchmark::UsageError("there is no mutation \"" + mutation + "\"");
    }
    found->second(input, chance);
  }
  shape::SolidifyResult result;
  shape::SolidifyOptions options;
  options.Method = static_cast<shape::SolidifyMethod>(method);
  const double percent = 0.01 * shape::ComputeLongestBoxEdge(input.Points);
  options.DetailSize = detail * percent;
  options.GapSize = gap * percent;
  // Debris is known to be smaller than this.
  options.Defects.SmallestPiece =
    std::find(mutations.begin(), mutations.end(), "debris") == mutations.end() ? 0.0 : 0.005;
  const benchmark::Cost cost =
    benchmark::Measure([&] { result = shape::Solidify(input, options); });
  const shape::Mesh& solid = result.Mended.Surface;
  const auto count = [&](shape::TriangleOrigin origin)
  { return (result.Mended.Origin.array() == static_cast<int>(origin)).count(); };
  const bool isSame = solid.Points.rows() == input.Points.rows() &&
    solid.Triangles.rows() == input.Triangles.rows() && solid.Points == input.Points &&
    solid.Triangles == input.Triangles;
  figures.Print(benchmark::Row()
                  .Add("method", std::string(Methods[static_cast<std::size_t>(result.Method)]))
                  .Add("before", input.Triangles.rows())
                  .Add("after", solid.Triangles.rows())
                  .Add("kept", count(shape::TriangleOrigin::Kept))
                  .Add("mended", count(shape::TriangleOrigin::Mended))
                  .Add("made", count(shape::TriangleOrigin::Made))
                  .Add("gaps", result.Mended.GapsClosed)
                  .Add("pieces", result.Pieces)
                  .Add("euler", result.EulerNumber)
                  .Add("same", static_cast<int>(isSame))
                  .Add("grid", result.Mended.GridSpacing)
                  .Add("valid", static_cast<int>(IsValidForCgal(solid)))
                  .Append(MeasureDistances(model, input, solid))
                  .Add("cpu", cost.Cpu)
                  .Add("wall", cost.Wall));
  if (wrap && result.Method != shape::SolidifyMethod::Report)
  {
    WrapByCgal(model, input, solid.Triangles.rows(), figures);
  }
}

const benchmark::Entry Solidify("solidify", { Usage, Run });

} // namespace
