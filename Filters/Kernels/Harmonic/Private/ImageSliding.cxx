#include "Harmonic/Private/ImageSliding.h"

#include "Base/Parallel.h"
#include "Geometry/VertexNormals.h"
#include "Linear/DirichletProblem.h"
#include "Linear/LimitedMemoryBfgs.h"
#include "Linear/SparseSolve.h"
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

/// The energy of a Jacobian, and its derivative.
struct JacobianEnergy
{
  double Value;
  Eigen::Matrix3d Gradient;
};

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

using EnergyFunction = JacobianEnergy (*)(const Eigen::Matrix3d&);

/// The energy of harmonic maps of a solid as a function of the images of its boundary points.
class HarmonicDistortion
{
public:
  HarmonicDistortion(const SlidingSolid& solid, const Progress& progress)
    : Solid(solid)
    , Hats(solid.Tetrahedra.rows())
    , Volumes(solid.Tetrahedra.rows())
    , Stiffness(Assemble())
    , Inner(this->Stiffness, solid.Boundary, progress.Part(0.0, 0.5))
  {
    const double longest = ComputeLongestBoxEdge(solid.Points);
    Eigen::SparseMatrix<double> shifted = this->Stiffness;
    for (Eigen::Index t = 0; t < solid.Tetrahedra.rows(); ++t)
    {
      for (int k = 0; k < 4; ++k)
      {
        const int point = solid.Tetrahedra(t, k);
        shifted.coeffRef(point, point) += 0.25 * this->Volumes(t) / (longest * longest);
      }
    }
    this->Shifted.Factorize(shifted, progress.Part(0.5, 1.0));
    this->Volumes /= this->Volumes.sum();
  }

  /// Returns whether the map inverts a tetrahedron.
  bool Inverts(const Eigen::MatrixXd& images) const
  {
    const Eigen::MatrixXd map = this->Map(images);
    for (Eigen::Index t = 0; t < this->Volumes.size(); ++t)
    {
      if (!(this->Jacobian(t, map).determinant() > 0.0))
      {
        return true;
      }
    }
    return false;
  }

  /// Returns the mean energy of the map, and sets its gradient by the images (each k x 3).
  double Evaluate(
    const Eigen::MatrixXd& images, EnergyFunction function, Eigen::MatrixXd& gradient) const
  {
    const Eigen::MatrixXd map = this->Map(images);
    const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(map.rows(), 3);
    Eigen::VectorXd energies(this->Volumes.size());
    std::vector<Eigen::Matrix<double, 4, 3>> slopes(this->Volumes.size());
    ParallelFor(static_cast<int>(energies.size()), 2000,
      [&](int begin, int end)
      {
        for (int t = begin; t < end; ++t)
        {
          const JacobianEnergy energy = function(this->Jacobian(t, map));
          energies(t) = this->Volumes(t) * energy.Value;
          slopes[t] = this->Volumes(t) * this->Hats[t] * energy.Gradient.transpose();
        }
      });
    Eigen::MatrixXd slope = none;
    for (std::size_t t = 0; t < slopes.size(); ++t)
    {
      for (int k = 0; k < 4; ++k)
      {
        slope.row(this->Solid.Tetrahedra(static_cast<Eigen::Index>(t), k)) += slopes[t].row(k);
      }
    }
    // The adjoint problem: K_II a_I = g_I and a_B = 0. The gradient is g_B - K_BI a_I.
    Eigen::MatrixXd adjoint = none;
    this->Inner.Solve(adjoint, slope);
    slope -= this->Stiffness * adjoint;
    gradient = slope(this->Solid.Boundary, Eigen::all);
    return energies.sum();
  }

