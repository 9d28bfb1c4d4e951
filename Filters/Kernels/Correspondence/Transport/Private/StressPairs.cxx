#include "Correspondence/Transport/Private/StressPairs.h"

#include "Correspondence/Transport/Private/ExactDistances.h"
#include "Geodesics/FarthestPoints.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace shape
{
namespace
{

/// The lowest value of b' G b, where b >= 0 sums to 1; b is set.
double MinimizeInTriangle(const Eigen::Matrix3d& gram, Eigen::RowVector3d& barycentric)
{
  // Inside, G b is a multiple of (1, 1, 1): b is proportional to the row sums of G's adjugate.
  Eigen::Matrix3d adjugate;
  adjugate.col(0) = gram.col(1).cross(gram.col(2));
  adjugate.col(1) = gram.col(2).cross(gram.col(0));
  adjugate.col(2) = gram.col(0).cross(gram.col(1));
  const Eigen::RowVector3d inside = adjugate.rowwise().sum().transpose();
  if (inside.minCoeff() > 0.0)
  {
    barycentric = inside / inside.sum();
    return barycentric * gram * barycentric.transpose();
  }
  double lowest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 3; ++i)
  {
    const int j = (i + 1) % 3;
    const double bend = gram(i, i) + gram(j, j) - 2.0 * gram(i, j);
    const double share = bend > 0.0 ? std::clamp((gram(j, j) - gram(i, j)) / bend, 0.0, 1.0) : 0.0;
    Eigen::RowVector3d edge = Eigen::RowVector3d::Zero();
    edge(i) = share;
    edge(j) = 1.0 - share;
    const double value = edge * gram * edge.transpose();
    if (value < lowest)
    {
      lowest = value;
      barycentric = edge;
    }
  }
  return lowest;
}

} // namespace

MetricSurface::MetricSurface(const shape::Surface& surface, const Progress& progress)
  : Shape(surface)
  , Samples(SampleFarthestPoints(surface, static_cast<int>(surface.Points().rows()),
      progress.Part(0.0, 0.02), FindRemotestPoint(surface)))
  , TrianglesAt(surface.Points().rows())
{
  const Eigen::Index points = surface.Points().rows();
  const Eigen::MatrixXd there = ComputeExactDistances(surface,
    MakeSurfacePointsAtVertices(
      Eigen::VectorXi::LinSpaced(points, 0, static_cast<int>(points) - 1), surface),
    progress.Part(0.02, 1.0));
  this->Distances = 0.5 / std::sqrt(ComputeArea(surface)) * (there + there.transpose());
  for (int t = 0; t < static_cast<int>(surface.Triangles().rows()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->TrianglesAt[surface.Triangles()(t, k)].push_back(t);
    }
  }
}

StressPairs::StressPairs(const MetricSurface& a, const MetricSurface& b)
  : Sides{ &a, &b }
  , Fields{ Rows(a.Distances.rows(), 0), Rows(b.Distances.rows(), 0) }
{
}

SurfacePoint StressPairs::AtPoint(int side, int point) const
{
  const int triangle = this->Sides[side]->TrianglesAt[point].front();
  Eigen::RowVector3d barycentric = Eigen::RowVector3d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    barycentric(k) = this->Sides[side]->Shape.Triangles()(triangle, k) == point ? 1.0 : 0.0;
  }
  return { triangle, barycentric };
}

Eigen::RowVectorXd StressPairs::DistancesFrom(int side, const SurfacePoint& position) const
{
  const Eigen::RowVector3i corners = this->Sides[side]->Shape.Triangles().row(position.Triangle);
  Eigen::RowVectorXd distances = position.Barycentric(0) * this->DistancesOf(side, corners(0));
  for (int k = 1; k < 3; ++k)
  {
    distances += position.Barycentric(k) * this->DistancesOf(side, corners(k));
  }
  return distances;
}

void StressPairs::SetPosition(int side, int pair, const SurfacePoint& position)
{
  const Eigen::MatrixXd& all = this->Sides[side]->Distances;
  const Eigen::RowVector3i corners = this->Sides[side]->Shape.Triangles().row(position.Triangle);
  this->Positions[side][pair] = position;
  this->Fields[side].col(pair) = position.Barycentric(0) * all.col(corners(0)) +
    position.Barycentric(1) * all.col(corners(1)) + position.Barycentric(2) * all.col(corners(2));
}

