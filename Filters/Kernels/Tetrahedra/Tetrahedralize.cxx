#include "Tetrahedra/Tetrahedralize.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Geometry/Orientation.h"
#include "Mesh/Extent.h"
#include "Mesh/UsedPoints.h"
#include "Search/ClosestPoint.h"
#include "Solids/ConformingRegions.h"
#include "Solids/SolidRegions.h"
#include "Solids/SurfaceComplex.h"
#include "Tetrahedra/Private/SetsBetweenSurfaces.h"
#include "Tetrahedra/Private/TetGen.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// A tetrahedron with a smaller scaled Jacobian is flat: its volume is rounding.
constexpr double FlatJacobian = 1e-10;

void CheckOptions(const TetrahedralizeOptions& options)
{
  const double ratio = options.MaximumRadiusEdgeRatio, volume = options.MaximumVolume;
  if (!(ratio == 0.0 || ratio > 1.0) || std::isinf(ratio))
  {
    throw InvalidInput("MaximumRadiusEdgeRatio is " + FormatNumber(ratio) +
      "; give a number greater than 1, such as 2, or 0 for no bound");
  }
  if (!(volume >= 0.0) || std::isinf(volume))
  {
    throw InvalidInput("MaximumVolume is " + FormatNumber(volume) +
      "; give a positive volume in the model's units cubed, or 0 for no bound");
  }
  RequireOption(options.MaximumNewPoints >= 0, "MaximumNewPoints", options.MaximumNewPoints,
    "positive, or 0 for what the bounds suggest");
}

/// Orients all tetrahedra positively. Throws if their orientations differ.
void MakePositive(
  const Eigen::MatrixXd& points, Eigen::MatrixXi& tetrahedra, const Progress& progress)
{
  int expected = 0, wrong = 0;
  for (Eigen::Index i = 0; i < tetrahedra.rows(); ++i)
  {
    const int sign = EvaluateOrientation(points.row(tetrahedra(i, 0)), points.row(tetrahedra(i, 1)),
      points.row(tetrahedra(i, 2)), points.row(tetrahedra(i, 3)));
    expected = expected == 0 ? sign : expected;
    wrong += sign == 0 || sign != expected;
    ReportEvery(i, tetrahedra.rows(), progress);
  }
  if (wrong > 0)
  {
    throw SolveFailure("TetGen made " + std::to_string(wrong) +
      " tetrahedra that are flat or inverted; remesh where triangles are thin, or change "
      "PreserveBoundary");
  }
  if (expected < 0)
  {
    tetrahedra.col(0).swap(tetrahedra.col(1));
  }
}

struct Measures
{
  Eigen::VectorXd Volumes;
  double MinimumScaledJacobian = std::numeric_limits<double>::infinity();
  int Flat = 0; ///< number of tetrahedra with less than FlatJacobian
};

Measures Measure(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra, const Progress& progress)
{
  Measures measures{ Eigen::VectorXd(tetrahedra.rows()) };
  for (Eigen::Index i = 0; i < tetrahedra.rows(); ++i)
  {
    double length[4][4];
    for (int a = 0; a < 4; ++a)
    {
      for (int b = 0; b < 4; ++b)
      {
        length[a][b] = (points.row(tetrahedra(i, a)) - points.row(tetrahedra(i, b))).norm();
      }
    }
    double largest = 0.0;
    for (int a = 0; a < 4; ++a)
    {
      largest =
        std::max(largest, length[a][(a + 1) % 4] * length[a][(a + 2) % 4] * length[a][(a + 3) % 4]);
    }
    // The determinant of the edges is six times the volume; it is the same at all four corners.
    const RowVector3d origin = points.row(tetrahedra(i, 0));
    const RowVector3d u = points.row(tetrahedra(i, 1)) - origin;
    const RowVector3d v = points.row(tetrahedra(i, 2)) - origin;
    const RowVector3d w = points.row(tetrahedra(i, 3)) - origin;
    const double jacobian = u.cross(v).dot(w);
    measures.Volumes(i) = jacobian / 6.0;
    const double scaled = std::sqrt(2.0) * jacobian / largest;
    measures.MinimumScaledJacobian = std::min(measures.MinimumScaledJacobian, scaled);
    measures.Flat += scaled < FlatJacobian;
    ReportEvery(i, tetrahedra.rows(), progress);
  }
  return measures;
}

