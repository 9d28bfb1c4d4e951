#include "Harmonic/Private/CorePart.h"

#include "Geometry/PositiveTetrahedron.h"
#include "Untangle/Untangle.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Whether the image has a positive volume, beyond rounding. Else it cannot be untangled.
bool HasVolume(const FiniteElements& elements)
{
  double sum = 0.0;
  for (Eigen::Index t = 0; t < elements.Tetrahedra.rows(); ++t)
  {
    const Eigen::RowVector4i ids = elements.Tetrahedra.row(t);
    const Eigen::Matrix<double, 4, 3> image = elements.Images(ids, Eigen::all);
    sum += (image.bottomRows<3>().rowwise() - image.row(0)).determinant();
  }
  const Eigen::RowVector3d box =
    elements.Images.colwise().maxCoeff() - elements.Images.colwise().minCoeff();
  return sum > 1e-14 * std::pow(box.maxCoeff(), 3);
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

} // namespace

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
  const double step = 0.9 / static_cast<double>(starts.size());
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
  return work;
}

} // namespace shape
