#include "Parameterize/Private/HyperbolicEnergy.h"

#include <cmath>
#include <utility>

namespace shape
{
namespace
{

using Frame = Eigen::Matrix<double, 3, 2>;

/// Returns an orthonormal frame at a point of the hyperboloid: the axes at (0, 0, 1), moved along
/// the geodesic.
Frame AxesAt(const Eigen::Vector3d& point)
{
  const Eigen::Vector2d place = point.head<2>();
  Frame frame;
  frame.topRows<2>() = Eigen::Matrix2d::Identity() + place * place.transpose() / (1.0 + point(2));
  frame.row(2) = place.transpose();
  return frame;
}

/// Returns the coordinates of a vector in a frame.
Eigen::Vector2d InFrame(const Frame& frame, const Eigen::Vector3d& vector)
{
  return frame.transpose() * Eigen::Vector3d(vector(0), vector(1), -vector(2));
}

Eigen::Vector2d Turned(const Eigen::Vector2d& direction)
{
  return { -direction(1), direction(0) };
}

} // namespace

HyperbolicEnergy::HyperbolicEnergy(std::vector<HyperbolicPosition> positions,
  std::vector<HyperbolicMotion> motions, std::vector<HyperbolicEdge> edges, int unknowns)
  : All(std::move(positions))
  , Motions(std::move(motions))
  , Edges(std::move(edges))
  , Unknowns(unknowns)
{
  for (const HyperbolicMotion& motion : this->Motions)
  {
    this->Rounded.emplace_back(motion.cast<double>());
  }
}

Eigen::Vector3d HyperbolicEnergy::PointOf(int position, const Eigen::MatrixXd& unknowns) const
{
  const HyperbolicPosition& own = this->All[position];
  if (own.Unknown < 0)
  {
    return own.Given;
  }
  const Eigen::Vector3d point = unknowns.row(own.Unknown);
  return own.Motion < 0 ? point : this->Rounded[own.Motion] * point;
}

HyperbolicEnergy::Framed HyperbolicEnergy::FrameOf(
  int position, const Eigen::MatrixXd& unknowns) const
{
  const HyperbolicPosition& own = this->All[position];
  if (own.Unknown < 0)
  {
    return { own.Given, AxesAt(own.Given) };
  }
  const Eigen::Vector3d point = unknowns.row(own.Unknown);
  const Frame frame = AxesAt(point);
  return own.Motion < 0
    ? Framed{ point, frame }
    : Framed{ this->Rounded[own.Motion] * point, this->Rounded[own.Motion] * frame };
}

double HyperbolicEnergy::Value(const Eigen::MatrixXd& unknowns) const
{
  double energy = 0.0;
  for (const HyperbolicEdge& edge : this->Edges)
  {
    const double distance = ComputeHyperbolicDistance(
      this->PointOf(edge.From, unknowns), this->PointOf(edge.To, unknowns));
    energy += 0.5 * edge.Weight * distance * distance;
  }
  return energy;
}

// For two points at the distance d, let u and v be the unit vectors along the geodesic from one to
// the other, at both ends. The first derivatives of d^2 / 2 are -d u and d v. Of the second ones,
// those along the geodesic are as in the plane. Those across it are d coth d at each end, and
// -d / sinh d between the ends.
HyperbolicEnergy::Derivatives HyperbolicEnergy::Differentiate(const Eigen::MatrixXd& unknowns) const
{
  Derivatives result{ Eigen::VectorXd::Zero(2 * this->Unknowns),
    Eigen::SparseMatrix<double>(2 * this->Unknowns, 2 * this->Unknowns) };
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(16 * this->Edges.size());
  const auto add = [&](int row, int column, const Eigen::Matrix2d& block)
  {
    for (int i = 0; i < 2; ++i)
    {
      for (int j = 0; j < 2; ++j)
      {
        entries.emplace_back(2 * row + i, 2 * column + j, block(i, j));
      }
    }
  };
  for (const HyperbolicEdge& edge : this->Edges)
  {
    const int from = this->All[edge.From].Unknown, to = this->All[edge.To].Unknown;
    const Framed p = this->FrameOf(edge.From, unknowns), q = this->FrameOf(edge.To, unknowns);
    const double distance = ComputeHyperbolicDistance(p.Point, q.Point);
    const double sine = std::sinh(distance);
    // Points that coincide have no direction: any one does, if it is the same at both ends.
    const Eigen::Vector3d chord = q.Point - p.Point;
    const Eigen::Vector2d u =
      sine > 0.0 ? Eigen::Vector2d(InFrame(p.Frame, chord) / sine) : Eigen::Vector2d::UnitX();
    const Eigen::Vector2d v = sine > 0.0 ? Eigen::Vector2d(InFrame(q.Frame, chord) / sine)
                                         : InFrame(q.Frame, p.Frame.col(0));
    const Eigen::Vector2d acrossU = Turned(u), acrossV = Turned(v);
    const double between = sine > 0.0 ? distance / sine : 1.0, own = between * std::cosh(distance);
    const double w = edge.Weight;
    if (from >= 0)
    {
      result.Gradient.segment<2>(2 * from) -= w * distance * u;
      add(from, from, w * (u * u.transpose() + own * acrossU * acrossU.transpose()));
    }
    if (to >= 0)
    {
      result.Gradient.segment<2>(2 * to) += w * distance * v;
      add(to, to, w * (v * v.transpose() + own * acrossV * acrossV.transpose()));
    }
    if (from >= 0 && to >= 0)
    {
      const Eigen::Matrix2d mixed =
        -w * (u * v.transpose() + between * acrossU * acrossV.transpose());
      add(from, to, mixed);
      add(to, from, mixed.transpose());
    }
  }
  result.Hessian.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Eigen::MatrixXd HyperbolicEnergy::Move(
  const Eigen::MatrixXd& unknowns, const Eigen::VectorXd& displacements)
{
  Eigen::MatrixXd moved(unknowns.rows(), 3);
  for (Eigen::Index i = 0; i < unknowns.rows(); ++i)
  {
    const Eigen::Vector3d point = unknowns.row(i);
    const Eigen::Vector2d step = displacements.segment<2>(2 * i);
    const double length = step.norm();
    const double factor = length > 0.0 ? std::sinh(length) / length : 1.0;
    const Eigen::Vector2d place =
      (std::cosh(length) * point + factor * AxesAt(point) * step).head<2>();
    moved.row(i) << place(0), place(1), std::sqrt(1.0 + place.squaredNorm());
  }
  return moved;
}

Eigen::MatrixXd HyperbolicEnergy::Positions(const Eigen::MatrixXd& unknowns) const
{
  Eigen::MatrixXd points(static_cast<Eigen::Index>(this->All.size()), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const HyperbolicPosition& own = this->All[i];
    points.row(i) = own.Motion < 0
      ? this->PointOf(static_cast<int>(i), unknowns)
      : MoveHyperbolic(this->Motions[own.Motion], unknowns.row(own.Unknown).transpose());
  }
  return points;
}

} // namespace shape
