#include "Labels/LabelImage.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cmath>

namespace shape
{

void MakeLabels(LabelImage& image, const std::vector<double>& thresholds)
{
  for (std::size_t i = 0; i < thresholds.size(); ++i)
  {
    if (!std::isfinite(thresholds[i]) || (i > 0 && thresholds[i] <= thresholds[i - 1]))
    {
      throw InvalidInput("the Thresholds are not finite and ascending; sort them");
    }
  }
  image.Thresholds = thresholds;
  image.Labels.resize(image.Values.size());
  for (std::size_t i = 0; i < image.Values.size(); ++i)
  {
    image.Labels[i] =
      static_cast<int>(std::upper_bound(thresholds.begin(), thresholds.end(), image.Values[i],
                         [](double value, double threshold) { return !(value >= threshold); }) -
        thresholds.begin());
  }
}

double FindCrossing(const LabelImage& image, std::size_t first, std::size_t second)
{
  if (image.Values.empty())
  {
    return 0.5;
  }
  const double a = image.Values[first], b = image.Values[second];
  const auto isBetween = [&](double threshold)
  { return std::min(a, b) < threshold && threshold <= std::max(a, b); };
  double sum = 0.0;
  int count = 0;
  for (const double threshold : image.Thresholds)
  {
    if (isBetween(threshold))
    {
      sum += (threshold - a) / (b - a);
      ++count;
    }
  }
  return count == 0 ? 0.5 : sum / count;
}

} // namespace shape
