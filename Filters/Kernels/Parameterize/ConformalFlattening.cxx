#include "Parameterize/ConformalFlattening.h"

#include "Laplacian/IntrinsicDelaunay.h"
#include "Linear/DirichletProblem.h"
#include "Mesh/BoundaryLoops.h"

#include <Eigen/LU>

#include <cmath>
#include <memory>
#include <vector>

namespace shape
{
namespace
{

/// Returns the angle defect of each point: 2 pi minus its angles, on the loop pi minus its angles.
Eigen::VectorXd Curvatures(
  const IntrinsicLaplacian& laplacian, Eigen::Index points, const std::vector<int>& loop)
{
  const Eigen::MatrixXi& triangles = laplacian.Flat.Triangles;
  Eigen::VectorXd curvatures = Eigen::VectorXd::Constant(points, 2.0 * M_PI);
  curvatures(loop).array() = M_PI;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      // The angle in (0, pi) with this cotangent.
      curvatures(triangles(t, corner)) -= std::atan2(1.0, laplacian.Angles.Cotangents(t, corner));
    }
  }
  return curvatures;
}

/// Returns the points (k x 2) of a closed polygon with turning angle turns(i) at point i. Its edge
/// lengths are close to `lengths`: the sum of squared changes divided by the lengths is minimal.
Eigen::MatrixXd ClosedPolygon(const Eigen::VectorXd& lengths, const Eigen::VectorXd& turns)
{
  const Eigen::Index count = lengths.size();
  Eigen::MatrixXd directions(count, 2);
  double angle = 0.0;
  for (Eigen::Index i = 0; i < count; ++i)
  {
    angle += i > 0 ? turns(i) : 0.0;
    directions.row(i) << std::cos(angle), std::sin(angle);
  }
  // Lagrange multipliers of the condition that the polygon closes: a 2 x 2 system.
  const Eigen::Matrix2d gram = directions.transpose() * lengths.asDiagonal() * directions;
  const Eigen::Vector2d gap = directions.transpose() * lengths;
  const Eigen::VectorXd closed =
    lengths - lengths.cwiseProduct(directions * gram.fullPivLu().solve(gap));
  Eigen::MatrixXd positions = Eigen::MatrixXd::Zero(count, 2);
  for (Eigen::Index i = 1; i < count; ++i)
  {
    positions.row(i) = positions.row(i - 1) + closed(i - 1) * directions.row(i - 1);
  }
  return positions;
}

} // namespace

Eigen::MatrixXd FlattenConformally(const Surface& surface, const Progress& progress)
{
  // Outline (boundary first flattening, Sawhney and Crane 2017):
  // 1. All loops but the longest are filled. The inner block of the Laplacian is factorised once.
  // 2. Curvatures of the surface inside, and of its loop.
  // 3. The Yamabe equation for the logarithm u of the scale, with u = 0 on the loop.
  // 4. Curvatures of the loop's image: those of the loop plus the flux of u.
  // 5. A closed polygon with these curvatures and nearly the lengths of the loop.
  // 6. The harmonic map with this boundary.
  progress(0.0);
  RequireSurfaceWithBoundary(surface, LoopCount::AtLeastOne);
  // Step 1: the Laplacian.
  const std::vector<std::vector<int>> loops = FindManifoldBoundaryLoops(surface);
  const std::vector<int>& loop = loops.front();
  const Surface filled = FillWithFans(surface, { loops.begin() + 1, loops.end() });
  const Eigen::Index points = filled.Points().rows();
  const std::shared_ptr<const IntrinsicLaplacian> laplacian = GetIntrinsicLaplacian(filled);
  const Eigen::SparseMatrix<double>& stiffness = laplacian->Stiffness;
  const DirichletProblem problem(stiffness, loop, progress.Part(0.3, 0.8));

  // Step 2: curvatures.
  const Eigen::MatrixXd curvatures = Curvatures(*laplacian, points, loop);
  // Step 3: the Yamabe equation.
  Eigen::MatrixXd scale = Eigen::MatrixXd::Zero(points, 1);
  problem.Solve(scale, -curvatures);
  // Step 4: curvatures of the image's boundary.
  const Eigen::VectorXd turns = (curvatures + stiffness * scale)(loop, 0);
  // Step 5: the boundary polygon.
  Eigen::VectorXd lengths(loop.size());
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const int next = loop[(i + 1) % loop.size()];
    lengths(static_cast<Eigen::Index>(i)) =
      (surface.Points().row(next) - surface.Points().row(loop[i])).norm();
  }
  Eigen::MatrixXd image = Eigen::MatrixXd::Zero(points, 2);
  image(loop, Eigen::all) = ClosedPolygon(lengths, turns);
  // Step 6: the harmonic map.
  problem.Solve(image, Eigen::MatrixXd::Zero(points, 2));
  progress(1.0);
  return image.topRows(surface.Points().rows());
}

} // namespace shape
