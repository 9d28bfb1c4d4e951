#include "Hex/Features/Private/UnmatchedCurves.h"

#include "Hex/Features/LostCreases.h"

#include <limits>

namespace shape
{

UnmatchedCurves::UnmatchedCurves(const Surface& surface, const SurfaceFeatures& features)
  : Whole(surface)
  , Features(features)
{
  for (const CreaseLine& line : BuildCreaseLines(surface, features))
  {
    this->Lengths.push_back(ComputeLength({ line }));
  }
}

void UnmatchedCurves::AddAtCorner(int corner)
{
  this->AddBest([&](const FeatureCurve& curve)
    { return curve.Points.front() == corner || curve.Points.back() == corner; },
    [&](std::size_t i) { return this->Lengths[i]; });
}

void UnmatchedCurves::AddAround(int patch)
{
  this->AddBest([&](const FeatureCurve& curve)
    { return curve.Patches[0] == patch || curve.Patches[1] == patch; },
    [&](std::size_t i) { return this->Lengths[i]; });
}

void UnmatchedCurves::AddBetween(const std::set<int>& patches, const Eigen::RowVector3d& position)
{
  const auto has = [&](int patch) { return patches.count(patch) > 0; };
  const bool found = this->AddBest([&](const FeatureCurve& curve)
    { return has(curve.Patches[0]) && has(curve.Patches[1]); },
    [&](std::size_t i) { return this->Lengths[i]; });
  if (!found)
  {
    this->AddBest([&](const FeatureCurve& curve)
      { return has(curve.Patches[0]) || has(curve.Patches[1]); },
      [&](std::size_t i)
      {
        return (
          this->Whole.Points()(this->Features.Curves[i].Points, Eigen::all).rowwise() - position)
          .rowwise()
          .squaredNorm()
          .minCoeff();
      });
  }
}

bool UnmatchedCurves::AddBest(const std::function<bool(const FeatureCurve&)>& accepts,
  const std::function<double(std::size_t)>& cost)
{
  double minimum = std::numeric_limits<double>::infinity();
  int best = -1;
  for (std::size_t i = 0; i < this->Features.Curves.size(); ++i)
  {
    if (!accepts(this->Features.Curves[i]))
    {
      continue;
    }
    if (this->Curves.count(static_cast<int>(i)) > 0)
    {
      return true;
    }
    if (const double own = cost(i); own < minimum)
    {
      minimum = own;
      best = static_cast<int>(i);
    }
  }
  if (best >= 0)
  {
    this->Curves.insert(best);
  }
  return best >= 0;
}

} // namespace shape
