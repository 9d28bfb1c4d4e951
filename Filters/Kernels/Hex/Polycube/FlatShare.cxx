#include "Hex/Polycube/FlatShare.h"

#include <cmath>
#include <utility>

namespace shape
{

double ComputeFlatShare(const Surface& surface)
{
  constexpr int directions = 6, candidates = 100;
  const double cosine = std::cos(10.0 * EIGEN_PI / 180.0);
  const Eigen::MatrixXd& vectors = surface.AreaVectors();
  const Eigen::VectorXd areas = vectors.rowwise().norm();
  const Eigen::MatrixXd normals = vectors.rowwise().normalized();
  const Eigen::Index step = 1 + normals.rows() / candidates;
  Eigen::ArrayXd left = areas.array();
  double flat = 0.0;
  for (int i = 0; i < directions; ++i)
  {
    double most = 0.0;
    Eigen::ArrayXd others = left;
    for (Eigen::Index t = 0; t < normals.rows(); t += step)
    {
      const Eigen::ArrayXd near =
        ((normals * normals.row(t).transpose()).array() >= cosine).cast<double>();
      if (const double area = (near * left).sum(); area > most)
      {
        most = area;
        others = (1.0 - near) * left;
      }
    }
    flat += most;
    left = std::move(others);
  }
  return flat / areas.sum();
}

} // namespace shape
