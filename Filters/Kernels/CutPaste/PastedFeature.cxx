#include "CutPaste/PastedFeature.h"

#include <map>
#include <vector>

namespace shape
{
namespace
{

/// Assembles the result point by point and triangle by triangle.
class Assembly
{
public:
  Assembly(const Surface& target, const CutTriangles& feature, const FeatureFootprint& base,
    const LoopOnTarget& landing)
    : Target(target)
    , Feature(feature)
    , Base(base)
    , Position(landing)
  {
  }

  /// deformed: the feature's deformed points.
  /// Points: kept ones of the target, the feature's, midpoints of the band. Triangles: kept ones of
  /// the target, the band, the feature's.
  PastedFeature Make(const Eigen::MatrixXd& deformed)
  {
    PastedFeature result;
    std::vector<bool> isGone(this->Target.Triangles().rows(), false);
    for (const int triangle : this->Position.Cover.Triangles)
    {
      isGone[triangle] = true;
    }
    std::vector<int> targetPoints;
    const std::vector<int> number = this->Number(targetPoints);
    const auto kept = static_cast<int>(targetPoints.size());
    const auto count = this->Target.Triangles().rows() -
      static_cast<Eigen::Index>(this->Position.Cover.Triangles.size());
    const Eigen::MatrixXi& band = this->Position.Join.Triangles;
    result.BandTriangles = static_cast<int>(band.rows());
    const Eigen::Index given =
      deformed.rows() - static_cast<Eigen::Index>(this->Feature.Midpoints.size());
    const auto midpoints = static_cast<Eigen::Index>(this->Position.Join.Midpoints.size());
    result.Surface.Points.resize(kept + deformed.rows() + midpoints, 3);
    ProvenanceWriter ofTarget(this->Target.Points().rows());
    ProvenanceWriter ofFeature(given);
    result.Surface.Points.topRows(kept) = this->Target.Points()(targetPoints, Eigen::all);
    for (const int point : targetPoints)
    {
      ofTarget.AddCopy(point);
    }
    ofFeature.AddNone(kept);
    ofFeature.AddCopies(given);
    ofTarget.AddNone(given);
    result.Surface.Points.middleRows(kept, deformed.rows()) = deformed;
    Eigen::MatrixXi& triangles = result.Surface.Triangles;
    triangles.resize(count + band.rows() + this->Feature.Triangles.rows(), 3);
    Eigen::VectorXi targetCells = Eigen::VectorXi::Constant(triangles.rows(), -1);
    Eigen::VectorXi featureCells = targetCells;
    int next = 0;
    for (int t = 0; t < static_cast<int>(isGone.size()); ++t)
    {
      if (!isGone[t])
      {
        for (int k = 0; k < 3; ++k)
        {
          triangles(next, k) = number[this->Target.Triangles()(t, k)];
        }
        targetCells(next++) = t;
      }
    }
    const auto loop = static_cast<int>(this->Base.Loop.size());
    const auto ring = static_cast<int>(this->Position.Cover.Ring.size());
    const int last = kept + static_cast<int>(deformed.rows());
    // The band's indices: the loop, then the ring, then its midpoints.
    const auto numberOf = [&](int corner)
    {
      return corner < loop     ? kept + this->Base.Loop[corner]
        : corner < loop + ring ? number[this->Position.Cover.Ring[corner - loop]]
                               : last + corner - loop - ring;
    };
    const auto addMidpoint = [&](int a, int b)
    {
      ofTarget.AddMean({ a, b });
      ofFeature.AddMean({ a, b });
    };
    for (const auto& [a, b] : this->Feature.Midpoints)
    {
      addMidpoint(kept + a, kept + b);
    }
    for (Eigen::Index i = 0; i < midpoints; ++i)
    {
      const int a = numberOf(this->Position.Join.Midpoints[i][0]);
      const int b = numberOf(this->Position.Join.Midpoints[i][1]);
      addMidpoint(a, b);
      result.Surface.Points.row(last + i) =
        0.5 * (result.Surface.Points.row(a) + result.Surface.Points.row(b));
    }
    const std::vector<int> under = this->TrianglesUnderBand();
    for (Eigen::Index t = 0; t < band.rows(); ++t, ++next)
    {
      targetCells(next) = under[t];
      for (int k = 0; k < 3; ++k)
      {
        triangles(next, k) = numberOf(band(t, k));
      }
    }
    triangles.bottomRows(this->Feature.Triangles.rows()) = this->Feature.Triangles.array() + kept;
    featureCells.tail(this->Feature.Triangles.rows()) = Eigen::Map<const Eigen::VectorXi>(
      this->Feature.Original.data(), this->Feature.Triangles.rows());
    result.Target = ofTarget.Finish(targetCells);
    result.Feature = ofFeature.Finish(featureCells);
    return result;
  }

private:
  /// Returns, for each triangle of the band, the target's triangle at one of its corners.
  std::vector<int> TrianglesUnderBand() const
  {
    const CoveredRegion& cover = this->Position.Cover;
    const auto loop = static_cast<int>(cover.Loop.rows());
    std::map<int, int> around; // a covered triangle at each point of the ring
    for (const int triangle : cover.Triangles)
    {
      for (const int point : this->Target.Triangles().row(triangle))
      {
        around.emplace(point, triangle);
      }
    }
    std::vector<int> triangles;
    for (const auto& corners : this->Position.Join.Triangles.rowwise())
    {
      const int corner = corners.minCoeff(); // points of the loop come before those of the ring
      triangles.push_back(
        corner < loop ? cover.Positions.Triangles(corner) : around.at(cover.Ring[corner - loop]));
    }
    return triangles;
  }

  /// Returns, for each point of the target, its index in the result, or -1. points: the kept ones.
  /// Three groups: points strictly inside the region are dropped, points of the ring are kept
  /// unless a point of the loop coincides with them, all others are kept.
  std::vector<int> Number(std::vector<int>& points) const
  {
    std::vector<int> number(this->Target.Points().rows(), 0);
    for (const int triangle : this->Position.Cover.Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        number[this->Target.Triangles()(triangle, k)] = -1;
      }
    }
    const std::vector<int>& ring = this->Position.Cover.Ring;
    const auto loop = static_cast<int>(this->Base.Loop.size());
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      // A point of the loop replaces coincident points of the ring.
      number[ring[i]] =
        this->Position.Join.RingPoints(static_cast<Eigen::Index>(i)) < loop ? -1 : 0;
    }
    for (int point = 0; point < static_cast<int>(number.size()); ++point)
    {
      if (number[point] == 0)
      {
        number[point] = static_cast<int>(points.size());
        points.push_back(point);
      }
    }
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const int same = this->Position.Join.RingPoints(static_cast<Eigen::Index>(i));
      if (same < loop)
      {
        number[ring[i]] = static_cast<int>(points.size()) + this->Base.Loop[same];
      }
    }
    return number;
  }

  const Surface& Target;
  const CutTriangles& Feature;
  const FeatureFootprint& Base;
  const LoopOnTarget& Position;
};

} // namespace

PastedFeature JoinFeatureAndTarget(const Surface& target, const CutTriangles& feature,
  const FeatureFootprint& base, const LoopOnTarget& landing, const Eigen::MatrixXd& deformed)
{
  return Assembly(target, feature, base, landing).Make(deformed);
}

} // namespace shape