void StressPairs::Append(const SurfacePoint& onA, const SurfacePoint& onB, int moving)
{
  const int pair = this->Pairs++;
  for (Rows& fields : this->Fields)
  {
    if (fields.cols() < this->Pairs)
    {
      fields.conservativeResize(Eigen::NoChange, 2 * this->Pairs);
    }
  }
  this->Positions[0].emplace_back();
  this->Positions[1].emplace_back();
  this->Moving.push_back(moving);
  this->SetPosition(0, pair, onA);
  this->SetPosition(1, pair, onB);
}

void StressPairs::Add(int pointOfA, int pointOfB, int moving)
{
  this->Append(this->AtPoint(0, pointOfA), this->AtPoint(1, pointOfB), moving);
}

void StressPairs::AddSample(int side, int point, ImageType type)
{
  const SurfacePoint own = this->AtPoint(side, point);
  SurfacePoint image;
  if (type == ImageType::Lowest)
  {
    image = this->FindImage(side, point);
  }
  else
  {
    const Eigen::RowVectorXd targets = this->DistancesOf(side, point);
    const int other = 1 - side,
              rival = this->FindRival(
                other, this->StressAtPoints(other, targets, this->NearWeights(targets)));
    image = rival < 0 ? this->FindImage(side, point) : this->AtPoint(other, rival);
  }
  if (side == 0)
  {
    this->Append(own, image, 1);
  }
  else
  {
    this->Append(image, own, 0);
  }
}

Eigen::RowVectorXd StressPairs::NearWeights(const Eigen::RowVectorXd& targets) const
{
  // About the distance between neighbouring pairs, of the root of the area.
  const double near = 1.0 / std::sqrt(static_cast<double>(this->Pairs));
  return (targets.array().square() + near * near).inverse().matrix();
}

Eigen::VectorXd StressPairs::StressAtPoints(
  int side, const Eigen::RowVectorXd& targets, const Eigen::RowVectorXd& weights) const
{
  Eigen::VectorXd stress(this->Fields[side].rows());
  for (int v = 0; v < static_cast<int>(stress.size()); ++v)
  {
    stress(v) = ((this->DistancesOf(side, v) - targets).array().square() * weights.array()).sum();
  }
  return stress;
}

/// Returns -1 if there is none.
int StressPairs::FindRival(int side, const Eigen::VectorXd& stress) const
{
  constexpr double apart = 0.1; // of the root of the area; a nearer point is the same image
  const MetricSurface& own = *this->Sides[side];
  const Eigen::MatrixXi& triangles = own.Shape.Triangles();
  Eigen::Index lowest = 0;
  stress.minCoeff(&lowest);
  int rival = -1;
  for (int v = 0; v < static_cast<int>(stress.size()); ++v)
  {
    const auto isLowestIn = [&](int triangle)
    { return stress(triangles.row(triangle)).minCoeff() >= stress(v); };
    if (own.Distances(v, lowest) > apart && (rival < 0 || stress(v) < stress(rival)) &&
      std::all_of(own.TrianglesAt[v].begin(), own.TrianglesAt[v].end(), isLowestIn))
    {
      rival = v;
    }
  }
  return rival;
}

double StressPairs::RivalStress(int side, int point) const
{
  const Eigen::RowVectorXd targets = this->DistancesOf(side, point);
  const Eigen::VectorXd stress =
    this->StressAtPoints(1 - side, targets, this->NearWeights(targets));
  const int rival = this->FindRival(1 - side, stress);
  return rival < 0 ? std::numeric_limits<double>::infinity() : stress(rival);
}

