#include "Harmonic/Private/RegistrationEnergy.h"

#include "Base/Errors.h"
#include "Distance/SignedDistance.h"
#include "Geometry/HaltonSequence.h"
#include "Geometry/Sampling.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace shape
{
namespace
{

/// Positions in a solid, and the share of each in a mean.
struct Positions
{
  Eigen::MatrixXd Points;
  Eigen::VectorXd Shares;
};

/// Half of the shares are at positions that are evenly distributed over the volume, the others
/// close below the boundary, one for each triangle, by area: there a map folds first.
Positions SampleSolid(const Surface& boundary)
{
  constexpr int wanted = 1000, tries = 100;
  const SignedDistance distance(boundary);
  const Eigen::RowVector3d low = boundary.Points().colwise().minCoeff(),
                           high = boundary.Points().colwise().maxCoeff();
  std::vector<Eigen::RowVector3d> inside;
  for (int round = 0; round < tries && static_cast<int>(inside.size()) < wanted; ++round)
  {
    Eigen::MatrixXd points(wanted, 3);
    for (int i = 0; i < wanted; ++i)
    {
      const int index = round * wanted + i + 1;
      const Eigen::RowVector3d numbers(
        GetHaltonNumber(index, 2), GetHaltonNumber(index, 3), GetHaltonNumber(index, 5));
      points.row(i) = low + numbers.cwiseProduct(high - low);
    }
    const Eigen::VectorXd distances = distance.Evaluate(points).Distances;
    for (int i = 0; i < wanted && static_cast<int>(inside.size()) < wanted; ++i)
    {
      if (distances(i) < 0.0)
      {
        inside.emplace_back(points.row(i));
      }
    }
  }
  // The depth below a triangle is its size; half of that must be free.
  const Eigen::VectorXd lengths = boundary.AreaVectors().rowwise().norm();
  const Eigen::VectorXd depths = (0.5 * lengths).cwiseSqrt();
  const Eigen::MatrixXd below = ComputeCentroids(boundary) -
    depths.cwiseQuotient(lengths.cwiseMax(std::numeric_limits<double>::min())).asDiagonal() *
      boundary.AreaVectors();
  const Eigen::VectorXd free = distance.Evaluate(below).Distances;
  std::vector<int> kept;
  for (int t = 0; t < free.size(); ++t)
  {
    if (free(t) < -0.5 * depths(t))
    {
      kept.push_back(t);
    }
  }
  const auto count = static_cast<Eigen::Index>(inside.size()),
             all = count + static_cast<Eigen::Index>(kept.size());
  if (all == 0)
  {
    throw SolveFailure("the solid is too thin: no position inside it was found; refine the "
                       "boundary with Remesh");
  }
  Positions positions{ Eigen::MatrixXd(all, 3), Eigen::VectorXd(all) };
  for (Eigen::Index i = 0; i < count; ++i)
  {
    positions.Points.row(i) = inside[i];
    positions.Shares(i) = 1.0 / static_cast<double>(count);
  }
  positions.Points.bottomRows(all - count) = below(kept, Eigen::all);
  const Eigen::VectorXd areas = lengths(kept);
  positions.Shares.tail(all - count) = areas / std::max(areas.sum(), 1e-300);
  positions.Shares /= positions.Shares.sum();
  return positions;
}

} // namespace

RegistrationEnergy::RegistrationEnergy(const Surface& boundary, const Surface& target, double scale,
  const LinearVolumeMapOptions& map, const Progress& progress)
  : Boundary(boundary)
  , Target(target)
  , Scale(scale)
  , Size(ComputeLongestBoxEdge(target.Points()))
  , Areas(ComputePointAreas(boundary))
  , Solver(boundary, map, progress.Part(0.3, 1.0))
{
  this->Areas /= this->Areas.sum();
  const int count = static_cast<int>(std::clamp<Eigen::Index>(boundary.Points().rows(), 500, 5000));
  this->Samples = SampleSurface(target, count, SamplingMode::Uniform, 1, progress.Part(0.0, 0.2));
  const Positions positions = SampleSolid(boundary);
  this->Inside = positions.Points;
  this->Shares = positions.Shares;
}

void RegistrationEnergy::AddDistances(
  const Eigen::MatrixXd& images, State& state, const Progress& progress) const
{
  // The closest points do not contribute to the derivative of a squared distance.
  const double unit = 0.5 / (this->Size * this->Size);
  const ClosestPoints there = this->Target.Find(images, progress);
  state.ByImages = (2.0 * unit * this->Areas).asDiagonal() * (images - there.Positions);
  state.Distance = unit * this->Areas.dot(there.Distances.cwiseAbs2());
  const SurfaceLocator image(this->Boundary.WithPoints(images));
  const ClosestPoints back = image.Find(this->Samples, progress);
  const double share = unit / static_cast<double>(this->Samples.rows());
  state.Distance += share * back.Distances.squaredNorm();
  state.ByImages += 2.0 * share *
    PushForward(back, this->Boundary.Triangles(), back.Positions - this->Samples, images.rows());
}

void RegistrationEnergy::AddDistortion(State& state, const Progress& progress) const
{
  const Eigen::MatrixXd rows = EvaluateJacobians(state.Map, this->Inside, progress) / this->Scale;
  state.ByJacobians.resize(rows.rows(), 9);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    const Eigen::Matrix<double, 9, 1> row = rows.row(i);
    const Eigen::Matrix3d jacobian = row.reshaped<Eigen::RowMajor>(3, 3);
    if (!(jacobian.determinant() > 0.0))
    {
      state.Distortion = std::numeric_limits<double>::infinity();
      return;
    }
    const Eigen::Matrix3d inverse = jacobian.inverse();
    state.Distortion += this->Shares(i) * (jacobian.squaredNorm() + inverse.squaredNorm());
    const Eigen::Matrix3d slope = 2.0 * this->Shares(i) / this->Scale *
      (jacobian - inverse.transpose() * inverse * inverse.transpose());
    state.ByJacobians.row(i) = slope.reshaped<Eigen::RowMajor>().transpose();
  }
}

RegistrationEnergy::State RegistrationEnergy::Evaluate(
  const Eigen::MatrixXd& images, const Progress& progress) const
{
  State state;
  state.Map = this->Solver.Fit(images, progress.Part(0.0, 0.6));
  this->AddDistortion(state, progress.Part(0.6, 0.8));
  this->AddDistances(images, state, progress.Part(0.8, 1.0));
  return state;
}

Eigen::MatrixXd RegistrationEnergy::Gradient(
  const State& state, double weight, const Progress& progress) const
{
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(this->Inside.rows(), 3);
  return state.ByImages +
    weight * this->Solver.Gradient(this->Inside, none, state.ByJacobians, progress);
}

RegistrationQuality RegistrationEnergy::Judge(
  const Eigen::MatrixXd& images, const State& state) const
{
  RegistrationQuality quality;
  quality.MeanDistance = std::sqrt(state.Distance);
  quality.MaximumDistance = std::max(this->Target.Find(images).Distances.maxCoeff(),
                              SurfaceLocator(this->Boundary.WithPoints(images))
                                .FindLargestDistance(this->Target.GetSurface().Points())) /
    this->Size;
  quality.Distortion = state.Distortion;
  return quality;
}

} // namespace shape
