#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct MoebiusVotingOptions
{
  int Samples = 100;   ///< points of each surface that get votes; >= 10
  int Generators = 20; ///< the first of them, of which triples are formed; >= 3
  int Triples = 20000; ///< maximum number of pairs of triples, each of which makes a map; >= 1
  /// Two triples make a map only if no distance between two of its points differs by more than this
  /// share of the longer one; > 0. 1: all triples do, as in the paper.
  double Tolerance = 0.3;
  /// A map votes only if it has this share of the partners of the map with the most; in (0, 1].
  double Share = 0.9;
  /// The deformation energy at which a vote counts half; > 0.
  double Energy = 0.05;
};

struct MoebiusVotes
{
  ///@{
  /// The samples: the features, which are the tips of extremities, then the farthest points.
  std::vector<int> SamplesOfA, SamplesOfB;
  ///@}
  /// sA x sB: the correspondence matrix. The share of all votes for each pair of samples, sum 1.
  Eigen::MatrixXd Votes;
  /// At least three pairs of points, in the order of A's samples. Their samples got more votes for
  /// each other than for any other sample. Their distances from the other pairs agree by more than
  /// 1/2, as AssignFeatures measures it, in the mean weighted by confidences.
  Landmarks Pairs;
  /// For each pair, the share of the maps that voted for it, each weighted by its vote; in (0, 1].
  Eigen::VectorXd Confidences;
  int Maps = 0; ///< number of maps that voted
};

/**
 * Finds corresponding points of two surfaces of genus 0 by voting (Lipman and Funkhouser, "Moebius
 * voting for surface correspondence", 2009).
 *
 * FlattenMidEdges maps both surfaces conformally to the plane, with fans in their holes. Three
 * samples of each surface determine a Moebius map, which takes the former to the latter. Both
 * triples are brought to an equilateral triangle on the equator of the unit sphere, where the
 * samples of both surfaces are compared. Two samples are partners if each is the nearest one to the
 * other (mutually nearest neighbours, section 5 of the paper). The deformation energy of the map is
 * the mean distance between partners. A map with enough partners gives each pair of them the vote
 * Energy / (Energy + deformation energy). Unlike in the paper, distances are those on the sphere,
 * where no place is far away. Triples with different geodesic distances make no map. Enough
 * partners are nearly as many as any map has, not a given share of the samples: wrong maps of
 * stretched surfaces have more partners than true maps of others. If there are too many triples, a
 * random selection is used, always the same.
 *
 * Moebius maps keep orientation, so left and right are not exchanged.
 *
 * a, b: consistently oriented 2-manifolds of one component and genus 0, closed or with holes. Each
 * point has a triangle, and the triangles face outwards. Throws InvalidInput if the surfaces are
 * not as required, an option is out of range, or fewer than three pairs are found; SolveFailure;
 * Aborted.
 */
MoebiusVotes VoteByMoebiusMaps(const Surface& a, const Surface& b,
  const MoebiusVotingOptions& options = {}, const Progress& progress = {});

} // namespace shape
