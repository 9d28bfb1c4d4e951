#include "Harmonic/Private/CorePart.h"

#include "Geometry/Orientation.h"
#include "Untangle/Untangle.h"

#include <Eigen/LU>

#include <algorithm>

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
std::vector<int> FindFixed(const FiniteElements& elements, const std::vector<int>& tetrahedra)
{
  constexpr int layers = 3;
  std::vector<char> near(elements.Points.rows(), 0);
  for (const int point : elements.Tetrahedra(tetrahedra, Eigen::all).reshaped())
  {
    near[point] = 1;
  }
  for (int layer = 0; layer < layers; ++layer)
  {
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
  const Eigen::MatrixXi faces = FindBoundaryTriangles(elements);
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

/// Returns six times the volume of the image.
double SumDeterminants(const FiniteElements& elements)
{
  double sum = 0.0;
  for (Eigen::Index t = 0; t < elements.Tetrahedra.rows(); ++t)
  {
    const Eigen::RowVector4i ids = elements.Tetrahedra.row(t);
    const Eigen::Matrix<double, 4, 3> image = elements.Images(ids, Eigen::all);
    sum += (image.bottomRows<3>().rowwise() - image.row(0)).determinant();
  }
  return sum;
}

} // namespace

bool IsPositive(const Eigen::MatrixXd& points, const Eigen::RowVector4i& ids)
{
  return EvaluateOrientation(
           points.row(ids(0)), points.row(ids(1)), points.row(ids(2)), points.row(ids(3))) > 0;
}

double UntanglePart(CorePart& part, double maximumWork, const Progress& progress)
{
  FiniteElements& elements = part.Elements;
  progress(0.0);
  const std::vector<int> inverted = FindInverted(elements);
  part.IsUntangled = inverted.empty();
  // A part whose image has no positive volume cannot be untangled.
  if (part.IsUntangled || !(SumDeterminants(elements) > 0.0))
  {
    return 0.0;
  }
  // Where the image is thinner than the error of f, a harmonic map between the points around may
  // be much nearer to a map without folds. If many tetrahedra stay inverted, they hold each other.
  constexpr std::size_t few = 30;
  FiniteElements harmonic = elements;
  SolveLaplace(harmonic, FindFixed(harmonic, inverted), progress.Part(0.0, 0.2));
  if (FindInverted(harmonic).size() < std::min(few, inverted.size()))
  {
    elements.Images = harmonic.Images;
  }
  const auto count = static_cast<int>(elements.Tetrahedra.rows());
  const Eigen::MatrixXi byCell = elements.Tetrahedra.transpose();
  UntangleOptions options;
  options.SplitCells = !part.Crosses; // splitting takes long, and cannot help
  options.MaximumWork = maximumWork;
  const UntangleResult result =
    Untangle({ elements.Images, Eigen::VectorXi::Constant(count, cell_kind::Tetrahedron),
               Eigen::VectorXi::LinSpaced(count + 1, 0, 4 * count), byCell.reshaped() },
      elements.Points, options, progress.Part(0.2, 1.0));
  // New points divide tetrahedra in the solid as in the image.
  elements.Points = result.Provenance.Weights * elements.Points;
  elements.Images = result.Solid.Points;
  elements.Tetrahedra = result.Solid.Corners.reshaped(4, result.Inverted.size()).transpose();
  part.IsUntangled = result.InvertedAfter == 0;
  return result.Work;
}

} // namespace shape
