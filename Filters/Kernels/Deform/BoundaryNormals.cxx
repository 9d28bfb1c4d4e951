#include "Deform/BoundaryNormals.h"

#include "Base/Errors.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

constexpr double Degree = M_PI / 180.0;

/// A row is a unit vector or zero; a quarter separates the two whatever the rounding.
bool IsNormal(const RowVector3d& normal)
{
  return normal.squaredNorm() > 0.25;
}

double AngleBetween(const RowVector3d& a, const RowVector3d& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Minimises equation 12. Order of calls: Search with one angle for all samples, then with one for
/// each; then take the Pose.
class NormalSearch
{
public:
  NormalSearch(const ShapeDeformation& deformation, const BoundaryHandle& handle,
    const HandlePose& pose, const Eigen::MatrixXd& wanted, const NormalsOfShape& normals,
    const BoundaryNormalsOptions& options)
    : Deformation(deformation)
    , Handle(handle)
    , Start(pose)
    , Wanted(wanted)
    , NormalsOf(normals)
    , Options(options)
    , Tangents(ComputeHandleTangents(handle, pose.Positions))
    , Now(this->At(Eigen::VectorXd::Zero(wanted.rows())))
  {
    for (auto tangent : this->Tangents.rowwise())
    {
      tangent.stableNormalize();
    }
  }

  /// One angle for all, or one for each.
  /// The two stages of section 4.1: a single global angle first, then the vector of angles. The
  /// paper descends the numerical gradient; here the missing angles are the direction.
  void Search(bool single, const Progress& progress)
  {
    double total = this->TotalAngle();
    for (int search = 0; search < this->Options.LineSearches; ++search)
    {
      progress(static_cast<double>(search) / this->Options.LineSearches);
      const Eigen::VectorXd missing = this->MissingAngles();
      ++this->LineSearches;
      const bool isBetter =
        this->SearchAlong(single ? Eigen::VectorXd::Constant(missing.size(), missing.mean())
                                 : this->Smoothed(missing));
      const double left = this->TotalAngle();
      // The paper's criterion of convergence: a line search gains less than 2 degrees in total.
      if (!isBetter || total - left < this->Options.Enough * Degree)
      {
        return;
      }
      total = left;
    }
  }

  double MeanDeviation() const { return ComputeMeanAngle(this->Now.Normals, this->Wanted); }
  const HandlePose& Pose() const { return this->Now.Pose; }
  const Eigen::VectorXd& Angles() const { return this->Now.Angles; }

  int LineSearches = 0;

private:
  struct State
  {
    Eigen::VectorXd Angles;
    HandlePose Pose;
    Eigen::MatrixXd Normals;
    double Energy = 0.0;
  };

  // N of equation 12: rotate the frames, deform the shape near the handle, estimate its normals.
  State At(const Eigen::VectorXd& angles) const
  {
    State state{ angles, this->Start, {}, 0.0 };
    RotateAboutTangents(this->Handle, angles, state.Pose);
    state.Normals = this->NormalsOf(this->Deformation.Deform(state.Pose, this->Options.Reach));
    for (Eigen::Index i = 0; i < this->Wanted.rows(); ++i)
    {
      if (IsNormal(this->Wanted.row(i)) && IsNormal(state.Normals.row(i)))
      {
        // Equation 12.
        state.Energy += std::abs(1.0 - state.Normals.row(i).dot(this->Wanted.row(i)));
      }
    }
    return state;
  }

  Eigen::VectorXd MissingAngles() const { return this->MissingAngles(this->Now); }

  /// The angle by which each frame would have to rotate if the others did not.
  Eigen::VectorXd MissingAngles(const State& state) const
  {
    Eigen::VectorXd missing = Eigen::VectorXd::Zero(this->Wanted.rows());
    for (Eigen::Index i = 0; i < missing.size(); ++i)
    {
      const RowVector3d axis = this->Tangents.row(i);
      const RowVector3d now = state.Normals.row(i), wanted = this->Wanted.row(i);
      if (IsNormal(now) && IsNormal(wanted) && IsNormal(axis))
      {
        const RowVector3d across = axis.cross(now);
        // The signed angle about the tangent; the deviation along the tangent cannot be corrected.
        missing(i) = std::atan2(across.dot(wanted), now.dot(wanted));
      }
    }
    return missing;
  }

  /// Smooths angles along the curves: a sample's normal also depends on the frames of its
  /// neighbours, so that frames rotated independently would overshoot and oscillate.
  Eigen::VectorXd Smoothed(Eigen::VectorXd angles) const
  {
    constexpr int passes = 2;
    for (int pass = 0; pass < passes; ++pass)
    {
      Eigen::VectorXd sums = 2.0 * angles;
      Eigen::VectorXd weights = Eigen::VectorXd::Constant(angles.size(), 2.0);
      for (const auto segment : this->Handle.Segments.rowwise())
      {
        sums(segment(0)) += angles(segment(1));
        sums(segment(1)) += angles(segment(0));
        weights(segment(0)) += 1.0;
        weights(segment(1)) += 1.0;
      }
      angles = sums.cwiseQuotient(weights);
    }
    return angles;
  }

  double TotalAngle() const
  {
    double total = 0.0;
    for (Eigen::Index i = 0; i < this->Wanted.rows(); ++i)
    {
      if (IsNormal(this->Wanted.row(i)) && IsNormal(this->Now.Normals.row(i)))
      {
        total += AngleBetween(this->Now.Normals.row(i), this->Wanted.row(i));
      }
    }
    return total;
  }

  /// A line search: the share of the missing angles that one step corrects determines the length of
  /// the next one. If the energy does not decrease, steps are halved until it does.
  bool SearchAlong(const Eigen::VectorXd& direction)
  {
    const Eigen::VectorXd begin = this->Now.Angles, missing = this->MissingAngles();
    const double energy = this->Now.Energy;
    const auto accept = [&](double share)
    {
      State state = this->At(begin + share * direction);
      const bool isBetter = state.Energy < this->Now.Energy;
      if (isBetter)
      {
        this->Now = std::move(state);
      }
      return isBetter;
    };
    State first = this->At(begin + this->Share * direction);
    const Eigen::VectorXd gained = missing - this->MissingAngles(first);
    // The least-squares estimate of the step that corrects all missing angles, if the response is
    // linear.
    const double along = missing.dot(gained) / gained.squaredNorm();
    if (first.Energy < energy)
    {
      this->Now = std::move(first);
    }
    if (std::isfinite(along) && along > 0.0)
    {
      // One step is no reliable estimate: its length changes by a limited factor only.
      const double share = this->Share * std::clamp(along, 0.1, 4.0);
      if (accept(share))
      {
        this->Share = share;
        return true;
      }
    }
    constexpr int tries = 4;
    double share = this->Share;
    for (int i = 0; i < tries && this->Now.Energy >= energy; ++i)
    {
      accept(share *= 0.5);
    }
    return this->Now.Energy < energy;
  }

  const ShapeDeformation& Deformation;
  const BoundaryHandle& Handle;
  const HandlePose& Start;
  const Eigen::MatrixXd& Wanted;
  const NormalsOfShape& NormalsOf;
  const BoundaryNormalsOptions& Options;
  Eigen::MatrixXd Tangents;
  State Now;
  double Share = 1.0; ///< of the missing angles that the last step corrected
};

} // namespace

