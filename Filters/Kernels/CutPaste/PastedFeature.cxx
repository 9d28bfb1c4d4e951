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
  Assembly(const Surface& target, const CutTriangles& feature,
    const std::vector<FeatureFootprint>& bases, const std::vector<LoopOnTarget>& landings)
    : Target(target)
    , Feature(feature)
    , Bases(bases)
    , Landings(landings)
  {
  }

  /// deformed: the feature's deformed points.
  /// Points: kept ones of the target, the feature's, midpoints of the band. Triangles: kept ones of
  /// the target, the band, the feature's.
  PastedFeature Make(const Eigen::MatrixXd& deformed)
  {
    PastedFeature result;
    std::vector<bool> isGone(this->Target.Triangles().rows(), false);
    Eigen::Index count = this->Target.Triangles().rows(), midpoints = 0;
    for (const LoopOnTarget& landing : this->Landings)
    {
      for (const int triangle : landing.Cover.Triangles)
      {
        isGone[triangle] = true;
        --count;
      }
      result.BandTriangles += static_cast<int>(landing.Join.Triangles.rows());
      midpoints += static_cast<Eigen::Index>(landing.Join.Midpoints.size());
    }
    std::vector<int> targetPoints;
    const std::vector<int> number = this->Number(targetPoints);
    const auto kept = static_cast<int>(targetPoints.size());
    const Eigen::Index given =
      deformed.rows() - static_cast<Eigen::Index>(this->Feature.Midpoints.size());
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
    triangles.resize(count + result.BandTriangles + this->Feature.Triangles.rows(), 3);
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
    const auto addMidpoint = [&](int a, int b)
    {
      ofTarget.AddMean({ a, b });
      ofFeature.AddMean({ a, b });
    };
    for (const auto& [a, b] : this->Feature.Midpoints)
    {
      addMidpoint(kept + a, kept + b);
    }
    int last = kept + static_cast<int>(deformed.rows()); // the next midpoint of a band
    for (std::size_t l = 0; l < this->Landings.size(); ++l)
    {
      const SeamBand& band = this->Landings[l].Join;
      const std::vector<int>& loop = this->Bases[l].Loop;
      const std::vector<int>& ring = this->Landings[l].Cover.Ring;
      const auto inner = static_cast<int>(loop.size());
      const int outer = inner + static_cast<int>(ring.size());
      // The band's indices: the loop, then the ring, then its midpoints.
      const auto numberOf = [&, first = last](int corner)
      {
        return corner < inner ? kept + loop[corner]
          : corner < outer    ? number[ring[corner - inner]]
                              : first + corner - outer;
      };
      for (const auto& [a, b] : band.Midpoints)
      {
        addMidpoint(numberOf(a), numberOf(b));
        result.Surface.Points.row(last++) =
          0.5 * (result.Surface.Points.row(numberOf(a)) + result.Surface.Points.row(numberOf(b)));
      }
      const std::vector<int> under = this->TrianglesUnderBand(this->Landings[l]);
      for (Eigen::Index t = 0; t < band.Triangles.rows(); ++t, ++next)
      {
        targetCells(next) = under[t];
        for (int k = 0; k < 3; ++k)
        {
          triangles(next, k) = numberOf(band.Triangles(t, k));
        }
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
  /// Returns, for each triangle of a band, the target's triangle at one of its corners.
  std::vector<int> TrianglesUnderBand(const LoopOnTarget& landing) const
  {
    const CoveredRegion& cover = landing.Cover;
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
    for (const auto& corners : landing.Join.Triangles.rowwise())
    {
      const int corner = corners.minCoeff(); // points of the loop come before those of the ring
      triangles.push_back(
        corner < loop ? cover.Positions.Triangles(corner) : around.at(cover.Ring[corner - loop]));
    }
    return triangles;
  }

  /// Returns, for each point of the target, its index in the result, or -1. points: the kept ones.
  /// Three groups: points strictly inside the regions are dropped, points of the rings are kept
  /// unless a point of the loop coincides with them, all others are kept.
  std::vector<int> Number(std::vector<int>& points) const
  {
    std::vector<int> number(this->Target.Points().rows(), 0);
    for (const LoopOnTarget& landing : this->Landings)
    {
      for (const int triangle : landing.Cover.Triangles)
      {
        for (int k = 0; k < 3; ++k)
        {
          number[this->Target.Triangles()(triangle, k)] = -1;
        }
      }
    }
    // A point of the loop replaces coincident points of the ring.
    std::map<int, int> replaced; // by the point of the feature
    for (std::size_t l = 0; l < this->Landings.size(); ++l)
    {
      const std::vector<int>& ring = this->Landings[l].Cover.Ring;
      const std::vector<int>& loop = this->Bases[l].Loop;
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        const int same = this->Landings[l].Join.RingPoints(static_cast<Eigen::Index>(i));
        number[ring[i]] = 0;
        if (same < static_cast<int>(loop.size()))
        {
          number[ring[i]] = -1;
          replaced[ring[i]] = loop[same];
        }
      }
    }
    for (int point = 0; point < static_cast<int>(number.size()); ++point)
    {
      if (number[point] == 0)
      {
        number[point] = static_cast<int>(points.size());
        points.push_back(point);
      }
    }
    for (const auto& [point, by] : replaced)
    {
      number[point] = static_cast<int>(points.size()) + by;
    }
    return number;
  }

  const Surface& Target;
  const CutTriangles& Feature;
  const std::vector<FeatureFootprint>& Bases;
  const std::vector<LoopOnTarget>& Landings;
};

} // namespace

PastedFeature JoinFeatureAndTarget(const Surface& target, const CutTriangles& feature,
  const std::vector<FeatureFootprint>& bases, const std::vector<LoopOnTarget>& landings,
  const Eigen::MatrixXd& deformed)
{
  return Assembly(target, feature, bases, landings).Make(deformed);
}

} // namespace shape
