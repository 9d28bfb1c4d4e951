#include "Harmonic/Private/ImageSliding.h"

#include "Geometry/VertexNormals.h"
#include "Linear/LimitedMemoryBfgs.h"
#include "Mesh/Mesh.h"
#include "Search/ClosestPoint.h"
#include "Untangle/EllipticEnergy.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

constexpr int MaximumSteps = 60;
/// Sliding ends with a step that lowers the energy by less than this fraction of it.
constexpr double LeastGain = 1e-5;
/// Of the regularised determinant, relative to the determinant of an isometry.
constexpr double Epsilon = 0.05;

/// |J|^2 + |cof J|^2 / chi(det J)^2, where chi is the regularised determinant.
JacobianEnergy RegularisedDirichlet(const Eigen::Matrix3d& j)
{
  Eigen::Matrix3d cofactors;
  for (int k = 0; k < 3; ++k)
  {
    cofactors.col(k) = j.col((k + 1) % 3).cross(j.col((k + 2) % 3));
  }
  const double determinant = j.col(0).dot(cofactors.col(0));
  const double chi = EllipticEnergy::Chi(determinant, Epsilon), inverse = 1.0 / (chi * chi);
  const double square = cofactors.squaredNorm();
  const double slope = 0.5 * (1.0 + determinant / std::hypot(determinant, Epsilon)); // of chi
  // The derivative of |cof J|^2 is 2 (|J|^2 J - J J^T J).
  return { j.squaredNorm() + square * inverse,
    2.0 * j + 2.0 * inverse * (j.squaredNorm() * j - j * j.transpose() * j) -
      2.0 * square * inverse / chi * slope * cofactors };
}

/// The regularised elliptic energy. Inverted tetrahedra do not hide all others in it: it grows as
/// 1 / epsilon^2 in them, the energy above as 1 / epsilon^4.
JacobianEnergy Elliptic(const Eigen::Matrix3d& j)
{
  const EllipticEnergy energy(j, Epsilon);
  return { energy.Value(), energy.Gradient() };
}

/// The surface on which images slide.
class Rail
{
public:
  explicit Rail(const Surface& surface)
    : Locator(surface)
    , PointNormals(ComputeVertexNormals(surface, NormalWeight::Area))
  {
  }

  /// Moves images to the closest points, and sets the normals there. They are interpolated, so that
  /// images can cross creases.
  void Project(Eigen::MatrixXd& images, Eigen::MatrixXd& normals) const
  {
    const ClosestPoints closest = this->Locator.Find(images);
    normals = PullBack(closest, this->Locator.GetSurface().Triangles(), this->PointNormals)
                .rowwise()
                .normalized();
    images = closest.Positions;
  }

private:
  SurfaceLocator Locator;
  Eigen::MatrixXd PointNormals;
};

Eigen::MatrixXd Tangential(const Eigen::MatrixXd& vectors, const Eigen::MatrixXd& normals)
{
  const Eigen::VectorXd along = vectors.cwiseProduct(normals).rowwise().sum();
  return vectors - along.asDiagonal() * normals;
}

/// Moves images, which lie on the rail, to lower the energy.
void Descend(const HarmonicDistortion& energy, const BoundaryHessian& hessian,
  HarmonicDistortion::EnergyFunction function, const Rail& rail, Eigen::MatrixXd& at,
  const Progress& progress)
{
  Eigen::MatrixXd normals, gradient;
  rail.Project(at, normals);
  double value = energy.Evaluate(at, function, gradient);
  gradient = Tangential(gradient, normals);
  LimitedMemoryBfgs history([&](const Eigen::MatrixXd& vector) { return hessian.Solve(vector); });
  for (int step = 0; step < MaximumSteps; ++step)
  {
    Eigen::MatrixXd direction = -Tangential(history.Apply(gradient), normals);
    if (!(InnerProduct(direction, gradient) < 0.0))
    {
      history.Clear();
      direction = -Tangential(hessian.Solve(gradient), normals);
    }
    const double slope = InnerProduct(direction, gradient);
    const double farthest = direction.rowwise().norm().maxCoeff();
    if (!(slope < 0.0) || !(farthest > 0.0))
    {
      break;
    }
    // Without a history the length of the direction means little.
    constexpr double firstReach = 0.1, enough = 1e-4, shortest = 1e-6;
    double factor =
      history.IsEmpty() ? std::min(1.0, firstReach * ComputeLongestBoxEdge(at) / farthest) : 1.0;
    Eigen::MatrixXd next, nextNormals, nextGradient;
    double nextValue = value;
    for (; factor > shortest; factor *= 0.5)
    {
      progress(static_cast<double>(step) / MaximumSteps);
      next = at + factor * direction;
      rail.Project(next, nextNormals);
      nextValue = energy.Evaluate(next, function, nextGradient);
      if (nextValue <= value + enough * factor * slope)
      {
        break;
      }
    }
    if (factor <= shortest)
    {
      break;
    }
    nextGradient = Tangential(nextGradient, nextNormals);
    history.Add(
      Tangential(next - at, nextNormals), nextGradient - Tangential(gradient, nextNormals));
    const double gain = value - nextValue;
    at = std::move(next);
    normals = std::move(nextNormals);
    gradient = std::move(nextGradient);
    value = nextValue;
    if (gain < LeastGain * value)
    {
      break;
    }
  }
  progress(1.0);
}

} // namespace

Eigen::MatrixXd SlideImages(const FilledSolid& solid, const Eigen::MatrixXd& images,
  const Surface& target, const Progress& progress)
{
  const HarmonicDistortion energy(solid, progress.Part(0.0, 0.1));
  // The Hessian of the Dirichlet energy, K + M / l^2.
  const double longest = ComputeLongestBoxEdge(solid.Points);
  const BoundaryHessian hessian(
    energy, 1.0, energy.PointVolumes() / (longest * longest), progress.Part(0.1, 0.2));
  const Rail rail(target);
  Eigen::MatrixXd at = images, normals;
  rail.Project(at, normals);
  const bool isInverted = energy.CountInverted(energy.Map(at)) > 0;
  const double half = isInverted ? 0.6 : 0.2;
  if (isInverted)
  {
    Descend(energy, hessian, Elliptic, rail, at, progress.Part(0.2, half));
  }
  Descend(energy, hessian, RegularisedDirichlet, rail, at, progress.Part(half, 1.0));
  return at;
}

} // namespace shape
