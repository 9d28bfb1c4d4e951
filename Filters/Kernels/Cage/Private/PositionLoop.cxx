#include "Cage/Private/PositionLoop.h"

#include "Base/Parallel.h"

#include <algorithm>

namespace shape
{

Eigen::Vector3d InterpolateOnCage(const std::vector<CageTriangle>& triangles,
  const Eigen::Matrix3Xd& values, const CagePositions& positions, Eigen::Index i)
{
  const CageTriangle& triangle = triangles[positions.Closest.Triangles(i)];
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    value += positions.Closest.Barycentrics(i, k) * values.col(triangle.Corners[k]);
  }
  return value;
}

CageMotion MoveEach(const CagePositions& positions, int triangles,
  const std::function<Eigen::RowVector3d(Eigen::Index i)>& step,
  const std::function<Eigen::Matrix3d(Eigen::Index i)>& gradient, const Progress& progress)
{
  const Eigen::Index count = positions.Points.rows();
  const bool withGradient = positions.GradientAt.rows() > 0;
  CageMotion motion{ Eigen::MatrixXd(count, 3), Eigen::MatrixXd(withGradient ? count : 0, 9) };
  // A chunk takes about a hundredth of a second.
  constexpr int evaluations = 50000;
  ParallelFor(
    static_cast<int>(count), std::max(1, evaluations / triangles),
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        motion.Steps.row(i) = step(i);
        if (withGradient)
        {
          const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = gradient(i);
          motion.Gradients.row(i) = Eigen::Map<const Eigen::Matrix<double, 1, 9>>(rows.data());
        }
      }
    },
    progress);
  return motion;
}

} // namespace shape
