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

PositionBlock TriangleSumMap::MakeBlock(
  const CagePositions& positions, const Eigen::MatrixXd& points, int begin, int end) const
{
  PositionBlock block;
  for (int lane = 0; lane < PositionBlock::Size; ++lane)
  {
    const int i = std::min(begin + lane, end - 1);
    const Eigen::Vector3d near = this->FindNearStep(positions, i);
    for (int c = 0; c < 3; ++c)
    {
      block.Points[c][lane] = points(i, c);
      block.Near[c][lane] = near(c);
    }
  }
  return block;
}

CageMotion TriangleSumMap::Evaluate(const CagePositions& positions, const Progress& progress) const
{
  constexpr int size = PositionBlock::Size;
  const int count = static_cast<int>(positions.Points.rows());
  const bool withGradient = positions.GradientAt.rows() > 0;
  CageMotion motion{ Eigen::MatrixXd(count, 3), Eigen::MatrixXd(withGradient ? count : 0, 9) };
  // A chunk takes about a hundredth of a second.
  constexpr int evaluations = 200000;
  const int blocks = (count + size - 1) / size;
  ParallelFor(
    blocks, std::max(1, evaluations / (size * static_cast<int>(this->Triangles.size()))),
    [&](int firstBlock, int lastBlock)
    {
      for (int begin = firstBlock * size; begin < lastBlock * size; begin += size)
      {
        const int end = std::min(begin + size, count);
        const PositionBlock block = this->MakeBlock(positions, positions.Points, begin, end);
        StepBlock steps;
        this->FindSteps(block, steps);
        SlopeBlock slopes;
        if (withGradient)
        {
          this->FindSlopes(this->MakeBlock(positions, positions.GradientAt, begin, end), slopes);
        }
        for (int i = begin; i < end; ++i)
        {
          const bool isCage = this->FollowsCage() && positions.IsOnCage(i) != 0;
          for (int c = 0; c < 3; ++c)
          {
            motion.Steps(i, c) = (isCage ? block.Near : steps.Steps)[c][i - begin];
          }
          for (int c = 0; withGradient && c < 9; ++c)
          {
            motion.Gradients(i, c) = slopes.Slopes[c][i - begin];
          }
        }
      }
    },
    progress);
  return motion;
}

} // namespace shape
