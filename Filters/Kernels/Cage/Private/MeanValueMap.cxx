#include "Cage/Private/MeanValueMap.h"

#include "Cage/Private/MeanValueWeights.h"

namespace shape
{

MeanValueMap::MeanValueMap(const Mesh& cage, const Eigen::MatrixXd& steps)
  : TriangleSumMap(cage, steps)
{
}

Eigen::RowVector3d MeanValueMap::FindStep(const CagePositions& positions, Eigen::Index i) const
{
  const Eigen::Vector3d near = this->FindNearStep(positions, i);
  if (positions.IsOnCage(i))
  {
    return near;
  }
  // Relative to the step of the closest point, whose neighbours have large weights.
  const Eigen::Vector3d position = positions.Points.row(i);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double total = 0.0;
  for (const CageTriangle& triangle : this->Triangles)
  {
    const std::array<double, 3> shares =
      ComputeMeanValueShares(triangle, SeeTriangle<double>(triangle, position));
    for (int k = 0; k < 3; ++k)
    {
      sum += shares[k] * (this->Steps.col(triangle.Corners[k]) - near);
      total += shares[k];
    }
  }
  return near + sum / total;
}

Eigen::Matrix3d MeanValueMap::FindGradient(
  const Eigen::Vector3d& position, const Eigen::Vector3d& near) const
{
  Eigen::Vector3d sum = Eigen::Vector3d::Zero(), totalSlope = Eigen::Vector3d::Zero();
  Eigen::Matrix3d slopes = Eigen::Matrix3d::Zero();
  double total = 0.0;
  for (const CageTriangle& triangle : this->Triangles)
  {
    const std::array<LinearNumber, 3> shares =
      ComputeMeanValueShares(triangle, SeeTriangle<LinearNumber>(triangle, position));
    for (int k = 0; k < 3; ++k)
    {
      const Eigen::Vector3d step = this->Steps.col(triangle.Corners[k]) - near;
      sum += shares[k].Value * step;
      slopes += step * shares[k].Slope.transpose();
      total += shares[k].Value;
      totalSlope += shares[k].Slope;
    }
  }
  return (slopes - (sum / total) * totalSlope.transpose()) / total;
}

} // namespace shape
