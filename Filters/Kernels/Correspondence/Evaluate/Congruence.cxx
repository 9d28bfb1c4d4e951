#include "Correspondence/Evaluate/Congruence.h"

#include "Base/Errors.h"
#include "Geometry/FitRotation.h"
#include "Geometry/Sampling.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// A surface of area 1 around the origin, in the coordinates of its principal axes.
struct AxisAligned
{
  shape::Surface Surface;
  Eigen::RowVector3d Centroid;
  Eigen::Matrix3d Axes; ///< a column each, by ascending moments; a rotation
  Eigen::Vector3d Moments;
  double Length;
  Eigen::MatrixXd Samples; ///< 400 points, evenly spread
};

/// The second moments of the surface are exact, so that they do not depend on its triangles.
AxisAligned Align(const Surface& surface, const std::string& name)
{
  const Eigen::MatrixXi& triangles = surface.Triangles();
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  double area = 0.0;
  Eigen::VectorXd areas(triangles.rows());
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(surface, t);
    areas(t) =
      0.5 * (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).norm();
    sum += areas(t) * corners.colwise().mean();
    area += areas(t);
  }
  if (!(area > 0.0))
  {
    throw InvalidInput(name + " has no area; give a surface with triangles");
  }
  const Eigen::RowVector3d centroid = sum / area;
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(surface, t).rowwise() - centroid;
    const Eigen::RowVector3d total = corners.colwise().sum();
    // The integral of x x' over a triangle is area / 12 (sum of corners' squares + square of sum).
    second += areas(t) / 12.0 * (corners.transpose() * corners + total.transpose() * total);
  }
  const double length = std::sqrt(area);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(second / (area * area));
  Eigen::Matrix3d axes = solved.eigenvectors();
  axes.col(2) *= axes.determinant() < 0.0 ? -1.0 : 1.0;
  const Eigen::MatrixXd points = (surface.Points().rowwise() - centroid) * axes / length;
  return { { points, triangles }, centroid, axes, solved.eigenvalues(), length,
    SampleSurface({ points, triangles }, 400, SamplingMode::Uniform) };
}

/// The turns that leave the moments nearly as they are: by half a turn about each axis, and by
/// steps about an axis whose two others have nearly equal moments.
std::vector<Eigen::Matrix3d> Turns(const Eigen::Vector3d& moments)
{
  constexpr double like = 0.9; // the ratio of nearly equal moments
  constexpr int steps = 24;
  const double whole = 2.0 * std::acos(-1.0);
  const bool isLow = moments(0) > like * moments(1), isHigh = moments(1) > like * moments(2);
  const auto about = [&](int axis, int count)
  {
    std::vector<Eigen::Matrix3d> turns;
    for (int k = 0; k < count; ++k)
    {
      turns.push_back(
        Eigen::AngleAxisd(whole * k / count, Eigen::Vector3d::Unit(axis)).toRotationMatrix());
    }
    return turns;
  };
  const auto products =
    [](const std::vector<Eigen::Matrix3d>& first, const std::vector<Eigen::Matrix3d>& second)
  {
    std::vector<Eigen::Matrix3d> all;
    for (const Eigen::Matrix3d& one : first)
    {
      for (const Eigen::Matrix3d& other : second)
      {
        all.push_back(one * other);
      }
    }
    return all;
  };
  std::vector<Eigen::Matrix3d> turns =
    products(about(2, isLow ? steps : 2), about(0, isHigh ? steps : 2));
  // Three like moments: any direction can be any other one.
  return isLow && isHigh ? products(turns, about(2, steps)) : turns;
}

double RootMeanSquare(const Eigen::VectorXd& distances)
{
  return std::sqrt(distances.squaredNorm() / static_cast<double>(distances.size()));
}

/// Both aligned surfaces, between which linear maps are fitted and measured.
class AlignedPair
{
public:
  AlignedPair(const AxisAligned& a, const AxisAligned& b)
    : A(a)
    , B(b)
    , OnA(a.Surface)
    , OnB(b.Surface)
  {
  }

  /// The distance of the surfaces if A is moved: x goes to linear x + shift.
  struct Fit
  {
    Eigen::Matrix3d Linear;
    Eigen::Vector3d Shift = Eigen::Vector3d::Zero();
    double Error = std::numeric_limits<double>::infinity();
  };

  /// Only from A to B, and by every 8th sample.
  double Estimate(const Eigen::Matrix3d& linear) const
  {
    const Eigen::MatrixXd few =
      this->A.Samples(Eigen::seq(0, this->A.Samples.rows() - 1, 8), Eigen::all);
    return RootMeanSquare(this->OnB.Find(few * linear.transpose()).Distances);
  }

