#include "Harmonic/Private/RegistrationEnergy.h"

#include "Geometry/Sampling.h"

#include <algorithm>
#include <utility>

namespace shape
{

RegistrationEnergy::RegistrationEnergy(
  FilledSolid solid, Eigen::MatrixXi triangles, const Surface& target, const Progress& progress)
  : Harmonic(std::move(solid), progress.Part(0.0, 0.5))
  , Boundary(this->Harmonic.Solid().Points(this->Harmonic.Solid().Boundary, Eigen::all),
      std::move(triangles))
  , Target(target)
  , Longest(ComputeLongestBoxEdge(target.Points()))
  , Shares(ComputePointAreas(this->Boundary))
{
  this->Shares /= this->Shares.sum();
  const int count = static_cast<int>(std::clamp<Eigen::Index>(this->Shares.size(), 1000, 10000));
  this->Samples = SampleSurface(target, count, SamplingMode::Uniform, 1, progress.Part(0.5, 1.0));
}

RegistrationEnergy::Terms RegistrationEnergy::Evaluate(
  const Eigen::MatrixXd& images, const Progress& progress) const
{
  Terms terms;
  terms.Distortion = this->Harmonic.Evaluate(images, SymmetricDirichlet, terms.ByDistortion);
  const double unit = 0.5 / (this->Longest * this->Longest);
  const ClosestPoints there = this->Target.Find(images, progress.Part(0.3, 0.6));
  terms.Distance = unit * this->Shares.dot(there.Distances.cwiseAbs2());
  terms.ByDistance = 2.0 * unit * this->Shares.asDiagonal() * (images - there.Positions);
  const ClosestPoints back =
    SurfaceLocator(this->Image(images)).Find(this->Samples, progress.Part(0.6, 1.0));
  const double share = unit / static_cast<double>(this->Samples.rows());
  terms.Distance += share * back.Distances.squaredNorm();
  terms.ByDistance += 2.0 * share *
    PushForward(back, this->Boundary.Triangles(), back.Positions - this->Samples, images.rows());
  return terms;
}

BoundaryHessian RegistrationEnergy::ApproximateHessian(
  double weight, const Progress& progress) const
{
  return BoundaryHessian(this->Harmonic, 8.0 * weight / this->Harmonic.Volume(),
    this->Harmonic.Spread(2.0 / (this->Longest * this->Longest) * this->Shares), progress);
}

} // namespace shape
