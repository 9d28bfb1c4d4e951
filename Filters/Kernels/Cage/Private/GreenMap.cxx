#include "Cage/Private/GreenMap.h"

#include "Cage/Private/GreenWeights.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

/**
 * The normal of the moved triangle, times its stretch (Lipman, Levin and Cohen-Or 2008, section 4),
 *
 *   s = sqrt(|u'|^2 |v|^2 - 2 u'.v' u.v + |v'|^2 |u|^2) / (sqrt(8) area),
 *
 * with two edges u, v before and u', v' after the motion. s is the root mean square of the singular
 * values of the triangle's linear map. A moved triangle without area has no normal: 0.
 */
Eigen::Vector3d StretchNormal(const CageTriangle& triangle, const Eigen::MatrixXd& moved)
{
  const Eigen::Vector3d u = triangle.Points[1] - triangle.Points[0],
                        v = triangle.Points[2] - triangle.Points[0],
                        first = moved.row(triangle.Corners[0]),
                        movedU = moved.row(triangle.Corners[1]).transpose() - first,
                        movedV = moved.row(triangle.Corners[2]).transpose() - first;
  const double square = movedU.squaredNorm() * v.squaredNorm() -
    2.0 * movedU.dot(movedV) * u.dot(v) + movedV.squaredNorm() * u.squaredNorm();
  const double stretch = std::sqrt(std::max(0.0, square)) / (std::sqrt(2.0) * triangle.TwiceArea);
  return stretch * movedU.cross(movedV).normalized();
}

} // namespace

GreenMap::GreenMap(const Mesh& cage, const Eigen::MatrixXd& moved)
  : TriangleSumMap(cage, moved - cage.Points)
  , NormalSteps(3, cage.Triangles.rows())
{
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    this->NormalSteps.col(static_cast<Eigen::Index>(t)) =
      StretchNormal(this->Triangles[t], moved) - this->Triangles[t].Normal;
  }
}

Eigen::RowVector3d GreenMap::FindStep(const CagePositions& positions, Eigen::Index i) const
{
  // The solid angles sum to 1 inside. On the cage, those of the triangles around the point are
  // left out; what is missing belongs to the point (the jump of the double layer potential).
  const Eigen::Vector3d position = positions.Points.row(i);
  const Eigen::Vector3d near = this->FindNearStep(positions, i);
  Eigen::Vector3d sum = near;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const CageTriangle& triangle = this->Triangles[t];
    const TriangleView<double> view = SeeTriangle<double>(triangle, position);
    const GreenShares<double> shares = ComputeGreenShares(triangle, view);
    sum += shares.Normal * this->NormalSteps.col(static_cast<Eigen::Index>(t));
    for (int k = 0; k < 3; ++k)
    {
      sum += (shares.Points[k] + view.Barycentric[k] * shares.SolidAngle) *
        (this->Steps.col(triangle.Corners[k]) - near);
    }
  }
  return sum;
}

Eigen::Matrix3d GreenMap::FindGradient(
  const Eigen::Vector3d& position, const Eigen::Vector3d& near) const
{
  Eigen::Matrix3d slopes = Eigen::Matrix3d::Zero();
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    const CageTriangle& triangle = this->Triangles[t];
    const TriangleView<LinearNumber> view = SeeTriangle<LinearNumber>(triangle, position);
    const GreenShares<LinearNumber> shares = ComputeGreenShares(triangle, view);
    slopes += this->NormalSteps.col(static_cast<Eigen::Index>(t)) * shares.Normal.Slope.transpose();
    for (int k = 0; k < 3; ++k)
    {
      const LinearNumber share = shares.Points[k] + view.Barycentric[k] * shares.SolidAngle;
      slopes += (this->Steps.col(triangle.Corners[k]) - near) * share.Slope.transpose();
    }
  }
  return slopes;
}

} // namespace shape
