#include "Correspondence/Pair/SurfacePart.h"

#include "Base/Errors.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Geodesics/HeatGeodesics.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// At most 12 landmarks at even intervals: more do not improve the scale.
Landmarks Some(const Landmarks& landmarks)
{
  constexpr std::size_t maximum = 12;
  const std::size_t count = std::min(landmarks.size(), maximum);
  Landmarks some;
  for (std::size_t i = 0; i < count; ++i)
  {
    some.push_back(landmarks[i * landmarks.size() / count]);
  }
  return some;
}

/// A few wrong landmarks change a mean, but not a median.
double Median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Logarithms of the ratios of distances on B to those on A, of every two landmarks; at least one.
std::vector<double> Ratios(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress)
{
  const Landmarks some = Some(landmarks);
  const std::vector<int> onA = PointsOf(some, 0), onB = PointsOf(some, 1);
  const Eigen::MatrixXd ofA =
                          ComputeHeatDistances(a, onA, progress.Part(0.0, 0.5))(onA, Eigen::all),
                        ofB =
                          ComputeHeatDistances(b, onB, progress.Part(0.5, 1.0))(onB, Eigen::all);
  std::vector<double> ratios;
  for (Eigen::Index i = 0; i < ofA.rows(); ++i)
  {
    for (Eigen::Index j = 0; j < i; ++j)
    {
      // Logarithms, so that exchanging A and B only changes the sign.
      const double ratio = std::log((ofB(i, j) + ofB(j, i)) / (ofA(i, j) + ofA(j, i)));
      if (std::isfinite(ratio)) // two landmarks may be the same point
      {
        ratios.push_back(ratio);
      }
    }
  }
  if (ratios.empty())
  {
    throw InvalidInput((landmarks.empty() ? "there are no landmarks"
                                          : "no two of the " + std::to_string(landmarks.size()) +
                             " landmarks are distinct points on both surfaces") +
      ", so the part's scale is unknown; give at least three");
  }
  return ratios;
}

} // namespace

SurfacePart MeasurePart(const Surface& a, const Surface& b, const Landmarks& landmarks,
  SurfacePart::WhichType which, const Progress& progress)
{
  const std::vector<double> ratios = Ratios(a, b, landmarks, progress);
  SurfacePart part{ which, std::exp(Median(ratios)), 1.0 };
  const double share =
    part.Scale * part.Scale * ComputePointAreas(a).sum() / ComputePointAreas(b).sum();
  part.Share = which == SurfacePart::WhichType::SurfaceB ? 1.0 / share : share;
  if (part.Share > 1.0)
  {
    throw InvalidInput(std::string("surface ") +
      (which == SurfacePart::WhichType::SurfaceA ? "A" : "B") +
      " is set as the part, but at the scale of the landmarks it has " +
      std::to_string(part.Share) +
      " times the area of the other surface; set Part to Automatic or None");
  }
  return part;
}

SurfacePart FindPart(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress)
{
  using Which = SurfacePart::WhichType;
  const double ratio = ComputePointAreas(b).sum() / ComputePointAreas(a).sum();
  SurfacePart part{ Which::None, std::sqrt(ratio), 1.0 };
  const Topology &ofA = a.Topology(), &ofB = b.Topology();
  const bool isOpenA = ofA.BoundaryLoops > 0, isOpenB = ofB.BoundaryLoops > 0;
  constexpr std::size_t fewest = 3;
  // A part of a connected surface has a boundary. The scale needs three landmarks for a median.
  if ((!isOpenA && !isOpenB) || ofA.Components > 1 || ofB.Components > 1 ||
    landmarks.size() < fewest)
  {
    return part;
  }
  std::vector<double> ratios = Ratios(a, b, landmarks, progress);
  const double median = Median(ratios), share = std::exp(2.0 * median) / ratio;
  for (double& value : ratios)
  {
    value = std::abs(value - median);
  }
  // A larger share cannot be distinguished from two complete surfaces of slightly different size.
  constexpr double maximum = 0.85;
  const bool isA = share < maximum && isOpenA, isB = 1.0 / share < maximum && isOpenB;
  // The spread of the ratios must be smaller than the change of length that the share means;
  // otherwise the scale is noise.
  if ((isA || isB) && Median(ratios) < std::abs(0.5 * std::log(share)))
  {
    part = { isA ? Which::SurfaceA : Which::SurfaceB, std::exp(median), isA ? share : 1.0 / share };
  }
  return part;
}

} // namespace shape
