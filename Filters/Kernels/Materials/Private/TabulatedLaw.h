#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace shape
{

/// A function of one number on an interval, tabulated, and linear between the values of the table.
class TabulatedLaw
{
public:
  TabulatedLaw(double minimum, double maximum, const std::function<double(double)>& law)
    : Minimum(minimum)
    , Scale(maximum > minimum ? Intervals / (maximum - minimum) : 0.0)
    , Values(maximum > minimum ? Intervals + 1 : 1)
  {
    for (std::size_t i = 0; i < this->Values.size(); ++i)
    {
      const double share = static_cast<double>(i) / Intervals;
      this->Values[i] = law(minimum + share * (maximum - minimum));
    }
  }

  double operator()(double value) const
  {
    const double position = std::max(0.0, (value - this->Minimum) * this->Scale);
    const std::size_t last = this->Values.size() - 1;
    const std::size_t i = std::min(static_cast<std::size_t>(position), last);
    const double rest = position - static_cast<double>(i);
    // At the end of the domain of the law, the next value may be no number.
    return i == last || rest == 0.0
      ? this->Values[i]
      : this->Values[i] + rest * (this->Values[i + 1] - this->Values[i]);
  }

private:
  static constexpr int Intervals = 65536;
  double Minimum, Scale;
  std::vector<double> Values;
};

} // namespace shape
