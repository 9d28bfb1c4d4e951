#include "Cage/Private/TriangleSumMap.h"

#include "Base/Parallel.h"

#include <algorithm>

namespace shape
{

TriangleSumMap::TriangleSumMap(const Mesh& cage, const Eigen::MatrixXd& steps)
  : Triangles(MakeCageTriangles(cage))
  , Steps(steps.transpose())
{
}

Eigen::Vector3d TriangleSumMap::FindNearStep(const CagePositions& positions, Eigen::Index i) const
{
  const CageTriangle& triangle = this->Triangles[positions.Closest.Triangles(i)];
  Eigen::Vector3d step = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    step += positions.Closest.Barycentrics(i, k) * this->Steps.col(triangle.Corners[k]);
  }
  return step;
}

CageMotion TriangleSumMap::Evaluate(const CagePositions& positions, const Progress& progress) const
{
  const Eigen::Index count = positions.Points.rows();
  const bool withGradient = positions.GradientAt.rows() > 0;
  CageMotion motion{ Eigen::MatrixXd(count, 3), Eigen::MatrixXd(withGradient ? count : 0, 9) };
  // A chunk takes about a hundredth of a second.
  constexpr int evaluations = 50000;
  ParallelFor(
    static_cast<int>(count), std::max(1, evaluations / static_cast<int>(this->Triangles.size())),
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        motion.Steps.row(i) = this->FindStep(positions, i);
        if (withGradient)
        {
          const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows =
            this->FindGradient(positions.GradientAt.row(i), this->FindNearStep(positions, i));
          motion.Gradients.row(i) = Eigen::Map<const Eigen::Matrix<double, 1, 9>>(rows.data());
        }
      }
    },
    progress);
  return motion;
}

} // namespace shape