/// Bronstein et al., section "Numerical solution": the minimum in a triangle, then in those around.
SurfacePoint StressPairs::Descend(int side, SurfacePoint position,
  const Eigen::RowVectorXd& targets, const Eigen::RowVectorXd& weights) const
{
  const MetricSurface& own = *this->Sides[side];
  const Eigen::RowVectorXd roots = weights.cwiseSqrt();
  double lowest =
    ((this->DistancesFrom(side, position) - targets).cwiseProduct(roots)).squaredNorm();
  Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> residuals(3, targets.size());
  constexpr int steps = 50; // to triangles around; a walk ends sooner
  for (int step = 0; step < steps; ++step)
  {
    std::vector<int> around;
    for (int k = 0; k < 3; ++k)
    {
      const auto& at = own.TrianglesAt[own.Shape.Triangles()(position.Triangle, k)];
      around.insert(around.end(), at.begin(), at.end());
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    bool isLower = false;
    for (const int triangle : around)
    {
      for (int k = 0; k < 3; ++k)
      {
        residuals.row(k) = (this->DistancesOf(side, own.Shape.Triangles()(triangle, k)) - targets)
                             .cwiseProduct(roots);
      }
      Eigen::Matrix3d gram;
      for (int i = 0; i < 3; ++i)
      {
        for (int j = i; j < 3; ++j)
        {
          gram(i, j) = gram(j, i) = residuals.row(i).dot(residuals.row(j));
        }
      }
      Eigen::RowVector3d barycentric;
      const double value = MinimizeInTriangle(gram, barycentric);
      constexpr double less = 1.0 - 1e-9; // beyond rounding
      if (value < less * lowest)
      {
        lowest = value;
        position = { triangle, barycentric };
        isLower = true;
      }
    }
    if (!isLower)
    {
      break;
    }
  }
  return position;
}

SurfacePoint StressPairs::FindImage(int side, int point) const
{
  const int other = 1 - side;
  const Eigen::RowVectorXd targets = this->DistancesOf(side, point),
                           weights = this->NearWeights(targets);
  int lowest = 0;
  this->StressAtPoints(other, targets, weights).minCoeff(&lowest);
  return this->Descend(other, this->AtPoint(other, lowest), targets, weights);
}

void StressPairs::Minimize(int sweeps, const Progress& progress)
{
  double before = this->Stress();
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    for (int pair = 0; pair < this->Pairs; ++pair)
    {
      const int side = this->Moving[pair];
      if (side < 0)
      {
        continue;
      }
      const Eigen::RowVectorXd targets =
        this->DistancesFrom(1 - side, this->Positions[1 - side][pair]);
      Eigen::RowVectorXd weights = Eigen::RowVectorXd::Ones(this->Pairs);
      weights(pair) = 0.0;
      this->SetPosition(
        side, pair, this->Descend(side, this->Positions[side][pair], targets, weights));
    }
    progress(static_cast<double>(sweep + 1) / sweeps);
    const double stress = this->Stress();
    constexpr double little = 1e-3; // of the stress
    if (stress > (1.0 - little) * before)
    {
      break;
    }
    before = stress;
  }
  progress(1.0);
}

double StressPairs::Stress() const
{
  double sum = 0.0;
  for (int pair = 0; pair < this->Pairs; ++pair)
  {
    Eigen::RowVectorXd changes = this->DistancesFrom(0, this->Positions[0][pair]) -
      this->DistancesFrom(1, this->Positions[1][pair]);
    changes(pair) = 0.0;
    sum += changes.squaredNorm();
  }
  return std::sqrt(sum / (static_cast<double>(this->Pairs) * std::max(this->Pairs - 1, 1)));
}

bool StressPairs::AreReversed() const
{
  const Mesh &from = this->Sides[0]->Shape, &to = this->Sides[1]->Shape;
  const Eigen::MatrixXd &normalsA = this->Sides[0]->Shape.AreaVectors(),
                        &normalsB = this->Sides[1]->Shape.AreaVectors();
  constexpr Eigen::Index most = 100; // triangles of A, whose images show the sense
  const Eigen::Index step = std::max<Eigen::Index>(1, from.Triangles.rows() / most);
  double sense = 0.0;
  for (Eigen::Index t = 0; t < from.Triangles.rows(); t += step)
  {
    Eigen::Matrix3d corners;
    Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 3; ++k)
    {
      const SurfacePoint image = this->FindImage(0, from.Triangles(t, k));
      corners.row(k) = GetPosition(to, image);
      normal += normalsB.row(image.Triangle).normalized();
    }
    const Eigen::RowVector3d area =
      (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0));
    // Images that are far apart count no more than their triangle does.
    const double length = area.norm();
    sense +=
      length > 0.0 ? std::min(length, normalsA.row(t).norm()) * area.dot(normal) / length : 0.0;
  }
  return sense < 0.0;
}

} // namespace shape