/// What is filled, in units in which its size is about 1.
struct Solid
{
  const Mesh& Surfaces;         ///< triangles that do not cross; all points are distinct and used
  const Eigen::MatrixXd& Holes; ///< a position in each void
  std::function<int(const RowVector3d&)> RegionAt;
  std::map<int, double> Volumes; ///< of the regions
  double Scale;                  ///< the factor of the units
};

/// Returns the volume of all regions.
double TotalVolume(const Solid& solid)
{
  double total = 0.0;
  for (const auto& [id, volume] : solid.Volumes)
  {
    total += volume;
  }
  return total;
}

/// Finds the region of each tetrahedron. Tetrahedra of regions without a volume are outside. Throws
/// if a region's volume is wrong.
Eigen::VectorXi FindRegionIds(const TetGenOutput& mesh, const Eigen::MatrixXi& onSurfaces,
  const Eigen::VectorXd& volumes, const Solid& solid, const Progress& progress)
{
  const Eigen::VectorXi set = FindSetsBetweenSurfaces(mesh.Tetrahedra, onSurfaces, progress);
  const int sets = set.maxCoeff() + 1;
  Eigen::VectorXi largest = Eigen::VectorXi::Constant(sets, -1);
  for (int i = 0; i < set.size(); ++i)
  {
    // The centroid of the largest tetrahedron is far from the surfaces, so its winding numbers are
    // certain.
    int& best = largest(set(i));
    best = best == -1 || volumes(i) > volumes(best) ? i : best;
  }
  Eigen::VectorXi regionOfSet(sets);
  for (int s = 0; s < sets; ++s)
  {
    const Eigen::RowVector4i corners = mesh.Tetrahedra.row(largest(s));
    regionOfSet(s) = solid.RegionAt(mesh.Points(corners, Eigen::all).colwise().mean());
  }
  Eigen::VectorXi region(set.size());
  std::map<int, double> found;
  for (Eigen::Index i = 0; i < set.size(); ++i)
  {
    region(i) = regionOfSet(set(i));
    found[region(i)] += volumes(i);
  }
  const double total = TotalVolume(solid);
  for (const auto& [id, volume] : solid.Volumes)
  {
    if (!(std::abs(found[id] - volume) <= 1e-9 * total))
    {
      throw SolveFailure("the volume of TetGen's tetrahedra in region " + std::to_string(id) +
        " differs by " + FormatNumber(100.0 * (found[id] / volume - 1.0)) +
        " % from the volume that the surfaces enclose; remesh where triangles are thin, or change "
        "PreserveBoundary");
    }
  }
  return region;
}

/// Removes the tetrahedra outside, and the points after the first `given` that none uses then.
/// Returns whether there were any.
bool RemoveOutside(
  TetGenOutput& mesh, Eigen::VectorXi& region, Eigen::Index given, const Solid& solid)
{
  std::vector<int> inside;
  for (int i = 0; i < static_cast<int>(region.size()); ++i)
  {
    if (solid.Volumes.count(region(i)) > 0)
    {
      inside.push_back(i);
    }
  }
  if (static_cast<Eigen::Index>(inside.size()) == region.size())
  {
    return false;
  }
  mesh.Tetrahedra = mesh.Tetrahedra(inside, Eigen::all).eval();
  region = region(inside).eval();
  std::vector<int> kept = FindUsedPoints(mesh.Tetrahedra, mesh.Points.rows());
  kept.erase(kept.begin(), std::lower_bound(kept.begin(), kept.end(), static_cast<int>(given)));
  std::vector<int> all(given);
  std::iota(all.begin(), all.end(), 0);
  all.insert(all.end(), kept.begin(), kept.end());
  mesh.Tetrahedra = RenumberPoints(mesh.Tetrahedra, all, mesh.Points.rows());
  mesh.Points = mesh.Points(all, Eigen::all).eval();
  return true;
}

/// Names the work, and its size before it begins if it may take long.
const char* DescribeWork(double tetrahedra)
{
  return tetrahedra < 1e5 ? "tetrahedralizing with TetGen"
    : tetrahedra < 1e6    ? "tetrahedralizing with TetGen: more than 100,000 tetrahedra"
    : tetrahedra < 1e7    ? "tetrahedralizing with TetGen: more than a million tetrahedra"
                          : "tetrahedralizing with TetGen: more than ten million tetrahedra";
}

