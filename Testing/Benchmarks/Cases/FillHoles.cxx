// Holes filled by ShapeMap and by CGAL's triangulate_refine_and_fair_hole, in one run.
#include "Cases/CgalMesh.h"
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "Fill/FillHoles.h"
#include "Fill/Private/PatchSelfIntersections.h"
#include "Laplacian/CotangentWeights.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/Topology.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"([MODEL]

Each of our methods, and CGAL 5's triangulate_refine_and_fair_hole (its default, C1); CPU seconds are
the median of five runs.

Without a model: the unit sphere, an icosahedron's faces each in 22 x 22 triangles (9,680 in all), of
which those within 20, 40, 70 and 110 degrees of an axis that is no symmetry's are removed. error is the
RMS distance of the new points from the sphere, in % of its radius; new counts triangles.

With a model (OFF): all of its holes. Points at the same position are left as they are. The first row is
what the model is: loops, and those that do not touch themselves. Then of each method: new triangles,
loops left open, the mean angle in degrees between the normals at the rims and those of the surface
there (across), pairs of triangles that meet, one of them new (crossings). CGAL's loops are its
extract_boundary_cycles'.)";

using CgalMesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;

/// The unit sphere: each face of an icosahedron in count x count triangles.
shape::Mesh FineIcosahedron(int count)
{
  const double golden = (1.0 + std::sqrt(5.0)) / 2.0;
  Eigen::MatrixXd corners(12, 3);
  corners << -1, golden, 0, 1, golden, 0, -1, -golden, 0, 1, -golden, 0, 0, -1, golden, 0, 1,
    golden, 0, -1, -golden, 0, 1, -golden, golden, 0, -1, golden, 0, 1, -golden, 0, -1, -golden, 0,
    1;
  Eigen::MatrixXi faces(20, 3);
  faces << 0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4, 11, 10, 2, 10, 7, 6,
    7, 1, 8, 3, 9, 4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11, 6, 2, 10, 8, 6, 7, 9,
    8, 1;
  std::map<std::array<int, 6>, int> numbers; // by the corners that share in a point, and shares
  std::vector<Eigen::RowVector3d> points;
  const auto number = [&](const Eigen::RowVector3i& face, int i, int j)
  {
    const int shares[3] = { count - i - j, i, j };
    std::array<std::array<int, 2>, 3> key;
    Eigen::RowVector3d position = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k)
    {
      key[k] = { shares[k] > 0 ? face(k) : -1, shares[k] };
      position += shares[k] * corners.row(face(k));
    }
    std::sort(key.begin(), key.end());
    const auto [entry, isNew] =
      numbers.try_emplace({ key[0][0], key[0][1], key[1][0], key[1][1], key[2][0], key[2][1] },
        static_cast<int>(points.size()));
    if (isNew)
    {
      points.emplace_back(position.normalized());
    }
    return entry->second;
  };
  std::vector<Eigen::RowVector3i> triangles;
  for (const Eigen::RowVector3i face : faces.rowwise())
  {
    for (int i = 0; i < count; ++i)
    {
      for (int j = 0; i + j < count; ++j)
      {
        triangles.emplace_back(number(face, i, j), number(face, i + 1, j), number(face, i, j + 1));
        if (i + j + 1 < count)
        {
          triangles.emplace_back(
            number(face, i + 1, j), number(face, i + 1, j + 1), number(face, i, j + 1));
        }
      }
    }
  }
  shape::Mesh mesh{ Eigen::MatrixXd(points.size(), 3), Eigen::MatrixXi(triangles.size(), 3) };
  std::copy(points.begin(), points.end(), mesh.Points.rowwise().begin());
  std::copy(triangles.begin(), triangles.end(), mesh.Triangles.rowwise().begin());
  return mesh;
}

/// A sphere without the triangles whose centroids are within some degrees of an axis.
shape::Mesh WithoutCap(const shape::Mesh& sphere, double degrees)
{
  const Eigen::RowVector3d axis = Eigen::RowVector3d(0.3, -0.5, 0.8).normalized();
  shape::Mesh open = sphere;
  Eigen::Index kept = 0;
  const Eigen::MatrixXd centres = shape::ComputeCentroids(sphere);
  for (Eigen::Index t = 0; t < centres.rows(); ++t)
  {
    if (centres.row(t).normalized().dot(axis) < std::cos(degrees * M_PI / 180.0))
    {
      open.Triangles.row(kept++) = sphere.Triangles.row(t);
    }
  }
  open.Triangles.conservativeResize(kept, 3);
  // Points that no triangle uses would be corners of CGAL's mesh.
  std::vector<int> used(open.Triangles.reshaped().begin(), open.Triangles.reshaped().end());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  open.Points = Eigen::MatrixXd(sphere.Points(used, Eigen::all));
  open.Triangles = Eigen::MatrixXi(open.Triangles.unaryExpr([&](int corner)
    { return int(std::lower_bound(used.begin(), used.end(), corner) - used.begin()); }));
  return open;
}

shape::Mesh FromCgal(const CgalMesh& mesh)
{
  shape::Mesh converted{ Eigen::MatrixXd(mesh.number_of_vertices(), 3),
    Eigen::MatrixXi(mesh.number_of_faces(), 3) };
  for (const auto vertex : mesh.vertices())
  {
    const auto& point = mesh.point(vertex);
    converted.Points.row(vertex.idx()) << point.x(), point.y(), point.z();
  }
  Eigen::Index row = 0;
  for (const auto face : mesh.faces())
  {
    int corner = 0;
    for (const auto vertex : CGAL::vertices_around_face(mesh.halfedge(face), mesh))
    {
      converted.Triangles(row, corner++) = static_cast<int>(vertex.idx());
    }
    ++row;
  }
  return converted;
}

