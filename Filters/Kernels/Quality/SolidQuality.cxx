#include "Quality/SolidQuality.h"

#include "Base/Parallel.h"
#include "Mesh/CellFaces.h"
#include "Quality/ScaledJacobian.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shape
{

namespace
{

constexpr double Tiny = 1e-150; ///< below all squared lengths that matter

/// Area vectors and centres of faces, and centres of cells, one per row.
struct FaceGeometry
{
  Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor> Areas, Centres, CellCentres;
};

/// The centres are means of triangles weighted by area, and of pyramids weighted by volume, as in
/// OpenFOAM.
FaceGeometry FindFaceGeometry(const Eigen::MatrixXd& points, const FaceMesh& faces)
{
  FaceGeometry found;
  const int count = faces.FaceCount();
  found.Areas.resize(count, 3);
  found.Centres.resize(count, 3);
  ParallelFor(count, 4096,
    [&](int begin, int end)
    {
      for (int face = begin; face < end; ++face)
      {
        const int first = faces.Offsets[face], corners = faces.Offsets[face + 1] - first;
        Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
        for (int k = 0; k < corners; ++k)
        {
          mean += points.row(faces.Corners[first + k]) / corners;
        }
        std::vector<Eigen::RowVector3d> areas(corners), centres(corners);
        Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
        for (int k = 0; k < corners; ++k)
        {
          const Eigen::RowVector3d a = points.row(faces.Corners[first + k]);
          const Eigen::RowVector3d b = points.row(faces.Corners[first + (k + 1) % corners]);
          areas[k] = 0.5 * (a - mean).cross(b - mean);
          centres[k] = (a + b + mean) / 3.0;
          sum += areas[k];
        }
        double total = 0.0;
        Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
        for (int k = 0; k < corners; ++k)
        {
          const double share = std::max(0.0, areas[k].dot(sum));
          total += share;
          centre += share * centres[k];
        }
        found.Areas.row(face) = sum;
        found.Centres.row(face) = total > Tiny ? Eigen::RowVector3d(centre / total) : mean;
      }
    });
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  Rows means = Rows::Zero(faces.CellCount, 3), sums = Rows::Zero(faces.CellCount, 3);
  Eigen::VectorXd counts = Eigen::VectorXd::Zero(faces.CellCount),
                  volumes = Eigen::VectorXd::Zero(faces.CellCount);
  const auto forSides = [&](const auto& visit)
  {
    for (int face = 0; face < count; ++face)
    {
      visit(face, faces.Owners[face], 1.0);
      if (faces.Neighbours[face] >= 0)
      {
        visit(face, faces.Neighbours[face], -1.0);
      }
    }
  };
  forSides(
    [&](int face, int cell, double)
    {
      means.row(cell) += found.Centres.row(face);
      counts(cell) += 1.0;
    });
  means = (counts.cwiseInverse().asDiagonal() * means).eval();
  forSides(
    [&](int face, int cell, double side)
    {
      const double volume =
        side * found.Areas.row(face).dot(found.Centres.row(face) - means.row(cell));
      volumes(cell) += volume;
      sums.row(cell) += volume * (0.75 * found.Centres.row(face) + 0.25 * means.row(cell));
    });
  found.CellCentres = means;
  for (int cell = 0; cell < faces.CellCount; ++cell)
  {
    if (std::abs(volumes(cell)) > Tiny)
    {
      found.CellCentres.row(cell) = sums.row(cell) / volumes(cell);
    }
  }
  return found;
}

/// Returns the skewness of a face (primitiveMeshTools of OpenFOAM).
double FindSkewness(
  const Eigen::MatrixXd& points, const FaceMesh& faces, const FaceGeometry& geometry, int face)
{
  const bool isInner = faces.Neighbours[face] >= 0;
  const Eigen::RowVector3d centre = geometry.Centres.row(face), area = geometry.Areas.row(face);
  const Eigen::RowVector3d owner = geometry.CellCentres.row(faces.Owners[face]);
  const Eigen::RowVector3d toFace = centre - owner;
  const double square = area.squaredNorm();
  const Eigen::RowVector3d line = isInner
    ? Eigen::RowVector3d(geometry.CellCentres.row(faces.Neighbours[face]) - owner)
    : Eigen::RowVector3d(area * (area.dot(toFace) / std::max(square, Tiny)));
  const double across = area.dot(line);
  const Eigen::RowVector3d away =
    toFace - line * (area.dot(toFace) / (std::abs(across) > Tiny ? across : Tiny));
  const double distance = away.norm();
  if (!(distance > 0.0))
  {
    return 0.0;
  }
  double radius = (isInner ? 0.2 : 0.4) * line.norm();
  for (int k = faces.Offsets[face]; k < faces.Offsets[face + 1]; ++k)
  {
    radius = std::max(radius, std::abs(away.dot(points.row(faces.Corners[k]) - centre)) / distance);
  }
  return distance / std::max(radius, Tiny);
}

/// For each corner of a kind of cell with three edges: the corner, then the ends of its edges.
const std::vector<std::array<int, 4>>& GetCornerEdges(int kind)
{
  static const std::vector<std::array<int, 4>> tetrahedron = { { 0, 1, 2, 3 }, { 1, 2, 0, 3 },
    { 2, 0, 1, 3 }, { 3, 0, 2, 1 } };
  static const std::vector<std::array<int, 4>> pyramid = { { 0, 1, 3, 4 }, { 1, 2, 0, 4 },
    { 2, 3, 1, 4 }, { 3, 0, 2, 4 } };
  static const std::vector<std::array<int, 4>> wedge = { { 0, 1, 2, 3 }, { 1, 2, 0, 4 },
    { 2, 0, 1, 5 }, { 3, 5, 4, 0 }, { 4, 3, 5, 1 }, { 5, 4, 3, 2 } };
  static const std::vector<std::array<int, 4>> hexahedron = { { 0, 1, 3, 4 }, { 1, 2, 0, 5 },
    { 2, 3, 1, 6 }, { 3, 0, 2, 7 }, { 4, 7, 5, 0 }, { 5, 4, 6, 1 }, { 6, 5, 7, 2 },
    { 7, 6, 4, 3 } };
  return kind == cell_kind::Tetrahedron ? tetrahedron
    : kind == cell_kind::Pyramid        ? pyramid
    : kind == cell_kind::Wedge          ? wedge
                                        : hexahedron;
}

/// Returns the determinant at the corners of a regular cell with edges of length 1.
double GetRegularDeterminant(int kind)
{
  return kind == cell_kind::Hexahedron ? 1.0
    : kind == cell_kind::Wedge         ? std::sqrt(0.75)
                                       : std::sqrt(0.5);
}

/// Returns the minimum of the scaled determinants at the corners. turned: the cell is numbered the
/// other way round.
double FindCornerMinimum(const Cells& cells, int cell, bool turned)
{
  const int first = cells.Offsets(cell);
  const auto point = [&](int corner)
  { return Eigen::RowVector3d(cells.Points.row(cells.Corners(first + corner))); };
  double minimum = 1.0;
  for (const auto& corner : GetCornerEdges(cells.Kinds(cell)))
  {
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k)
    {
      edges.row(k) = point(corner[k + 1]) - point(corner[0]);
    }
    const double lengths = edges.rowwise().norm().prod();
    const double determinant = turned ? -edges.determinant() : edges.determinant();
    minimum = std::min(minimum,
      lengths > 0.0 ? determinant / lengths / GetRegularDeterminant(cells.Kinds(cell)) : -1.0);
  }
  return minimum;
}

} // namespace

