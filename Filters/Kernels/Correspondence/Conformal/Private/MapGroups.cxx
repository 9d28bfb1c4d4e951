#include "Correspondence/Conformal/Private/MapGroups.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <numeric>

namespace shape
{

Eigen::MatrixXd ComputeConsistency(const std::vector<ConformalImages>& images, double agreement)
{
  const auto count = static_cast<Eigen::Index>(images.size());
  // Farthest-point samples are evenly spread, so each represents the same area.
  const Eigen::ArrayXd areas = Eigen::ArrayXd::Constant(
    images.front().Trust.size(), 1.0 / static_cast<double>(images.front().Trust.size()));
  Eigen::MatrixXd consistency(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (Eigen::Index j = 0; j <= i; ++j)
    {
      const Eigen::ArrayXd near =
        (-(images[i].Positions - images[j].Positions).rowwise().squaredNorm().array() /
          (agreement * agreement))
          .exp();
      consistency(i, j) = consistency(j, i) =
        (areas * images[i].Trust.array() * images[j].Trust.array() * near).sum();
    }
  }
  return consistency;
}

/// By Perron and Frobenius: the matrix has no negative entry. The sign that the solver returns is
/// arbitrary, hence the absolute values.
Eigen::VectorXd FindLeadingWeights(const Eigen::MatrixXd& consistency)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> pairs(consistency);
  return pairs.eigenvectors().rightCols(1).cwiseAbs();
}

ImageBlend::ImageBlend(Eigen::Index points, Eigen::Index dimensions)
  : Sums(Eigen::MatrixXd::Zero(points, dimensions))
  , Weights(Eigen::VectorXd::Zero(points))
  , Trusts(Weights)
  , Squares(Weights)
{
}

void ImageBlend::Add(const ConformalImages& images, double weight)
{
  const Eigen::VectorXd own = weight * images.Trust;
  this->Sums += own.asDiagonal() * images.Positions;
  this->Weights += own;
  this->Trusts += own.cwiseProduct(images.Trust);
  this->Squares += own.cwiseProduct(images.Positions.rowwise().squaredNorm());
}

Eigen::MatrixXd ImageBlend::Means() const
{
  return this->Weights.cwiseInverse().asDiagonal() * this->Sums;
}

Eigen::ArrayXd ImageBlend::Confidences(double agreement) const
{
  // Where no map is trusted at all, there is no confidence either.
  const Eigen::ArrayXd weights = this->Weights.array().max(1e-300);
  const Eigen::ArrayXd variances = (this->Squares.array() / weights -
    (this->Sums.rowwise().squaredNorm().array() / weights.square()))
                                     .max(0.0);
  return this->Trusts.array() / weights * (-variances / (agreement * agreement)).exp();
}

Eigen::VectorXd FindBestGroup(const std::vector<ConformalImages>& images,
  const Eigen::MatrixXd& consistency, double agreement, double share)
{
  constexpr double member = 0.25; // of the largest entry
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> pairs(consistency);
  const Eigen::VectorXd& values = pairs.eigenvalues();
  Eigen::VectorXd best;
  double most = -1.0;
  for (Eigen::Index k = values.size() - 1; k >= 0 && values(k) >= share * values.maxCoeff(); --k)
  {
    Eigen::VectorXd weights = pairs.eigenvectors().col(k);
    Eigen::Index largest = 0;
    weights.cwiseAbs().maxCoeff(&largest);
    weights /= weights(largest); // the sign of an eigenvector is arbitrary
    weights = (weights.array() >= member).select(weights, 0.0);
    ImageBlend blend(images.front().Trust.size(), images.front().Positions.cols());
    for (Eigen::Index i = 0; i < weights.size(); ++i)
    {
      if (weights(i) > 0.0)
      {
        blend.Add(images[i], weights(i));
      }
    }
    const double total =
      blend.Confidences(agreement).mean() * static_cast<double>((weights.array() > 0.0).count());
    if (total > most)
    {
      most = total;
      best = weights / weights.norm();
    }
  }
  return best;
}

std::vector<int> SelectForEachRegion(
  const std::vector<ConformalImages>& images, const Eigen::VectorXd& weights, int count)
{
  std::vector<int> members;
  for (int i = 0; i < static_cast<int>(weights.size()); ++i)
  {
    if (weights(i) > 0.0)
    {
      members.push_back(i);
    }
  }
  const Eigen::Index samples = images.front().Trust.size();
  std::vector<std::vector<int>> orders(samples, members);
  for (Eigen::Index p = 0; p < samples; ++p)
  {
    const auto there = [&](int i) { return weights(i) * images[i].Trust(p); };
    std::stable_sort(
      orders[p].begin(), orders[p].end(), [&](int i, int j) { return there(i) > there(j); });
  }
  std::vector<char> isTaken(weights.size(), 0);
  std::vector<int> selected;
  for (std::size_t rank = 0; rank < members.size(); ++rank)
  {
    for (const std::vector<int>& order : orders)
    {
      if (isTaken[order[rank]] == 0 && static_cast<int>(selected.size()) < count)
      {
        isTaken[order[rank]] = 1;
        selected.push_back(order[rank]);
      }
    }
  }
  return selected;
}

} // namespace shape
