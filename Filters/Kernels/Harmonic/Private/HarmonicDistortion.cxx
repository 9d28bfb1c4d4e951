#include "Harmonic/Private/HarmonicDistortion.h"

#include "Base/Parallel.h"

#include <Eigen/LU>

#include <limits>
#include <utility>

namespace shape
{

JacobianEnergy SymmetricDirichlet(const Eigen::Matrix3d& jacobian)
{
  if (!(jacobian.determinant() > 0.0))
  {
    return { std::numeric_limits<double>::infinity(), Eigen::Matrix3d::Zero() };
  }
  const Eigen::Matrix3d inverse = jacobian.inverse();
  return { jacobian.squaredNorm() + inverse.squaredNorm(),
    2.0 * (jacobian - inverse.transpose() * inverse * inverse.transpose()) };
}

namespace
{

std::vector<HatFunctions> ComputeAllHats(const FilledSolid& solid)
{
  std::vector<HatFunctions> hats(solid.Tetrahedra.rows());
  for (Eigen::Index t = 0; t < solid.Tetrahedra.rows(); ++t)
  {
    hats[t] = ComputeHats(solid.Points, solid.Tetrahedra.row(t));
  }
  return hats;
}

} // namespace

HarmonicDistortion::HarmonicDistortion(FilledSolid solid, const Progress& progress)
  : Filled(std::move(solid))
  , Hats(ComputeAllHats(this->Filled))
  , Matrix(BuildStiffness(this->Filled.Points, this->Filled.Tetrahedra))
  , Inner(this->Matrix, this->Filled.Boundary, progress)
{
}

Eigen::MatrixXd HarmonicDistortion::Map(const Eigen::MatrixXd& images) const
{
  Eigen::MatrixXd map = this->Spread(images);
  this->Inner.Solve(map, Eigen::MatrixXd::Zero(map.rows(), 3));
  return map;
}

int HarmonicDistortion::CountInverted(const Eigen::MatrixXd& map) const
{
  int inverted = 0;
  for (Eigen::Index t = 0; t < this->Filled.Tetrahedra.rows(); ++t)
  {
    inverted += this->Jacobian(t, map).determinant() > 0.0 ? 0 : 1;
  }
  return inverted;
}

double HarmonicDistortion::Evaluate(
  const Eigen::MatrixXd& images, EnergyFunction function, Eigen::MatrixXd& gradient) const
{
  const Eigen::MatrixXd map = this->Map(images);
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(map.rows(), 3);
  const double volume = this->Volume();
  Eigen::VectorXd energies(this->Filled.Tetrahedra.rows());
  std::vector<Eigen::Matrix<double, 4, 3>> slopes(energies.size());
  ParallelFor(static_cast<int>(energies.size()), 2000,
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        const JacobianEnergy energy = function(this->Jacobian(t, map));
        const double share = this->Hats[t].Volume / volume;
        energies(t) = share * energy.Value;
        slopes[t] = share * this->Hats[t].Gradients * energy.Gradient.transpose();
      }
    });
  Eigen::MatrixXd slope = none;
  for (std::size_t t = 0; t < slopes.size(); ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      slope.row(this->Filled.Tetrahedra(static_cast<Eigen::Index>(t), k)) += slopes[t].row(k);
    }
  }
  // The adjoint problem: K_II a_I = g_I and a_B = 0. The gradient is g_B - K_BI a_I.
  Eigen::MatrixXd adjoint = none;
  this->Inner.Solve(adjoint, slope);
  slope -= this->Matrix * adjoint;
  gradient = slope(this->Filled.Boundary, Eigen::all);
  return energies.sum();
}

double HarmonicDistortion::Volume() const
{
  double volume = 0.0;
  for (const HatFunctions& hats : this->Hats)
  {
    volume += hats.Volume;
  }
  return volume;
}

Eigen::VectorXd HarmonicDistortion::PointVolumes() const
{
  Eigen::VectorXd volumes = Eigen::VectorXd::Zero(this->Filled.Points.rows());
  for (Eigen::Index t = 0; t < this->Filled.Tetrahedra.rows(); ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      volumes(this->Filled.Tetrahedra(t, k)) += 0.25 * this->Hats[t].Volume;
    }
  }
  return volumes;
}

Eigen::Matrix3d HarmonicDistortion::Jacobian(Eigen::Index t, const Eigen::MatrixXd& map) const
{
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
  for (int k = 0; k < 4; ++k)
  {
    jacobian += map.row(this->Filled.Tetrahedra(t, k)).transpose() * this->Hats[t].Gradients.row(k);
  }
  return jacobian;
}

Eigen::MatrixXd HarmonicDistortion::Spread(const Eigen::MatrixXd& values) const
{
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(this->Filled.Points.rows(), values.cols());
  all(this->Filled.Boundary, Eigen::all) = values;
  return all;
}

BoundaryHessian::BoundaryHessian(const HarmonicDistortion& distortion, double factor,
  const Eigen::VectorXd& diagonal, const Progress& progress)
  : Distortion(distortion)
{
  Eigen::SparseMatrix<double> matrix = factor * distortion.Stiffness();
  matrix.diagonal() += diagonal;
  this->Factor.Factorize(matrix, progress);
}

Eigen::MatrixXd BoundaryHessian::Solve(const Eigen::MatrixXd& gradient) const
{
  // The block of the inverse matrix is the inverse of the Schur complement.
  return this->Factor.Solve(this->Distortion.Spread(gradient))(
    this->Distortion.Solid().Boundary, Eigen::all);
}

} // namespace shape
