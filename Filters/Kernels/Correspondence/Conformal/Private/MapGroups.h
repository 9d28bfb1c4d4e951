#pragma once

#include "Correspondence/Conformal/Private/RoundSurface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Returns the consistency matrix of conformal maps (section 4 of Kim et al. 2011): entry i, j is
/// the mean over the samples of both trusts times exp(-(d / agreement)^2), where d is the distance
/// between the two images. images: of the same samples under each map.
Eigen::MatrixXd ComputeConsistency(const std::vector<ConformalImages>& images, double agreement);

/// Returns the leading eigenvector of a consistency matrix, which has no negative entries.
Eigen::VectorXd FindLeadingWeights(const Eigen::MatrixXd& consistency);

/// The mean of the images of points under several maps. Each image has the weight of its map times
/// the trust in the map there (section 5 of the paper).
class ImageBlend
{
public:
  ImageBlend(Eigen::Index points, Eigen::Index dimensions);
  void Add(const ConformalImages& images, double weight);
  Eigen::MatrixXd Means() const;
  /// For each point, the weighted mean of the trusts, times exp(-(s / agreement)^2), where s is the
  /// standard deviation of the images; in [0, 1].
  Eigen::ArrayXd Confidences(double agreement) const;

private:
  Eigen::MatrixXd Sums;
  Eigen::VectorXd Weights, Trusts, Squares;
};

/// Returns the weights of the maps of the best group of consistent maps, and 0 for all others. Each
/// eigenvector whose eigenvalue is at least `share` of the largest one makes a group: the maps with
/// at least a quarter of its largest entry. The best group has the greatest total confidence: the
/// mean confidence of its blend, times the number of its maps.
Eigen::VectorXd FindBestGroup(const std::vector<ConformalImages>& images,
  const Eigen::MatrixXd& consistency, double agreement, double share);

/// Returns at most `count` maps with positive weights: those with the largest blending weights at
/// the first sample, the second, and so on, then those with the second largest ones. So each region
/// has maps that are good there.
std::vector<int> SelectForEachRegion(
  const std::vector<ConformalImages>& images, const Eigen::VectorXd& weights, int count);

} // namespace shape