/// Fills a solid. The provenance of the result is that of its surfaces' points.
TetrahedralizeResult Fill(
  const Solid& solid, const TetrahedralizeOptions& options, const Progress& progress)
{
  const double total = TotalVolume(solid);
  const double unit = solid.Scale * solid.Scale * solid.Scale;
  const double maximumVolume = options.MaximumVolume * unit;
  const double byVolume = maximumVolume > 0.0 ? total / maximumVolume : 0.0;
  if (byVolume > 1e8)
  {
    throw InvalidInput(
      "MaximumVolume would give more than 100 million tetrahedra; use a value greater than " +
      FormatNumber(total / unit * 1e-8));
  }
  const Eigen::Index given = solid.Surfaces.Points.rows();
  // Refinement may not end near very sharp angles, and takes long inside a thin sheet.
  const int maximumNewPoints = options.MaximumNewPoints > 0
    ? options.MaximumNewPoints
    : 1000000 + static_cast<int>(std::min(1e9, 50.0 * static_cast<double>(given) + byVolume));
  // On some surfaces TetGen never ends, without adding points. It needs 1e-4 s for a point.
  const int maximumSeconds = 10 + static_cast<int>(3e-4 * maximumNewPoints);
  TetGenOutput mesh =
    RunTetGen({ solid.Surfaces, solid.Holes, options.MaximumRadiusEdgeRatio, maximumVolume,
                options.PreserveBoundary, maximumNewPoints, maximumSeconds },
      progress.Part(0.0, 0.8, DescribeWork(byVolume)));
  if (mesh.Tetrahedra.rows() == 0 || mesh.Faces.rows() == 0 || mesh.Points.rows() < given ||
    mesh.Points.topRows(given) != solid.Surfaces.Points)
  {
    throw SolveFailure(
      "TetGen made no tetrahedra, or dropped points of the surface; use Clean with a tolerance "
      "above 0 to merge points that nearly coincide");
  }
  if (mesh.Points.rows() - given >= maximumNewPoints)
  {
    throw SolveFailure("TetGen added " + std::to_string(maximumNewPoints) +
      " points without reaching the bounds, as happens near sharp angles and in thin parts; "
      "raise "
      "MaximumRadiusEdgeRatio, or switch PreserveBoundary on");
  }
  MakePositive(mesh.Points, mesh.Tetrahedra, progress.Part(0.8, 0.84));
  Measures measures = Measure(mesh.Points, mesh.Tetrahedra, progress.Part(0.84, 0.86));
  TetrahedralizeResult result;
  result.RegionId =
    FindRegionIds(mesh, options.PreserveBoundary ? solid.Surfaces.Triangles : mesh.Faces,
      measures.Volumes, solid, progress.Part(0.86, 0.96, "finding the regions of the tetrahedra"));
  if (RemoveOutside(mesh, result.RegionId, given, solid))
  {
    measures = Measure(mesh.Points, mesh.Tetrahedra, progress.Part(0.96, 1.0));
  }
  result.Regions =
    static_cast<int>(std::set<int>(result.RegionId.begin(), result.RegionId.end()).size());
  result.SteinerPoints = static_cast<int>(mesh.Points.rows() - given);
  result.Volume = measures.Volumes.sum() / unit;
  result.MinimumScaledJacobian = measures.MinimumScaledJacobian;
  result.Flat = measures.Flat;
  result.Points = mesh.Points / solid.Scale;
  result.Tetrahedra = std::move(mesh.Tetrahedra);
  return result;
}

/// Sets where the points come from: the first ones from `originals`, and the others from nowhere.
void SetProvenance(
  TetrahedralizeResult& result, const Eigen::VectorXi& originals, Eigen::Index points)
{
  ProvenanceWriter provenance(points);
  for (const int point : originals)
  {
    provenance.AddCopy(point);
  }
  provenance.AddNone(result.Points.rows() - originals.size());
  result.Provenance = provenance.Finish(Eigen::VectorXi::Constant(result.Tetrahedra.rows(), -1));
}

/// Returns the factor, a power of two, that makes the size about 1: TetGen's own tolerances suit a
/// model of size 1, and a power of two changes no bit of the mantissas.
double ScaleOf(const Mesh& surface)
{
  const double size = ComputeLongestBoxEdge(surface);
  return size > 0.0 ? std::exp2(-std::ilogb(size)) : 1.0;
}

} // namespace