SolidQuality ComputeSolidQuality(const Cells& cells, const FaceMesh& faces)
{
  const FaceGeometry geometry = FindFaceGeometry(cells.Points, faces);
  const int count = faces.CellCount;
  SolidQuality quality;
  quality.ScaledJacobian = Eigen::VectorXd::Ones(count);
  quality.Inverted = Eigen::VectorXi::Zero(count);
  quality.NonOrthogonality = Eigen::VectorXd::Zero(count);
  quality.Skewness = Eigen::VectorXd::Zero(count);
  for (int face = 0; face < faces.FaceCount(); ++face)
  {
    const int owner = faces.Owners[face], neighbour = faces.Neighbours[face];
    const Eigen::RowVector3d area = geometry.Areas.row(face);
    const double skewness = FindSkewness(cells.Points, faces, geometry, face);
    const auto cosine = [&](const Eigen::RowVector3d& line)
    {
      const double lengths = line.norm() * area.norm();
      return lengths > 0.0 ? std::clamp(area.dot(line) / lengths, -1.0, 1.0) : -1.0;
    };
    double angle = 0.0;
    if (neighbour >= 0)
    {
      angle =
        std::acos(cosine(geometry.CellCentres.row(neighbour) - geometry.CellCentres.row(owner))) *
        180.0 / M_PI;
    }
    for (const int cell : { owner, neighbour })
    {
      if (cell < 0)
      {
        continue;
      }
      quality.NonOrthogonality(cell) = std::max(quality.NonOrthogonality(cell), angle);
      quality.Skewness(cell) = std::max(quality.Skewness(cell), skewness);
      if (cells.Kinds(cell) == PolyhedronKind)
      {
        const Eigen::RowVector3d line = geometry.Centres.row(face) - geometry.CellCentres.row(cell);
        quality.ScaledJacobian(cell) =
          std::min(quality.ScaledJacobian(cell), (cell == owner ? 1.0 : -1.0) * cosine(line));
      }
    }
  }
  ParallelFor(count, 4096,
    [&](int begin, int end)
    {
      for (int cell = begin; cell < end; ++cell)
      {
        double minimum = quality.ScaledJacobian(cell);
        if (cells.Kinds(cell) != PolyhedronKind)
        {
          minimum = FindCornerMinimum(cells, cell, faces.Turned[cell] != 0);
          quality.ScaledJacobian(cell) = minimum;
        }
        if (cells.Kinds(cell) == cell_kind::Hexahedron)
        {
          Eigen::Matrix<double, 8, 3> corners;
          for (int k = 0; k < 8; ++k)
          {
            corners.row(k) = cells.Points.row(cells.Corners(cells.Offsets(cell) + k));
          }
          quality.ScaledJacobian(cell) = ComputeScaledJacobian(corners);
        }
        quality.Inverted(cell) = minimum > 0.0 ? 0 : 1;
      }
    });
  return quality;
}

} // namespace shape
