#include "Hex/PlacesToMagnify.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shape
{

void PlacesToMagnify::Add(const Eigen::RowVector3d& centre, double times)
{
  constexpr double strength = 0.4, apart = 1.5; // radii
  if (std::none_of(this->Gathered.begin(), this->Gathered.end(),
        [&](const Magnifier& other)
        { return (other.Centre - centre).norm() < apart * other.Radius; }))
  {
    this->Gathered.push_back({ centre, this->Radius, times * strength });
  }
}

void PlacesToMagnify::AddFar(const PlacesAndDistances& far, double wanted)
{
  constexpr double share = 0.9;
  std::vector<int> order(far.Distances.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](int a, int b) { return far.Distances(a) > far.Distances(b); });
  for (const int i : order)
  {
    if (far.Distances(i) < share * wanted)
    {
      break;
    }
    // What is more than four times too far would take too many rounds.
    constexpr double most = 2.0;
    this->Add(far.Places.row(i), std::clamp(std::log2(0.5 * far.Distances(i) / wanted), 1.0, most));
  }
}

} // namespace shape