BoundaryNormalsResult OptimizeBoundaryNormals(const ShapeDeformation& deformation,
  const BoundaryHandle& handle, const HandlePose& pose, const Eigen::MatrixXd& wanted,
  const NormalsOfShape& normals, const BoundaryNormalsOptions& options, const Progress& progress)
{
  if (wanted.rows() != handle.Positions.rows() || pose.Positions.rows() != handle.Positions.rows())
  {
    throw InvalidInput("there are " + std::to_string(wanted.rows()) + " wanted normals and " +
      std::to_string(handle.Positions.rows()) +
      " samples of the handle; give one normal for each sample");
  }
  NormalSearch search(deformation, handle, pose, wanted, normals, options);
  BoundaryNormalsResult result;
  result.Before = search.MeanDeviation();
  search.Search(true, progress.Part(0.0, 0.5, "optimizing the normals"));
  if (!options.SingleAngle)
  {
    search.Search(false, progress.Part(0.5, 1.0, "optimizing the normals"));
  }
  result.Pose = search.Pose();
  result.Angles = search.Angles();
  result.After = search.MeanDeviation();
  result.LineSearches = search.LineSearches;
  progress(1.0);
  return result;
}

double ComputeMeanAngle(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  double sum = 0.0;
  int count = 0;
  for (Eigen::Index i = 0; i < a.rows(); ++i)
  {
    if (IsNormal(a.row(i)) && IsNormal(b.row(i)))
    {
      sum += AngleBetween(a.row(i), b.row(i));
      ++count;
    }
  }
  return count > 0 ? sum / (count * Degree) : 0.0;
}

} // namespace shape