  /// Fits the closest points in turn. The closest points of B's samples are taken back to A.
  Fit Iterate(const Eigen::Matrix3d& start, bool reflects, const Progress& progress) const
  {
    constexpr int rounds = 40;
    constexpr double enough = 1e-6, change = 1e-2;
    Fit fit{ start };
    for (int round = 0; round < rounds; ++round)
    {
      progress(static_cast<double>(round) / rounds);
      const Eigen::MatrixXd moved =
        (this->A.Samples * fit.Linear.transpose()).rowwise() + fit.Shift.transpose();
      const Eigen::MatrixXd back = (this->B.Samples.rowwise() - fit.Shift.transpose()) * fit.Linear;
      const ClosestPoints there = this->OnB.Find(moved), here = this->OnA.Find(back);
      const double error = std::sqrt(0.5 *
        (std::pow(RootMeanSquare(there.Distances), 2) +
          std::pow(RootMeanSquare(here.Distances), 2)));
      const bool isDone = error < enough || error > (1.0 - change) * fit.Error;
      fit.Error = std::min(fit.Error, error);
      if (isDone)
      {
        break;
      }
      Eigen::MatrixXd from(moved.rows() + back.rows(), 3), to(from.rows(), 3);
      from << this->A.Samples, here.Positions;
      to << there.Positions, this->B.Samples;
      const Eigen::RowVector3d middle = from.colwise().mean(), image = to.colwise().mean();
      const Eigen::Matrix3d cross = (to.rowwise() - image).transpose() * (from.rowwise() - middle);
      // A reflection is a rotation after the inversion.
      fit.Linear = reflects ? Eigen::Matrix3d(-FitRotation(-cross)) : FitRotation(cross);
      fit.Shift = image.transpose() - fit.Linear * middle.transpose();
    }
    return fit;
  }

private:
  const AxisAligned &A, &B;
  SurfaceLocator OnA, OnB;
};

/// The best fit from the best starts.
AlignedPair::Fit FindBest(const AlignedPair& pair, const std::vector<Eigen::Matrix3d>& turns,
  bool reflects, const Progress& progress)
{
  std::vector<std::pair<double, std::size_t>> starts;
  for (std::size_t k = 0; k < turns.size(); ++k)
  {
    starts.emplace_back(pair.Estimate(reflects ? Eigen::Matrix3d(-turns[k]) : turns[k]), k);
  }
  std::sort(starts.begin(), starts.end());
  constexpr std::size_t most = 4;
  const std::size_t count = std::min(most, starts.size());
  AlignedPair::Fit best{ Eigen::Matrix3d::Identity() };
  for (std::size_t k = 0; k < count; ++k)
  {
    const Eigen::Matrix3d& turn = turns[starts[k].second];
    const AlignedPair::Fit fit = pair.Iterate(reflects ? Eigen::Matrix3d(-turn) : turn, reflects,
      progress.Part(static_cast<double>(k) / count, static_cast<double>(k + 1) / count));
    best = fit.Error < best.Error ? fit : best;
  }
  return best;
}

/// The motion of the given surfaces.
Eigen::Matrix4d Given(const AlignedPair::Fit& fit, const AxisAligned& a, const AxisAligned& b)
{
  // Aligned x = Axes' (given x - centroid) / length.
  const Eigen::Matrix3d linear = b.Length / a.Length * (b.Axes * fit.Linear * a.Axes.transpose());
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion.topLeftCorner<3, 3>() = linear;
  motion.topRightCorner<3, 1>() =
    b.Centroid.transpose() + b.Length * (b.Axes * fit.Shift) - linear * a.Centroid.transpose();
  return motion;
}

} // namespace

Congruence FindCongruence(const Surface& a, const Surface& b, const Progress& progress)
{
  const AxisAligned one = Align(a, "SurfaceA"), two = Align(b, "SurfaceB");
  const std::vector<Eigen::Matrix3d> turns = Turns(one.Moments);
  const AlignedPair pair(one, two);
  const AlignedPair::Fit motion = FindBest(pair, turns, false, progress.Part(0.0, 0.5)),
                         reflection = FindBest(pair, turns, true, progress.Part(0.5, 1.0));
  constexpr double near = 0.005;
  using Relation = Congruence::RelationType;
  const bool isSame = motion.Error < near, isMirrored = reflection.Error < near;
  progress(1.0);
  return { isSame && isMirrored ? Relation::Both
      : isSame                  ? Relation::Same
      : isMirrored              ? Relation::MirrorImage
                                : Relation::None,
    motion.Error, reflection.Error, Given(motion, one, two), Given(reflection, one, two) };
}

} // namespace shape
