#include "Volume/FastSummation.h"

#include "Volume/DirectSummation.h"

namespace shape
{

struct FastSummation::Parts
{
  Eigen::MatrixXd Sources, Points;
};

FastSummation::FastSummation(const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points,
  const FastSummationOptions&, const Progress&)
  : Self(std::make_unique<Parts>(Parts{ sources, points }))
{
}

FastSummation::~FastSummation() = default;
FastSummation::FastSummation(FastSummation&&) noexcept = default;
FastSummation& FastSummation::operator=(FastSummation&&) noexcept = default;

Eigen::MatrixXd FastSummation::Potentials(
  const Eigen::MatrixXd& charges, const Progress& progress) const
{
  return DirectPotentials(this->Self->Sources, charges, this->Self->Points, progress);
}

Eigen::MatrixXd FastSummation::Gradients(
  const Eigen::MatrixXd& charges, const Progress& progress) const
{
  return DirectGradients(this->Self->Sources, charges, this->Self->Points, progress);
}

} // namespace shape
