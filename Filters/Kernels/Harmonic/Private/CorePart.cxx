#include "Harmonic/Private/CorePart.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Geometry/PositiveTetrahedron.h"
#include "Mesh/UsedPoints.h"
#include "Tetrahedra/Tetrahedralize.h"
#include "Untangle/Untangle.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace shape
{
namespace
{

/// Returns the tetrahedra whose images are inverted or have no volume.
std::vector<int> FindInverted(const FiniteElements& elements)
{
  std::vector<int> found;
  for (int t = 0; t < static_cast<int>(elements.Tetrahedra.rows()); ++t)
  {
    if (!IsPositive(elements.Images, elements.Tetrahedra.row(t)))
    {
      found.push_back(t);
    }
  }
  return found;
}

/// Returns the points at the boundary or more than some layers away from some tetrahedra.
std::vector<int> FindFixed(
  const FiniteElements& elements, const std::vector<int>& tetrahedra, const Progress& progress)
{
  constexpr int layers = 3;
  std::vector<char> near(elements.Points.rows(), 0);
  for (const int point : elements.Tetrahedra(tetrahedra, Eigen::all).reshaped())
  {
    near[point] = 1;
  }
  for (int layer = 0; layer < layers; ++layer)
  {
    progress(0.0);
    const std::vector<char> inner = near;
    for (Eigen::Index t = 0; t < elements.Tetrahedra.rows(); ++t)
    {
      const Eigen::RowVector4i ids = elements.Tetrahedra.row(t);
      const bool touches =
        std::any_of(ids.begin(), ids.end(), [&](int i) { return inner[i] != 0; });
      for (const int point : ids)
      {
        near[point] |= static_cast<char>(touches);
      }
    }
  }
  progress(0.0);
  const Eigen::MatrixXi faces = FindBoundaryTriangles(elements);
  progress(0.0);
  for (const int point : faces.reshaped())
  {
    near[point] = 0;
  }
  std::vector<int> fixed;
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    if (near[i] == 0)
    {
      fixed.push_back(static_cast<int>(i));
    }
  }
  return fixed;
}

/// Returns six times the volume of a tetrahedron; negative if it is inverted.
double ComputeDeterminant(const Eigen::MatrixXd& points, const Eigen::RowVector4i& ids)
{
  const Eigen::Matrix<double, 4, 3> corners = points(ids, Eigen::all);
  return (corners.bottomRows<3>().rowwise() - corners.row(0)).determinant();
}

/// Whether the image has a positive volume, beyond rounding. Else it cannot be untangled.
bool HasVolume(const FiniteElements& elements)
{
  double sum = 0.0;
  for (Eigen::Index t = 0; t < elements.Tetrahedra.rows(); ++t)
  {
    sum += ComputeDeterminant(elements.Images, elements.Tetrahedra.row(t));
  }
  const Eigen::RowVector3d box =
    elements.Images.colwise().maxCoeff() - elements.Images.colwise().minCoeff();
  return sum > 1e-14 * std::pow(box.maxCoeff(), 3);
}

/// Returns the volume of the tetrahedra that are inverted in the solid or in the image.
double MeasureInverted(const FiniteElements& elements)
{
  double sum = 0.0;
  for (const Eigen::RowVector4i ids : elements.Tetrahedra.rowwise())
  {
    if (!IsPositive(elements.Points, ids) || !IsPositive(elements.Images, ids))
    {
      sum += std::abs(ComputeDeterminant(elements.Points, ids)) / 6.0;
    }
  }
  return sum;
}

/// Untangles from the images that are given, and returns the work (UntangleOptions).
double UntangleFrom(
  FiniteElements& elements, bool splitCells, double maximumWork, const Progress& progress)
{
  const auto count = static_cast<int>(elements.Tetrahedra.rows());
  const Eigen::MatrixXi byCell = elements.Tetrahedra.transpose();
  UntangleOptions options;
  options.SplitCells = splitCells;
  options.MaximumWork = maximumWork;
  const UntangleResult result =
    Untangle({ elements.Images, Eigen::VectorXi::Constant(count, cell_kind::Tetrahedron),
               Eigen::VectorXi::LinSpaced(count + 1, 0, 4 * count), byCell.reshaped() },
      elements.Points, options, progress);
  // New points divide tetrahedra in the solid as in the image.
  elements.Points = result.Provenance.Weights * elements.Points;
  elements.Images = result.Solid.Points;
  elements.Tetrahedra = result.Solid.Corners.reshaped(4, result.Inverted.size()).transpose();
  return result.Work;
}

/// Fills the image of a part with new tetrahedra, and maps them to the part: the inverse of a map
/// without folds has none. Returns the tetrahedra, with the points of the boundary first, in the
/// order of `boundary`; none if TetGen does not fill the image.
FiniteElements MapInversely(const FiniteElements& part, const std::vector<int>& boundary,
  const Eigen::MatrixXi& triangles, double maximumWork, const Progress& progress)
{
  const auto count = static_cast<int>(boundary.size());
  const Surface image(part.Images(boundary, Eigen::all), triangles);
  const auto tetrahedra = static_cast<double>(part.Tetrahedra.rows());
  TetrahedralizeOptions options;
  options.MaximumVolume = 2.0 * ComputeEnclosedVolume(image) / tetrahedra; // see FillWithElements
  // Usual are a tenth as many. TetGen may not end where images are close to each other.
  options.MaximumNewPoints = 1 + static_cast<int>(0.5 * tetrahedra);
  TetrahedralizeResult filled;
  try
  {
    filled = Tetrahedralize(image, {}, options, progress.Part(0.0, 0.2));
  }
  catch (const InvalidInput&) // triangles whose area is rounding
  {
    return {};
  }
  catch (const SolveFailure&)
  {
    return {};
  }
  FiniteElements inverse{ std::move(filled.Points), std::move(filled.Tetrahedra), {}, {}, 0 };
  inverse.Images = Eigen::MatrixXd::Zero(inverse.Points.rows(), 3);
  inverse.Images.topRows(count) = part.Points(boundary, Eigen::all);
  std::vector<int> fixed(count);
  std::iota(fixed.begin(), fixed.end(), 0);
  SolveLaplace(inverse, fixed, progress.Part(0.2, 0.3));
  UntangleFrom(inverse, true, maximumWork, progress.Part(0.3, 1.0));
  std::swap(inverse.Points, inverse.Images);
  return inverse;
}

/// Maps a part inversely, if that inverts less of it.
void TryInverse(
  CorePart& part, const FiniteElements& given, double maximumWork, const Progress& progress)
{
  Eigen::MatrixXi triangles = FindBoundaryTriangles(given);
  std::vector<int> boundary = FindUsedPoints(triangles, given.Points.rows());
  triangles = RenumberPoints(triangles, boundary, given.Points.rows());
  FiniteElements inverse = MapInversely(given, boundary, triangles, maximumWork, progress);
  if (inverse.Tetrahedra.rows() == 0)
  {
    return;
  }
  const double inverted = MeasureInverted(inverse);
  if (inverted < MeasureInverted(part.Elements))
  {
    part.Elements = std::move(inverse);
    part.IsUntangled = inverted == 0.0;
    for (int& point : boundary)
    {
      point = part.Points[point];
    }
    part.Points = std::move(boundary);
  }
}

} // namespace

