#pragma once

#include "Base/Progress.h"
#include "Correspondence/Consistent/ConsistentMapsOptions.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Throws InvalidInput if an option is out of range.
void RequireOptions(const ConsistentMapsOptions& options);

/// Two shapes that were matched.
struct ConsistentPair
{
  int A = 0, B = 0; ///< numbers of the shapes; a given template has the last one
  int Rank = 0;     ///< the candidate that agrees with the other maps; 0 is the pair's own best one
  double Error = 0.0;        ///< AutomaticLandmarksResult::Error of this candidate
  double Confidence = 0.0;   ///< AutomaticLandmarksResult::Confidence of the best candidate
  double Disagreement = 0.0; ///< CandidateChoice::Disagreements
  bool Dropped = false;      ///< whether the map contradicts the others and was left out
};

struct ConsistentMaps
{
  int Template = -1; ///< number of the shape that is the template, -1 if it was given
  /// For each shape: BToA are the positions of the template's points on the shape, AToB the images
  /// of its points on the template, the inverse of BToA (InvertMap).
  std::vector<SurfaceMaps> Maps;
  /// For each shape, the images of its points on the template by a map that is nearly the inverse
  /// of BToA and smooth, also where parts of the shape touch. Derivatives need it.
  std::vector<SurfacePoints> SmoothImages;
  std::vector<ConsistentPair> Pairs; ///< with LimitShape
  /// For each shape, the mean Disagreement of its pairs that were kept; 0 with None.
  Eigen::VectorXd Disagreements;
  ///@{
  /// The mean distance of a point from its image after the way A -> B -> C -> A, over the triples
  /// of which all pairs were matched, divided by the root of the area: by Maps, and by the best
  /// functional map of each pair alone. -1 if there is no such triple.
  double CycleError = -1.0, PairwiseCycleError = -1.0;
  ///@}
  int Triples = 0; ///< the number of triples that were measured, at most 300
};

/**
 * Maps N surfaces with different points and triangles onto one template, from the surfaces alone
 * or with landmarks (Numbered).
 *
 * Only pairs of similar shapes are matched (Neighbours), and those that connect all. Each offers
 * several maps (FindLandmarkCandidates). ChooseCandidates selects the ones that agree around cycles
 * and drops the pairs of which none does. The maps are then refined together: all shapes have
 * frames of one space of latent functions (AverageFrames), points with the nearest values of these
 * functions correspond, and these give functional maps of more eigenfunctions (Huang, Ren, Wonka
 * and Ovsjanikov, "Consistent ZoomOut: efficient spectral map synchronization", 2020). At the end,
 * the functional map of each shape onto the template, over the latent functions, is refined for
 * this pair alone (RefineByZoomOut). The map between two shapes is the way over the template: to
 * the image of a point, and to the position whose image is there (MapInverse). So maps around
 * cycles agree where each map is one to one.
 *
 * shapes: surfaces that RequireConnected accepts. base: the template, or null: then it is the shape
 * whose products of latent functions (Y' Y and Y' L Y, with the eigenvalues L) differ least from
 * those of the others. With None, it is the shape with the most similar spectra.
 *
 * Throws InvalidInput if there are fewer than two surfaces, if a surface is not as described, if no
 * landmarks are found, or if an option is out of range; SolveFailure; Aborted.
 */
ConsistentMaps ComputeConsistentMaps(const std::vector<Surface>& shapes, const Surface* base,
  const ConsistentMapsOptions& options = {}, const PairSharing& sharing = {},
  const Progress& progress = {});

} // namespace shape
