#include "Geometry/MovedNormals.h"

#include <Eigen/Geometry>

#include <cmath>

namespace shape
{
namespace
{

/// The linear map of a triangle.
class TriangleMotion
{
public:
  TriangleMotion(
    const Eigen::MatrixXd& old, const Eigen::MatrixXd& moved, const Eigen::RowVector3i& corners)
    : OldA(old.row(corners(1)) - old.row(corners(0)))
    , OldB(old.row(corners(2)) - old.row(corners(0)))
    , Across(OldA.cross(OldB))
  {
    const Eigen::RowVector3d a = moved.row(corners(1)) - moved.row(corners(0));
    const Eigen::RowVector3d b = moved.row(corners(2)) - moved.row(corners(0));
    this->MovedAcross = a.cross(b);
    const Eigen::RowVector3d normal = this->MovedAcross.stableNormalized();
    this->DualA = b.cross(normal);
    this->DualB = normal.cross(a);
  }

  double WeightOf() const { return this->MovedAcross.norm(); }
  bool HasArea() const { return this->Across.norm() > 0.0 && this->WeightOf() > 0.0; }

  /// Twice the new area times the normal that the inverse transpose makes of a unit normal, up to
  /// the scaling along the normal. DualA and DualB are the dual basis of the new edges, times twice
  /// the new area.
  Eigen::RowVector3d Carry(const Eigen::RowVector3d& normal) const
  {
    const double area = this->Across.norm();
    const double scale = std::sqrt(this->WeightOf() / area);
    return normal.dot(this->Across) / area * this->MovedAcross +
      scale * (normal.dot(this->OldA) * this->DualA + normal.dot(this->OldB) * this->DualB);
  }

private:
  Eigen::RowVector3d OldA, OldB, Across, MovedAcross, DualA, DualB;
};

} // namespace

Eigen::MatrixXd MoveNormals(const Mesh& surface, const Eigen::MatrixXd& moved,
  const Eigen::MatrixXd& normals, const std::vector<Eigen::Matrix3d>& rotations)
{
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(normals.rows(), 3);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(normals.rows());
  for (const auto& corners : surface.Triangles.rowwise())
  {
    const TriangleMotion motion(surface.Points, moved, corners);
    if (!motion.HasArea())
    {
      continue;
    }
    for (const int corner : corners)
    {
      sums.row(corner) += motion.Carry(normals.row(corner));
      weights(corner) += motion.WeightOf();
    }
  }
  // A sum this small is rounding: the triangles around the point cancel, or there are none.
  constexpr double least = 1e-9;
  for (Eigen::Index i = 0; i < sums.rows(); ++i)
  {
    sums.row(i) = sums.row(i).norm() > least * weights(i)
      ? Eigen::RowVector3d(sums.row(i).stableNormalized())
      : Eigen::RowVector3d((rotations[i] * normals.row(i).transpose()).transpose());
  }
  return sums;
}

} // namespace shape
