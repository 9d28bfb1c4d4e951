#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// Three samples of A and three of B, by their indices: a Moebius map.
struct TriplePair
{
  std::array<int, 3> OfA, OfB;
};

/// Returns all pairs of triples of the first `generators` samples in which no distance between two
/// samples of A differs from that of their partners by more than `tolerance` of the longer one.
/// betweenA, betweenB: the distances between the samples, square. The first `paired` samples
/// of A go to those of B with the same index, and no other sample goes there; a triple of them
/// alone may have any distances.
std::vector<TriplePair> FindSimilarTriples(const Eigen::MatrixXd& betweenA,
  const Eigen::MatrixXd& betweenB, int generators, double tolerance, int paired = 0);

/// Returns a random selection of at most `count`, in order; always the same.
std::vector<TriplePair> SelectTriples(const std::vector<TriplePair>& all, int count);

} // namespace shape
