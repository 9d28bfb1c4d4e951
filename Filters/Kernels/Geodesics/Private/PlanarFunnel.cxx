#include "Geodesics/Private/PlanarFunnel.h"

#include <algorithm>

namespace shape
{
namespace
{

using Eigen::RowVector2d;

double Cross(const RowVector2d& a, const RowVector2d& b)
{
  return a(0) * b(1) - a(1) * b(0);
}

} // namespace

PlanarFunnel::PlanarFunnel(const RowVector2d& start)
  : Points{ { start, -1, false, -1 } }
  , Chains{ 0 }
{
}

/// Lee and Preparata: points are removed from the left end while the new point makes the chain bend
/// inwards. Past the apex, the removal continues on the right chain, and the apex moves along it.
void PlanarFunnel::AddLeft(const RowVector2d& position, int portal)
{
  while (this->Chains.size() > 1)
  {
    const RowVector2d& end = this->At(0);
    const RowVector2d& next = this->At(1);
    const bool isApex = this->Lefts == 0;
    if (isApex ? Cross(next - end, position - end) > 0.0 : Cross(end - next, position - end) > 0.0)
    {
      break;
    }
    this->Chains.pop_front();
    this->Lefts -= isApex ? 0 : 1;
  }
  this->Points.push_back({ position, portal, true, this->Chains.front() });
  this->Chains.push_front(static_cast<int>(this->Points.size()) - 1);
  ++this->Lefts;
}

/// The mirror image of AddLeft.
void PlanarFunnel::AddRight(const RowVector2d& position, int portal)
{
  while (this->Chains.size() > 1)
  {
    const auto last = static_cast<int>(this->Chains.size()) - 1;
    const RowVector2d& end = this->At(last);
    const RowVector2d& next = this->At(last - 1);
    const bool isApex = this->Lefts == last;
    if (isApex ? Cross(next - end, position - end) < 0.0 : Cross(end - next, position - end) < 0.0)
    {
      break;
    }
    this->Chains.pop_back();
    this->Lefts -= isApex ? 1 : 0;
  }
  this->Points.push_back({ position, portal, false, this->Chains.back() });
  this->Chains.push_back(static_cast<int>(this->Points.size()) - 1);
}

std::vector<FunnelPoint> PlanarFunnel::PathToLast() const
{
  std::vector<FunnelPoint> path;
  for (int i = this->Points.back().Before; i > 0; i = this->Points[i].Before)
  {
    path.push_back(this->Points[i]);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

} // namespace shape
