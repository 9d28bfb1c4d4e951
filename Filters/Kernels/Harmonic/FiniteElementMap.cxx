#include "Harmonic/FiniteElementMap.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Harmonic/Private/HatFunctions.h"
#include "Harmonic/Private/ScaledBoundary.h"
#include "Linear/DirichletProblem.h"
#include "Mesh/CellFaces.h"
#include "Search/ClosestPoint.h"
#include "Solids/Nesting.h"
#include "Tetrahedra/Tetrahedralize.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

Cells ToCells(const FiniteElements& elements)
{
  const Eigen::Index count = elements.Tetrahedra.rows();
  const Eigen::MatrixXi byCell = elements.Tetrahedra.transpose();
  return { elements.Points, Eigen::VectorXi::Constant(count, cell_kind::Tetrahedron),
    Eigen::VectorXi::LinSpaced(count + 1, 0, static_cast<int>(4 * count)), byCell.reshaped() };
}

/// Returns the points of the boundary, in ascending order.
std::vector<int> FindFixedPoints(const FiniteElements& elements)
{
  std::vector<int> fixed(
    elements.Boundary.data(), elements.Boundary.data() + elements.Boundary.size());
  std::sort(fixed.begin(), fixed.end());
  fixed.erase(std::unique(fixed.begin(), fixed.end()), fixed.end());
  return fixed;
}

FiniteElements RequireComplete(FiniteElements elements)
{
  const Eigen::Index points = elements.Points.rows();
  if (elements.Tetrahedra.rows() == 0 || elements.Tetrahedra.cols() != 4)
  {
    throw InvalidInput("the map has no tetrahedra");
  }
  if (elements.Images.rows() != points)
  {
    throw InvalidInput("the map has " + std::to_string(points) + " points and " +
      std::to_string(elements.Images.rows()) + " images; give each point one image");
  }
  if (elements.Tetrahedra.minCoeff() < 0 || elements.Tetrahedra.maxCoeff() >= points)
  {
    throw InvalidInput("a tetrahedron of the map has a corner that is no point of the map");
  }
  return elements;
}

} // namespace

Eigen::MatrixXi FindBoundaryTriangles(const FiniteElements& elements)
{
  const std::vector<CellFace> faces = SortFaces(ToCells(elements));
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (IsBoundaryFace(faces, i))
    {
      found.push_back(i);
    }
  }
  Eigen::MatrixXi boundary(found.size(), 3);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const CellFace& face = faces[found[i]];
    const std::vector<int>& corners = GetFaces(cell_kind::Tetrahedron)[face.Face];
    for (int k = 0; k < 3; ++k)
    {
      boundary(static_cast<Eigen::Index>(i), k) = elements.Tetrahedra(face.Cell, corners[k]);
    }
  }
  return boundary;
}

FiniteElements FillWithElements(const Surface& given, const Eigen::MatrixXd& givenValues,
  int tetrahedra, bool preserveBoundary, int maximumNewPoints, const Progress& progress)
{
  RequireOption(tetrahedra > 0, "Tetrahedra", tetrahedra, "positive");
  if (givenValues.rows() != given.Points().rows())
  {
    throw InvalidInput("the boundary has " + std::to_string(given.Points().rows()) +
      " points and " + std::to_string(givenValues.rows()) + " values; give each point one value");
  }
  // TetGen's result depends on the numbering.
  SortedSurface sorted =
    SortByPosition(OrientByNesting(given, "the boundary", progress.Part(0.0, 0.1)));
  const Surface boundary = std::move(sorted.Surface);
  const Eigen::MatrixXd values = givenValues(sorted.Points, Eigen::all);
  TetrahedralizeOptions options;
  // Tetrahedra have on average about half of the largest volume.
  options.MaximumVolume = 2.0 * ComputeEnclosedVolume(boundary) / tetrahedra;
  options.PreserveBoundary = preserveBoundary;
  options.MaximumNewPoints = maximumNewPoints;
  TetrahedralizeResult solid = Tetrahedralize(
    boundary, {}, options, progress.Part(0.1, 0.9, "filling the solid with tetrahedra"));
  FiniteElements elements{ std::move(solid.Points), std::move(solid.Tetrahedra), {}, {}, 0 };
  elements.Boundary = FindBoundaryTriangles(elements);

  // The values at the boundary: given, or linear in its triangles.
  const std::vector<int> fixed = FindFixedPoints(elements);
  const ClosestPoints closest =
    SurfaceLocator(boundary).Find(elements.Points(fixed, Eigen::all), progress.Part(0.9, 1.0));
  const Eigen::MatrixXd interpolated = PullBack(closest, boundary.Triangles(), values);
  elements.Images = Eigen::MatrixXd::Zero(elements.Points.rows(), values.cols());
  for (std::size_t i = 0; i < fixed.size(); ++i)
  {
    const int source = solid.Provenance.Points(fixed[i]);
    elements.Images.row(fixed[i]) =
      source >= 0 ? values.row(source) : interpolated.row(static_cast<Eigen::Index>(i));
  }
  elements.FreePoints =
    static_cast<int>(elements.Points.rows() - static_cast<Eigen::Index>(fixed.size()));
  progress(1.0);
  return elements;
}

