#include "Linear/LimitedMemoryBfgs.h"

#include <utility>
#include <vector>

namespace shape
{

double InnerProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  return a.cwiseProduct(b).sum();
}

LimitedMemoryBfgs::LimitedMemoryBfgs(
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd& gradient)> smooth)
  : Smooth(std::move(smooth))
{
}

void LimitedMemoryBfgs::Add(Eigen::MatrixXd step, Eigen::MatrixXd change)
{
  constexpr std::size_t longest = 10;
  const double product = InnerProduct(step, change);
  if (product > 1e-12 * step.norm() * change.norm())
  {
    this->Entries.push_back({ std::move(step), std::move(change), 1.0 / product });
    if (this->Entries.size() > longest)
    {
      this->Entries.pop_front();
    }
  }
}

Eigen::MatrixXd LimitedMemoryBfgs::Apply(Eigen::MatrixXd gradient) const
{
  // The two-loop recursion.
  std::vector<double> factors;
  for (auto entry = this->Entries.rbegin(); entry != this->Entries.rend(); ++entry)
  {
    factors.push_back(entry->Inverse * InnerProduct(entry->Step, gradient));
    gradient -= factors.back() * entry->Change;
  }
  Eigen::MatrixXd direction = this->Smooth(gradient);
  if (!this->IsEmpty())
  {
    const Entry& last = this->Entries.back();
    direction /= last.Inverse * InnerProduct(last.Change, this->Smooth(last.Change));
  }
  for (const Entry& entry : this->Entries)
  {
    const double back = entry.Inverse * InnerProduct(entry.Change, direction);
    direction += (factors.back() - back) * entry.Step;
    factors.pop_back();
  }
  return direction;
}

} // namespace shape