void FillCgalMesh(CgalMesh& mesh)
{
  namespace pmp = CGAL::Polygon_mesh_processing;
  std::vector<CgalMesh::Halfedge_index> cycles;
  pmp::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  for (const auto cycle : cycles)
  {
    std::vector<CgalMesh::Face_index> faces;
    std::vector<CgalMesh::Vertex_index> vertices;
    pmp::triangulate_refine_and_fair_hole(
      mesh, cycle, std::back_inserter(faces), std::back_inserter(vertices));
  }
}

struct Filling
{
  shape::Mesh Surface; ///< filled; what was there comes first
  double Seconds = 0.0;
};

constexpr int Runs = 5;

Filling FillByShapeMap(const shape::Mesh& mesh, shape::FillMethod method)
{
  Filling filling;
  shape::FillHolesOptions options;
  options.Method = method;
  filling.Seconds = benchmark::MeasureMedian(
    Runs, [&] { filling.Surface = shape::FillHoles(mesh, options).Surface; });
  return filling;
}

Filling FillByCgal(const shape::Mesh& mesh)
{
  Filling filling;
  std::vector<CgalMesh> filled(Runs, benchmark::ToCgal<CgalMesh::Point>(mesh));
  std::size_t run = 0;
  filling.Seconds = benchmark::MeasureMedian(Runs, [&] { FillCgalMesh(filled[run++]); });
  filling.Surface = FromCgal(filled.front());
  return filling;
}

/// % of the radius.
double RadiusError(const shape::Mesh& surface, Eigen::Index first)
{
  const Eigen::ArrayXd errors =
    surface.Points.bottomRows(surface.Points.rows() - first).rowwise().norm().array() - 1.0;
  return 100.0 * std::sqrt(errors.square().mean());
}

/// Mean degrees between the normals of old and new triangles across the old borders' sides.
double AngleAcross(const shape::Mesh& surface, Eigen::Index old)
{
  std::map<std::array<int, 2>, std::array<int, 2>> beside; // old, new
  for (int t = 0; t < static_cast<int>(surface.Triangles.rows()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = surface.Triangles(t, k), b = surface.Triangles(t, (k + 1) % 3);
      auto& entry =
        beside.try_emplace({ std::min(a, b), std::max(a, b) }, std::array<int, 2>{ -1, -1 })
          .first->second;
      entry[t < old ? 0 : 1] = t;
    }
  }
  const Eigen::MatrixXd normals = shape::ComputeAreaVectors(surface).rowwise().normalized();
  double sum = 0.0;
  int count = 0;
  for (const auto& [edge, triangles] : beside)
  {
    if (triangles[0] >= 0 && triangles[1] >= 0)
    {
      const double cosine = normals.row(triangles[0]).dot(normals.row(triangles[1]));
      sum += std::isfinite(cosine) ? std::acos(std::clamp(cosine, -1.0, 1.0)) : 0.0;
      ++count;
    }
  }
  return count > 0 ? sum / count * 180.0 / M_PI : 0.0;
}

/// Fills by each method; `describe` adds to a row what a filled surface is like.
void FillByEach(const shape::Mesh& open, benchmark::Figures& figures, const benchmark::Row& first,
  const std::function<void(benchmark::Row&, const shape::Mesh&)>& describe)
{
  const auto report = [&](const std::string& name, const Filling& filling)
  {
    benchmark::Row row = first;
    row.Add("method", name).Add("new", filling.Surface.Triangles.rows() - open.Triangles.rows());
    describe(row, filling.Surface);
    figures.Print(row.Add("cpu", filling.Seconds));
  };
  report("CGAL", FillByCgal(open));
  report("Automatic", FillByShapeMap(open, shape::FillMethod::Automatic));
  report("Fair", FillByShapeMap(open, shape::FillMethod::Fair));
  report("Deformation", FillByShapeMap(open, shape::FillMethod::Deformation));
  report("Membrane", FillByShapeMap(open, shape::FillMethod::Membrane));
}

void FillSphere(benchmark::Figures& figures)
{
  const shape::Mesh sphere = FineIcosahedron(22);
  for (const int degrees : { 20, 40, 70, 110 })
  {
    const shape::Mesh open = WithoutCap(sphere, degrees);
    FillByEach(open, figures, benchmark::Row().Add("degrees", degrees),
      [&](benchmark::Row& row, const shape::Mesh& surface)
      { row.Add("error", RadiusError(surface, open.Points.rows())); });
  }
}

void FillModel(const std::string& path, benchmark::Figures& figures)
{
  const shape::Mesh open = benchmark::ReadOff(path, false);
  figures.Print(benchmark::Row()
                  .Add("triangles", open.Triangles.rows())
                  .Add("loops", shape::ComputeTopology(open).BoundaryLoops)
                  .Add("simple", shape::FindBoundaryLoops(open).Loops.size()));
  FillByEach(open, figures, {},
    [&](benchmark::Row& row, const shape::Mesh& surface)
    {
      const auto old = static_cast<int>(open.Triangles.rows());
      // A seam, where points are doubled, is no open loop.
      row.Add("open", shape::FindBoundaryLoops(surface).Loops.size())
        .Add("across", AngleAcross(surface, old))
        .Add("crossings", shape::FindPatchSelfIntersections(surface, old).size());
    });
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::vector<std::string> models = arguments.RemainingWords();
  if (models.size() > 1)
  {
    throw benchmark::UsageError("more than one model");
  }
  arguments.RequireAllRead();
  if (models.empty())
  {
    FillSphere(figures);
  }
  else
  {
    FillModel(models.front(), figures);
  }
}

const benchmark::Entry FillHoles("fill_holes", { Usage, Run });

} // namespace