void SolveLaplace(FiniteElements& elements, const std::vector<int>& fixed, const Progress& progress)
{
  const Eigen::SparseMatrix<double> stiffness =
    BuildStiffness(elements.Points, elements.Tetrahedra);
  const DirichletProblem problem(stiffness, fixed, progress.Part(0.0, 0.9));
  Eigen::MatrixXd images = Eigen::MatrixXd::Zero(elements.Points.rows(), elements.Images.cols());
  images(fixed, Eigen::all) = elements.Images(fixed, Eigen::all);
  problem.Solve(
    images, Eigen::MatrixXd::Zero(images.rows(), images.cols()), progress.Part(0.9, 1.0));
  elements.Images = std::move(images);
}

FiniteElements ComputeFiniteElements(
  const Surface& boundary, const Eigen::MatrixXd& values, int tetrahedra, const Progress& progress)
{
  // Large triangles would have large tetrahedra if no points could be added on them.
  FiniteElements elements =
    FillWithElements(boundary, values, tetrahedra, false, 0, progress.Part(0.0, 0.65));
  SolveLaplace(
    elements, FindFixedPoints(elements), progress.Part(0.65, 1.0, "solving Laplace's equation"));
  progress(1.0);
  return elements;
}

FiniteElementMap::FiniteElementMap(FiniteElements elements, const Progress& progress)
  : Data(RequireComplete(std::move(elements)))
  , Locator(ToCells(this->Data), progress)
{
}

FiniteElementMap::Values FiniteElementMap::Evaluate(
  const Eigen::MatrixXd& points, const Progress& progress, double farthest) const
{
  CellPoints found = this->Locator.Find(points, progress, farthest);
  return { found.Weights * this->Data.Images, std::move(found.Ids), std::move(found.Distances) };
}

Eigen::MatrixXd FiniteElementMap::Jacobians(
  const Eigen::VectorXi& cells, const Progress& progress) const
{
  const Eigen::Index dimensions = this->Data.Images.cols();
  Eigen::MatrixXd jacobians(cells.size(), 3 * dimensions);
  ParallelFor(
    static_cast<int>(cells.size()), 10000,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const Eigen::RowVector4i corners = this->Data.Tetrahedra.row(cells(i));
        const HatFunctions hats = ComputeHats(this->Data.Points, corners);
        for (Eigen::Index r = 0; r < dimensions; ++r)
        {
          Eigen::RowVector3d gradient = Eigen::RowVector3d::Zero();
          for (int k = 0; k < 4; ++k)
          {
            gradient += this->Data.Images(corners(k), r) * hats.Gradients.row(k);
          }
          jacobians.block<1, 3>(i, 3 * r) = gradient;
        }
      }
    },
    progress);
  return jacobians;
}

FiniteElementMap FiniteElementMap::Inverse(const Progress& progress) const
{
  FiniteElements inverse = this->Data;
  inverse.Points.swap(inverse.Images);
  return FiniteElementMap(std::move(inverse), progress);
}

} // namespace shape