// 1. The surfaces are checked, scaled to a size of about 1 and joined.
// 2. RunTetGen: constrained Delaunay tetrahedralisation and refinement.
// 3. The result is checked: points, orientations, faces on the surfaces, volumes of the regions.
// 4. FindRegionIds: the region of each set of tetrahedra between the surfaces.
TetrahedralizeResult Tetrahedralize(const Surface& surface,
  const std::vector<Surface>& innerSurfaces, const TetrahedralizeOptions& options,
  const Progress& progress)
{
  CheckOptions(options);
  std::vector<Surface> surfaces = { surface };
  std::vector<std::string> names = { "the Input" };
  for (std::size_t i = 0; i < innerSurfaces.size(); ++i)
  {
    surfaces.push_back(innerSurfaces[i]);
    names.push_back("inner surface " + std::to_string(i));
  }
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    RequireClosed(surfaces[s], names[s]);
  }
  const double scale = ScaleOf(surface);
  for (Surface& each : surfaces)
  {
    each = scale == 1.0 ? each : each.WithPoints(scale * each.Points());
  }
  const SurfaceComplex complex = JoinSurfaces(surfaces);
  RequireConformingComplex(
    complex, names, 1.0 / scale, progress.Part(0.02, 0.2, "looking for self-intersections"));
  const SolidRegions regions(surfaces, names, progress.Part(0.2, 0.25));
  std::map<int, double> volumes;
  for (int region = 0; region < static_cast<int>(regions.Volumes().size()); ++region)
  {
    volumes[region] = regions.Volumes()(region);
  }
  const Eigen::MatrixXd holes = regions.FindPositionsInVoids();
  const auto regionAt = [&](const RowVector3d& position)
  {
    const int region = regions.RegionAt(position);
    if (region == SolidRegions::Void)
    {
      throw SolveFailure("TetGen filled a region outside the solid; remesh where parts of the "
                         "surface nearly touch");
    }
    return region;
  };
  TetrahedralizeResult result =
    Fill({ complex.Surfaces, holes, regionAt, volumes, scale }, options, progress.Part(0.25, 0.99));
  SetProvenance(result, complex.OriginalPoint, surface.Points().rows());
  progress(1.0);
  return result;
}

TetrahedralizeResult TetrahedralizeRegions(const Mesh& surfaces, const Eigen::MatrixXi& labels,
  const TetrahedralizeOptions& options, const Progress& progress)
{
  CheckOptions(options);
  const double scale = ScaleOf(surfaces);
  const Surface scaled(Mesh{ scale * surfaces.Points, surfaces.Triangles });
  // Duplicate points would separate regions that touch, so they are merged before the check.
  const SurfaceComplex complex = JoinSurfaces({ scaled });
  RequireConformingComplex(complex, { "the Input" }, 1.0 / scale,
    progress.Part(0.02, 0.2, "looking for self-intersections"));
  const ConformingRegions regions(complex.Surfaces, labels, progress.Part(0.2, 0.25));
  const Eigen::MatrixXd noHoles(0, 3); // the outside is removed afterwards
  TetrahedralizeResult result =
    Fill({ complex.Surfaces, noHoles,
           [&](const RowVector3d& position) { return regions.RegionAt(position); },
           regions.Volumes(), scale },
      options, progress.Part(0.25, 0.99));
  SetProvenance(result, complex.OriginalPoint, surfaces.Points.rows());
  progress(1.0);
  return result;
}

Provenance TraceClosestPositions(
  const Surface& surface, const TetrahedralizeResult& solid, const Progress& progress)
{
  std::vector<int> others;
  for (int i = 0; i < static_cast<int>(solid.Points.rows()); ++i)
  {
    if (solid.Provenance.Points(i) < 0)
    {
      others.push_back(i);
    }
  }
  const ClosestPoints closest =
    SurfaceLocator(surface).Find(solid.Points(others, Eigen::all), progress);
  ProvenanceWriter provenance(surface.Points().rows());
  Eigen::Index other = 0;
  for (const int point : solid.Provenance.Points)
  {
    if (point >= 0)
    {
      provenance.AddCopy(point);
    }
    else
    {
      provenance.AddOnTriangle(
        surface.Triangles().row(closest.Triangles(other)), closest.Barycentrics.row(other));
      ++other;
    }
  }
  return provenance.Finish(solid.Provenance.Cells);
}

} // namespace shape