std::vector<int> FindPinches(const Surface& boundary)
{
  const Eigen::MatrixXi& triangles = boundary.Triangles();
  const std::vector<HalfEdge>& sides = boundary.HalfEdges();
  // Corners that are in one fan: of triangles that share an edge with no third.
  DisjointSets fans(static_cast<int>(triangles.size()));
  const auto getCorner = [&](const HalfEdge& side, int point)
  { return 3 * side.Triangle + (side.Corner + (side.Begin == point ? 0 : 1)) % 3; };
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
  {
    const int low = sides[begin].Low(), high = sides[begin].High();
    while (end < sides.size() && sides[end].Low() == low && sides[end].High() == high)
    {
      ++end;
    }
    for (const int point : { low, high })
    {
      if (end == begin + 2)
      {
        fans.Merge(getCorner(sides[begin], point), getCorner(sides[begin + 1], point));
      }
    }
  }
  std::vector<int> fanOf(boundary.Points().rows(), -1), points;
  for (int t = 0; t < static_cast<int>(triangles.rows()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      int& fan = fanOf[triangles(t, k)];
      const int found = fans.Find(3 * t + k);
      if (fan >= 0 && fan != found)
      {
        points.push_back(triangles(t, k));
      }
      fan = found;
    }
  }
  return points;
}

double UntanglePart(CorePart& part, double maximumWork, const Progress& progress)
{
  progress(0.0);
  const FiniteElements given = part.Elements;
  const std::vector<int> inverted = FindInverted(given);
  part.IsUntangled = inverted.empty();
  if (part.IsUntangled || !HasVolume(given))
  {
    return 0.0;
  }
  // Where the image is thinner than the error of f, a harmonic map between the points around may
  // be much nearer to a map without folds. If it inverts nearly as many, they hold each other.
  constexpr std::size_t few = 30, ratio = 4;
  std::vector<FiniteElements> starts(1, given);
  SolveLaplace(
    starts[0], FindFixed(given, inverted, progress.Part(0.0, 0.0)), progress.Part(0.0, 0.1));
  progress(0.1);
  const std::size_t left = FindInverted(starts[0]).size();
  progress(0.1);
  if (left >= std::max(std::min(few, inverted.size()), inverted.size() / ratio))
  {
    starts.clear();
  }
  if (starts.empty() || !part.Crosses) // else another start cannot help
  {
    starts.push_back(given);
  }
  double work = 0.0;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  const double step = 0.7 / static_cast<double>(starts.size());
  for (std::size_t i = 0; i < starts.size() && !part.IsUntangled; ++i)
  {
    const double begin = 0.1 + step * static_cast<double>(i);
    work += UntangleFrom(starts[i], !part.Crosses,
      (maximumWork - work) / static_cast<double>(starts.size() - i),
      progress.Part(begin, begin + step));
    const std::size_t count = FindInverted(starts[i]).size();
    if (count < fewest)
    {
      fewest = count;
      part.Elements = std::move(starts[i]);
      part.IsUntangled = count == 0;
    }
  }
  if (!part.IsUntangled && !part.Crosses)
  {
    TryInverse(part, given, maximumWork, progress.Part(0.8, 1.0));
  }
  return work;
}

} // namespace shape
