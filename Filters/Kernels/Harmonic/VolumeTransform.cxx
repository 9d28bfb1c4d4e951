#include "Harmonic/VolumeTransform.h"

#include "Base/Parallel.h"
#include "Harmonic/Private/InverseSearch.h"

#include <Eigen/LU>

namespace shape
{

using State = InverseMap::State;

namespace
{

template <typename Function>
std::vector<VolumeTransform::Result> ByAllThreads(
  const Eigen::MatrixXd& points, const Function& function)
{
  std::vector<VolumeTransform::Result> results(points.rows());
  ParallelFor(static_cast<int>(points.rows()), 64,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        results[i] = function(points.row(i).transpose());
      }
    });
  return results;
}

} // namespace

VolumeTransform::VolumeTransform(const PiecewiseCharges& charges, bool withInverse)
  : Map(std::make_shared<const PiecewiseHarmonicMap>(charges))
{
  for (const ChargeSet& map : charges.Maps)
  {
    this->Charges.emplace_back(map);
  }
  if (withInverse)
  {
    this->Inverse = std::make_unique<const PiecewiseInverseMap>(this->Map);
  }
}

Eigen::Vector3d VolumeTransform::Evaluate(
  const Eigen::Vector3d& position, Eigen::Matrix3d& jacobian) const
{
  if (this->Map->HasRepair())
  {
    return this->EvaluateRepaired(position, jacobian);
  }
  if (this->Charges.size() == 1)
  {
    return this->Charges.front().Evaluate(position, jacobian);
  }
  // f = (1 - s) f_r + s f_p and its derivative (PiecewiseHarmonicMap.h). The parent's map is needed
  // in the skin only.
  const PiecewiseHarmonicMap::Positions at = this->Map->Locate(position.transpose());
  const int region = at.Regions(0);
  Eigen::Vector3d value = this->Charges[region].Evaluate(position, jacobian);
  if (const double share = at.Shares(0); share > 0.0)
  {
    Eigen::Matrix3d otherJacobian;
    const Eigen::Vector3d difference =
      this->Charges[this->Map->Parent(region)].Evaluate(position, otherJacobian) - value;
    value += share * difference;
    jacobian += share * (otherJacobian - jacobian) + difference * at.Slopes.row(0);
  }
  return value;
}

Eigen::Vector3d VolumeTransform::EvaluateRepaired(
  const Eigen::Vector3d& position, Eigen::Matrix3d& jacobian) const
{
  const PiecewiseHarmonicMap::RepairPositions at = this->Map->LocateInRepair(position.transpose());
  const double share = at.Values(0, 3);
  if (at.Cells(0) < 0 || !(share < 1.0))
  {
    return this->Charges.front().Evaluate(position, jacobian);
  }
  // g = h + phi (f - h) and its derivative (MapRepair).
  Eigen::Vector3d value = at.Values.leftCols<3>().transpose();
  jacobian = GetJacobian(at.Gradients, 0);
  if (share > 0.0)
  {
    Eigen::Matrix3d ofCharges;
    const Eigen::Vector3d difference = this->Charges.front().Evaluate(position, ofCharges) - value;
    value += share * difference;
    jacobian += share * (ofCharges - jacobian) + difference * at.Gradients.rightCols<3>();
  }
  return value;
}

bool VolumeTransform::IsOutside(const Eigen::Vector3d& position) const
{
  return FindPointsOutsideDomain(this->Map->Domain(), position.transpose(), this->Map->Farthest())(
           0) != 0;
}

VolumeTransform::Result VolumeTransform::Forward(const Eigen::Vector3d& point) const
{
  Result result{ point };
  if (!point.allFinite() || this->IsOutside(point))
  {
    result.State = State::Outside;
    return result;
  }
  result.Position = this->Evaluate(point, result.Jacobian);
  return result;
}

VolumeTransform::Result VolumeTransform::Backward(const Eigen::Vector3d& point) const
{
  Result result{ point, State::Outside };
  if (!point.allFinite())
  {
    return result;
  }
  // Newton's method as in InverseSearch, but it stops as soon as a full step does not come closer.
  // The complete search follows. It starts once for each region whose image may contain the point,
  // the outermost first.
  const double goal = this->Inverse->GoalOfMisses();
  bool searched = false;
  for (int region = 0; region < this->Map->RegionCount(); ++region)
  {
    const auto start = this->Inverse->OfRegion(region).Start(point.transpose());
    if (!start)
    {
      continue;
    }
    searched = true;
    Eigen::Vector3d position = start->transpose();
    Eigen::Matrix3d jacobian;
    Eigen::Vector3d rest = point - this->Evaluate(position, jacobian);
    for (double before = rest.norm(); before > goal;)
    {
      const Eigen::Vector3d next = position + jacobian.partialPivLu().solve(rest);
      Eigen::Matrix3d nextJacobian;
      const Eigen::Vector3d nextRest = point - this->Evaluate(next, nextJacobian);
      const double miss = nextRest.norm();
      // Near a regular preimage Newton's method gains much more than a quarter in each step.
      if (!(miss < 0.75 * before))
      {
        break;
      }
      position = next;
      rest = nextRest;
      jacobian = nextJacobian;
      before = miss;
    }
    if (rest.norm() <= goal && !this->IsOutside(position))
    {
      return { position, State::Found, jacobian };
    }
  }
  // The point is outside the image of every region. The image of a repair may reach farther.
  if (!searched && !this->Map->HasRepair())
  {
    return result;
  }
  const InverseMap::Result found = this->Inverse->Find(Eigen::MatrixXd(point.transpose()));
  result.State = static_cast<State>(found.States(0));
  if (result.State == State::Found)
  {
    result.Position = found.Points.row(0).transpose();
    this->Evaluate(result.Position, result.Jacobian);
  }
  return result;
}

std::vector<VolumeTransform::Result> VolumeTransform::Forward(const Eigen::MatrixXd& points) const
{
  return ByAllThreads(
    points, [this](const Eigen::Vector3d& point) { return this->Forward(point); });
}

std::vector<VolumeTransform::Result> VolumeTransform::Backward(const Eigen::MatrixXd& points) const
{
  return ByAllThreads(
    points, [this](const Eigen::Vector3d& point) { return this->Backward(point); });
}

} // namespace shape
