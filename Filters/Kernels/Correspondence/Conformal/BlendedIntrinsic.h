#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

struct BlendedIntrinsicOptions
{
  /// Which conformal maps are candidates.
  enum class CandidatesType
  {
    Landmarks = 0, ///< those of triples of landmarks, given or found: one assignment
    Triplets = 1   ///< those of triples of feature points, with all similar assignments
  };
  CandidatesType CandidatesFrom = CandidatesType::Landmarks;
  int Candidates = 60; ///< maximum number of conformal maps to blend; >= 1
  int Samples = 200;   ///< points of A at which the maps are compared; >= 10
  /// Two maps agree by 1 / e at a point if its two images are at this distance (> 0) from each
  /// other. The distance is relative to the root of the target's area.
  double Agreement = 0.1;
  ///@{
  /// Triplets.
  int TripletPoints = 12; ///< points of each surface, besides landmarks, that form triples; >= 3
  /// Two triples make a map only if no distance between two of its points differs by more than this
  /// share of the longer one; > 0. 1: all triples do.
  double TripletTolerance = 0.3;
  int TripletMaps = 500; ///< maximum number of maps whose consistency is computed; >= 1
  /// An eigenvector of the consistency matrix makes a group of maps if its eigenvalue is at least
  /// this share of the largest one; in (0, 1]. 1: only the leading one does.
  double GroupShare = 0.5;
  ///@}
};

struct BlendedIntrinsicResult
{
  SurfaceMaps Maps;
  ///@{
  /// The confidence of the map at each point, in [0, 1]: the mean trust in the blended maps, times
  /// exp(-(s / Agreement)^2), where s is the standard deviation of the images.
  Eigen::VectorXd ConfidenceOfA, ConfidenceOfB;
  ///@}
  Eigen::MatrixXi TriplesOfA, TriplesOfB; ///< c x 3: the points that determine each candidate
  Eigen::MatrixXd Consistency;            ///< c x c: symmetric, with entries in [0, 1]
  /// c values >= 0, with norm 1: the weights of the candidates, 0 outside the group. The
  /// `Candidates` largest ones are blended, with Triplets those that are largest in some region.
  Eigen::VectorXd Weights;
};

/**
 * Computes corresponding points of two surfaces of genus 0 by blending conformal maps, each of
 * which is good in some region (Kim, Lipman and Funkhouser, "Blended intrinsic maps", 2011).
 *
 * Each surface is mapped to the sphere, with its holes closed by fans. MapToSphere uses the same
 * method for both surfaces. If either surface has a hole, PositiveFlow is tried first. Each triple
 * of landmarks defines a Moebius map between the spheres (Lipman and Funkhouser, "Moebius voting
 * for surface correspondence", 2009). At most 300 triples are used, evenly spread. The trust in a
 * map at a point is 1 / cosh(s), where s is the logarithm of the map's area scale at the point. The
 * agreement of two maps is an integral over the points of A. Its integrand is the product of both
 * trusts and of exp(-(d / Agreement)^2), where d is the distance between the point's two images.
 * The leading eigenvector of the matrix of agreements gives the weights of the maps, so maps that
 * agree with no others get no weight (section 4 of the paper). Each point is mapped to the position
 * nearest to the mean of its images. An image has the weight of its map, times the trust in this
 * map at the point. The mean is taken in the EmbedBySmacof positions of the other surface, where
 * straight distances approximate geodesic ones (section 5).
 *
 * With Triplets, no assignment of landmarks is needed (section 3 of the paper). Feature points are
 * the given landmarks, which go to their partners only, the tips of extremities, and farthest
 * points. All similar triples of them are candidates. Those with the highest mean trust are
 * compared; with landmarks, the trust in a candidate is multiplied by how near it takes them to
 * their partners. A symmetric shape has several groups of consistent maps, which are eigenvectors
 * of the matrix. The group with the greatest total confidence is blended, by the maps with the
 * largest weights at each sample. The order of points matters only to the samples of EmbedBySmacof.
 *
 * Moebius maps keep orientation, so nothing is mirrored, whatever landmarks are given. On surfaces
 * with very long, thin extremities, MapToSphere falls back on its last method, which is not
 * conformal; the result is then worse. With CandidatesFrom Landmarks, FindLandmarks finds landmarks
 * if none are given.
 *
 * a, b: consistently oriented 2-manifolds of one component and genus 0, closed or with holes. Each
 * point has a triangle, and the triangles face outwards. landmarks: none, or any number with
 * Triplets; else at least three, of which three are distinct points on both surfaces. Throws
 * InvalidInput if the input is not as required; SolveFailure; Aborted.
 */
BlendedIntrinsicResult ComputeBlendedIntrinsicMap(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const BlendedIntrinsicOptions& options = {},
  const Progress& progress = {});

} // namespace shape
