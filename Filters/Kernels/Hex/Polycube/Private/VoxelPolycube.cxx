#include "Hex/Polycube/Private/VoxelPolycube.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Distance/SignedDistance.h"
#include "Hex/Polycube/Private/AxisAlignment.h"
#include "Hex/Polycube/Private/AxisLabels.h"
#include "Hex/Polycube/Private/WorkingSolid.h"
#include "Hex/Voxels/WellComposedVoxels.h"
#include "Mesh/QuadSurface.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/CellLocator.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace shape
{
namespace
{

constexpr int WorkingTriangles = 3000;
/// Rounds of labelling and flattening.
constexpr int VoxelFlattenings = 3;
/// The levels of the distance, in cells, that bound the solid. They are tried in turn until one has
/// the topology.
constexpr double Reaches[] = { 0.1, 0.0, 0.25, -0.1 };
/// The factor by which cells become smaller until their topology agrees.
constexpr double CellShrinkage = 0.85;
/// Offsets of the grid that are compared along each axis.
constexpr int OffsetTrials = 16;
/// The fraction of the volume that may be inverted: it is repaired after the cells are mapped back.
constexpr double MaximumFolded = 0.02;

/// Finds the offsets, in cells, at which the grid's lines are closest to the surface's flat parts,
/// so that these are not cut into steps.
Eigen::RowVector3d BestOffset(const Surface& surface, const Eigen::VectorXi& labels, double size)
{
  const Eigen::VectorXd areas = surface.AreaVectors().rowwise().norm();
  const Eigen::MatrixXd centroids = ComputeCentroids(surface) / size;
  Eigen::RowVector3d best;
  for (int axis = 0; axis < 3; ++axis)
  {
    double minimum = std::numeric_limits<double>::max();
    for (int trial = 0; trial < OffsetTrials; ++trial)
    {
      const double offset = static_cast<double>(trial) / OffsetTrials;
      double sum = 0.0;
      for (Eigen::Index f = 0; f < labels.size(); ++f)
      {
        if (labels(f) / 2 == axis)
        {
          const double position = centroids(f, axis) - offset;
          // Centroids relative to the closest line of the grid, squared and weighted by area.
          const double off = position - std::round(position);
          sum += areas(f) * off * off;
        }
      }
      if (sum < minimum)
      {
        minimum = sum;
        best(axis) = offset;
      }
    }
  }
  return best;
}

/// Samples the signed distance at the centres of cells, on a grid shifted by the offset.
SampledGrid SampleDistance(const SignedDistance& distance, const Eigen::RowVector3d& offset,
  double size, const Progress& progress)
{
  const Eigen::MatrixXd& points = distance.Locator().GetSurface().Points();
  const Eigen::RowVector3d low =
    (points.colwise().minCoeff() / size - offset).array().floor().matrix();
  const Eigen::RowVector3d high =
    (points.colwise().maxCoeff() / size - offset).array().ceil().matrix();
  SampledGrid grid;
  grid.Spacing = size;
  constexpr double margin = 1.5; // cells: the outermost cells lie outside the solid
  grid.Counts = (high - low).cast<int>().array() + 4;
  grid.Origin = size * (low + offset - Eigen::RowVector3d::Constant(margin));
  Eigen::MatrixXd centres(grid.Counts.prod(), 3);
  for (int z = 0; z < grid.Counts(2); ++z)
  {
    for (int y = 0; y < grid.Counts(1); ++y)
    {
      for (int x = 0; x < grid.Counts(0); ++x)
      {
        centres.row(grid.Index(x, y, z)) = grid.Point(x, y, z);
      }
    }
  }
  grid.Values = distance.Evaluate(centres, progress).Distances;
  return grid;
}

/// Returns the cells inside the first level set that has the wanted topology.
std::optional<HexMesh> CubesOf(
  const SampledGrid& distances, const Topology& wanted, const Progress& progress)
{
  for (const double& reach : Reaches)
  {
    const double tried = static_cast<double>(&reach - Reaches) / std::size(Reaches);
    const Progress part = progress.Part(tried, 1.0);
    part(0.0);
    SampledGrid levels = distances;
    levels.Values.array() -= reach * levels.Spacing;
    WellComposedVoxels solid = FindVoxelSolid(levels);
    // Cells that only meet at an edge or a point have no manifold boundary.
    if (solid.Pinched > 0)
    {
      continue;
    }
    part(0.05);
    KeepLargestParts(levels, wanted.Components, solid.Inside);
    part(0.1);
    HexMesh cubes = BuildVoxelHexahedra(levels, solid.Inside);
    if (cubes.Hexahedra.rows() > 0 && HasBoundaryTopology(cubes, wanted))
    {
      return cubes;
    }
  }
  return std::nullopt;
}

/// Returns the volume of inverted tetrahedra, as a fraction of the undeformed volume.
double FoldedShare(const WorkingSolid& solid, const Eigen::MatrixXd& positions)
{
  double folded = 0.0, all = 0.0;
  for (const auto& c : solid.Tetrahedra.rowwise())
  {
    const auto volume = [&](const Eigen::MatrixXd& points)
    {
      const Eigen::Vector3d a = (points.row(c(1)) - points.row(c(0))).transpose();
      const Eigen::Vector3d b = (points.row(c(2)) - points.row(c(0))).transpose();
      const Eigen::Vector3d d = (points.row(c(3)) - points.row(c(0))).transpose();
      return a.cross(b).dot(d);
    };
    const double rest = volume(solid.Points);
    all += rest;
    folded += volume(positions) <= 0.0 ? rest : 0.0;
  }
  return folded / all;
}

/// Returns the points of a solid deformed towards the axes: flattened, or only aligned if that
/// folds.
Eigen::MatrixXd Bent(
  const WorkingSolid& solid, double compactness, Eigen::VectorXi& labels, const Progress& progress)
{
  const Eigen::MatrixXd aligned = AlignWithAxes(solid, progress.Part(0.0, 0.5));
  Eigen::MatrixXd positions = aligned;
  for (int round = 0; round < VoxelFlattenings; ++round)
  {
    labels = FindAxisLabels(solid, positions, compactness);
    positions = FlattenAlongAxes(solid, labels, positions, progress.Part(0.5, 1.0));
  }
  // Flattening may fold a solid that alignment alone does not.
  if (FoldedShare(solid, positions) <= MaximumFolded)
  {
    return positions;
  }
  const double folded = FoldedShare(solid, aligned);
  if (folded > MaximumFolded)
  {
    throw SolveFailure("the solid cannot be deformed towards the axes: " +
      FormatNumber(100.0 * folded) + " % of its volume would be inverted; choose Method Grid");
  }
  labels = FindAxisLabels(solid, aligned, compactness);
  return aligned;
}

/// The deformed tetrahedra, in which the grid's points are located.
Cells TetrahedraAt(const WorkingSolid& solid, const Eigen::MatrixXd& positions)
{
  const Eigen::Index count = solid.Tetrahedra.rows();
  Cells cells;
  cells.Points = positions;
  // 10: VTK_TETRA.
  cells.Kinds = Eigen::VectorXi::Constant(count, 10);
  cells.Offsets = Eigen::VectorXi::LinSpaced(count + 1, 0, static_cast<int>(4 * count));
  const Eigen::MatrixXi corners = solid.Tetrahedra.transpose();
  cells.Corners = corners.reshaped();
  return cells;
}

} // namespace

// 1. The solid is rotated and deformed towards the axes (Bent).
// 2. A grid is laid into the deformed solid. Its cells become smaller until they have the topology
//    of the surface.
// 3. The cells' points are mapped back by the barycentric coordinates in their tetrahedra.
VoxelPolycube FindVoxelPolycube(
  const Surface& surface, double compactness, int cells, int maximum, const Progress& progress)
{
  const Topology topology = RequireClosedSurface(surface, "the surface");
  const WorkingSolid original = BuildWorkingSolid(
    surface, WorkingTriangles, progress.Part(0.0, 0.2, "tetrahedralizing the solid"));
  WorkingSolid solid = original;
  solid.Points = original.Points * FindAxisRotation(original.Surface()).transpose();
  Eigen::VectorXi labels;
  const Eigen::MatrixXd positions = Bent(
    solid, compactness, labels, progress.Part(0.2, 0.7, "deforming the solid towards the axes"));
  progress(0.7);
  const Mesh bent = solid.Surface(positions);
  const double volume = ComputeEnclosedVolume(bent);
  const SignedDistance distance(bent);
  double size = std::cbrt(volume / cells);
  const double minimum = std::cbrt(volume / maximum);
  std::optional<HexMesh> cubes;
  SampledGrid grid;
  for (; !cubes; size *= CellShrinkage)
  {
    if (size < minimum)
    {
      throw SolveFailure("no grid of at most " + std::to_string(maximum) +
        " cells has the topology of the surface (Euler number " +
        std::to_string(topology.EulerNumber) +
        ") when the solid is deformed towards the axes; choose Method Grid");
    }
    progress(0.7);
    const auto offset = BestOffset(bent, labels, size);
    grid = SampleDistance(distance, offset, size, progress.Part(0.7, 0.8));
    cubes = CubesOf(grid, topology, progress.Part(0.8, 0.9));
  }
  VoxelPolycube result;
  result.CellSize = size / CellShrinkage;
  result.Solid = std::move(*cubes);
  const CellPoints found =
    CellLocator(TetrahedraAt(solid, positions)).Find(result.Solid.Points, progress.Part(0.9, 1.0));
  // Corners are half a cell away from the samples.
  result.Positions = ((result.Solid.Points.rowwise() - grid.Origin) / grid.Spacing).array() + 0.5;
  result.Positions = result.Positions.array().round().matrix().eval();
  result.Solid.Points = found.Weights * original.Points;
  return result;
}

} // namespace shape
