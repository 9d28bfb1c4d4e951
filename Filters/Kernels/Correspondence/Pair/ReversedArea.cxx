#include "Correspondence/Pair/ReversedArea.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shape
{

double ComputeReversedArea(const Surface& a, const Surface& b, const SurfacePoints& aToB)
{
  const Eigen::MatrixXd image =
    ComputeAreaVectors({ PullBack(aToB, b.Triangles(), b.Points()), a.Triangles() });
  const Eigen::VectorXd areasA = a.AreaVectors().rowwise().norm();
  const Eigen::MatrixXd& normals = b.AreaVectors();
  const double areaA = areasA.sum(), areaB = normals.rowwise().norm().sum();
  double reversed = 0.0, all = 0.0;
  for (Eigen::Index t = 0; t < a.Triangles().rows(); ++t)
  {
    const Eigen::RowVector3d there = image.row(t),
                             normal = normals.row(aToB.Triangles(a.Triangles()(t, 0)));
    const double size = there.norm() * normal.norm();
    const double cosine = size > 0.0 ? there.dot(normal) / size : 0.0;
    const double weight = std::min(areasA(t) / areaA, there.norm() / areaB) * std::abs(cosine);
    reversed += cosine < 0.0 ? weight : 0.0;
    all += weight;
  }
  return all > 0.0 ? reversed / all : 0.0;
}

} // namespace shape