  /// Returns the product of the approximate inverse Hessian and a gradient.
  Eigen::MatrixXd Smooth(const Eigen::MatrixXd& gradient) const
  {
    return this->Shifted.Solve(this->Spread(gradient))(this->Solid.Boundary, Eigen::all);
  }

private:
  /// The images of all points (n x 3).
  Eigen::MatrixXd Map(const Eigen::MatrixXd& images) const
  {
    Eigen::MatrixXd map = this->Spread(images);
    this->Inner.Solve(map, Eigen::MatrixXd::Zero(map.rows(), 3));
    return map;
  }

  Eigen::Matrix3d Jacobian(Eigen::Index t, const Eigen::MatrixXd& map) const
  {
    Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
    for (int k = 0; k < 4; ++k)
    {
      jacobian += map.row(this->Solid.Tetrahedra(t, k)).transpose() * this->Hats[t].row(k);
    }
    return jacobian;
  }

  /// Also sets Hats and Volumes.
  Eigen::SparseMatrix<double> Assemble()
  {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(16 * this->Hats.size());
    for (Eigen::Index t = 0; t < this->Solid.Tetrahedra.rows(); ++t)
    {
      const Eigen::RowVector4i corners = this->Solid.Tetrahedra.row(t);
      Eigen::Matrix3d edges;
      for (int k = 0; k < 3; ++k)
      {
        edges.col(k) =
          (this->Solid.Points.row(corners(k + 1)) - this->Solid.Points.row(corners(0))).transpose();
      }
      this->Hats[t] = ComputeHatGradients(edges);
      this->Volumes(t) = edges.determinant() / 6.0;
      for (int i = 0; i < 4; ++i)
      {
        for (int k = 0; k < 4; ++k)
        {
          entries.emplace_back(corners(i), corners(k),
            this->Volumes(t) * this->Hats[t].row(i).dot(this->Hats[t].row(k)));
        }
      }
    }
    Eigen::SparseMatrix<double> stiffness(this->Solid.Points.rows(), this->Solid.Points.rows());
    stiffness.setFromTriplets(entries.begin(), entries.end());
    return stiffness;
  }

  /// Values at the boundary points, 0 at the others.
  Eigen::MatrixXd Spread(const Eigen::MatrixXd& values) const
  {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(this->Solid.Points.rows(), 3);
    all(this->Solid.Boundary, Eigen::all) = values;
    return all;
  }

  const SlidingSolid& Solid;
  std::vector<Eigen::Matrix<double, 4, 3>> Hats;
  Eigen::VectorXd Volumes; ///< their sum is 1
  Eigen::SparseMatrix<double> Stiffness;
  DirichletProblem Inner;
  SparseCholesky Shifted;
};

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
void Descend(const HarmonicDistortion& energy, EnergyFunction function, const Rail& rail,
  Eigen::MatrixXd& at, const Progress& progress)
{
  Eigen::MatrixXd normals, gradient;
  rail.Project(at, normals);
  double value = energy.Evaluate(at, function, gradient);
  gradient = Tangential(gradient, normals);
  LimitedMemoryBfgs history([&](const Eigen::MatrixXd& vector) { return energy.Smooth(vector); });
  for (int step = 0; step < MaximumSteps; ++step)
  {
    Eigen::MatrixXd direction = -Tangential(history.Apply(gradient), normals);
    if (!(InnerProduct(direction, gradient) < 0.0))
    {
      history.Clear();
      direction = -Tangential(energy.Smooth(gradient), normals);
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

Eigen::MatrixXd SlideImages(const SlidingSolid& solid, const Eigen::MatrixXd& images,
  const Surface& target, const Progress& progress)
{
  const HarmonicDistortion energy(solid, progress.Part(0.0, 0.2));
  const Rail rail(target);
  Eigen::MatrixXd at = images, normals;
  rail.Project(at, normals);
  const bool isInverted = energy.Inverts(at);
  const double half = isInverted ? 0.6 : 0.2;
  if (isInverted)
  {
    Descend(energy, Elliptic, rail, at, progress.Part(0.2, half));
  }
  Descend(energy, RegularisedDirichlet, rail, at, progress.Part(half, 1.0));
  return at;
}

} // namespace shape
