#include "Cage/Private/HarmonicMap.h"

#include "Base/Parallel.h"
#include "Linear/DirichletProblem.h"
#include "Mesh/CellFaces.h"
#include "Search/ClosestPoint.h"
#include "Tetrahedra/Tetrahedralize.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <vector>

namespace shape
{
namespace
{

/// The gradients of the four hat functions of a tetrahedron, in rows; volume: becomes its volume.
Eigen::Matrix<double, 4, 3> ComputeHatGradients(
  const Eigen::MatrixXd& points, const Eigen::RowVector4i& corners, double& volume)
{
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k)
  {
    edges.row(k) = points.row(corners(k + 1)) - points.row(corners(0));
  }
  volume = edges.determinant() / 6.0;
  Eigen::Matrix<double, 4, 3> gradients;
  gradients.bottomRows<3>() = edges.inverse().transpose();
  gradients.row(0) = -gradients.bottomRows<3>().colwise().sum();
  return gradients;
}

/// The stiffness matrix of linear finite elements.
Eigen::SparseMatrix<double> BuildStiffness(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra)
{
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(16 * tetrahedra.rows());
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
  {
    double volume = 0.0;
    const Eigen::Matrix<double, 4, 3> gradients =
      ComputeHatGradients(points, tetrahedra.row(t), volume);
    const Eigen::Matrix4d products = volume * gradients * gradients.transpose();
    for (int i = 0; i < 4; ++i)
    {
      for (int k = 0; k < 4; ++k)
      {
        entries.emplace_back(tetrahedra(t, i), tetrahedra(t, k), products(i, k));
      }
    }
  }
  Eigen::SparseMatrix<double> stiffness(points.rows(), points.rows());
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

Cells ToCells(const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra)
{
  Cells cells{ points, Eigen::VectorXi::Constant(tetrahedra.rows(), cell_kind::Tetrahedron),
    Eigen::VectorXi(tetrahedra.rows() + 1), Eigen::VectorXi(tetrahedra.size()) };
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t)
  {
    cells.Offsets(t) = static_cast<int>(4 * t);
    cells.Corners.segment<4>(4 * t) = tetrahedra.row(t);
  }
  cells.Offsets(tetrahedra.rows()) = static_cast<int>(tetrahedra.size());
  return cells;
}

/// The points on faces of only one tetrahedron, ascending.
std::vector<int> FindBoundaryPoints(const Cells& cells)
{
  std::vector<int> found;
  const std::vector<CellFace> faces = SortFaces(cells);
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    if (IsBoundaryFace(faces, i))
    {
      found.insert(found.end(), faces[i].Points.begin() + 1, faces[i].Points.end());
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

} // namespace

HarmonicMap::HarmonicMap(
  const Surface& cage, const Eigen::MatrixXd& steps, int tetrahedra, const Progress& progress)
{
  TetrahedralizeOptions options;
  // Tetrahedra have on average about half of the largest volume.
  options.MaximumVolume = 2.0 * ComputeEnclosedVolume(cage) / tetrahedra;
  // A cage has large triangles: without points on them, tetrahedra would be large there.
  options.PreserveBoundary = false;
  TetrahedralizeResult solid =
    Tetrahedralize(cage, {}, options, progress.Part(0.0, 0.6, "filling the cage with tetrahedra"));
  this->Points = std::move(solid.Points);
  this->Tetrahedra = std::move(solid.Tetrahedra);
  const Cells cells = ToCells(this->Points, this->Tetrahedra);
  const std::vector<int> boundary = FindBoundaryPoints(cells);
  const ClosestPoints closest = SurfaceLocator(cage).Find(this->Points(boundary, Eigen::all));
  this->Steps = Eigen::MatrixXd::Zero(this->Points.rows(), 3);
  this->Steps(boundary, Eigen::all) = PullBack(closest, cage.Triangles(), steps);

  const Eigen::SparseMatrix<double> stiffness = BuildStiffness(this->Points, this->Tetrahedra);
  const DirichletProblem problem(
    stiffness, boundary, progress.Part(0.6, 0.85, "solving Laplace's equation"));
  problem.Solve(this->Steps, Eigen::MatrixXd::Zero(this->Points.rows(), 3),
    progress.Part(0.85, 0.9, "solving Laplace's equation"));
  this->Locator = std::make_unique<CellLocator>(cells, progress.Part(0.9, 1.0));
}

CageMotion HarmonicMap::Evaluate(const CagePositions& positions, const Progress& progress) const
{
  const CellPoints found = this->Locator->Find(positions.Points, progress.Part(0.0, 0.9));
  const Eigen::Index count = positions.Points.rows();
  const bool withGradient = positions.GradientAt.rows() > 0;
  CageMotion motion{ found.Weights * this->Steps, Eigen::MatrixXd(withGradient ? count : 0, 9) };
  if (withGradient)
  {
    ParallelFor(
      static_cast<int>(count), 10000,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          const Eigen::RowVector4i corners = this->Tetrahedra.row(found.Ids(i));
          double volume = 0.0;
          const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> gradient =
            this->Steps({ corners(0), corners(1), corners(2), corners(3) }, Eigen::all)
              .transpose() *
            ComputeHatGradients(this->Points, corners, volume);
          motion.Gradients.row(i) = Eigen::Map<const Eigen::Matrix<double, 1, 9>>(gradient.data());
        }
      },
      progress.Part(0.9, 1.0));
  }
  progress(1.0);
  return motion;
}

} // namespace shape
