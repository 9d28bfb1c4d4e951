#pragma once

#include "Base/Progress.h"
#include "Correspondence/CommonBase/HandleLandmarks.h"
#include "Correspondence/CorrespondenceOptions.h"
#include "Correspondence/Evaluate/Congruence.h"
#include "Correspondence/Evaluate/SurfaceMapFacts.h"
#include "Correspondence/Functional/FunctionalMatrix.h"
#include "Correspondence/Landmarks/AutomaticLandmarks.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Pair/SurfacePart.h"
#include "Correspondence/Transport/GromovHausdorff.h"
#include "Correspondence/Transport/SampledCoupling.h"
#include "Mesh/Surface.h"

#include <optional>

namespace shape
{

struct CorrespondenceResult
{
  /// A row for each point. A point that no triangle uses is mapped like the nearest corner of the
  /// closest triangle.
  SurfaceMaps Maps;
  Landmarks Used;     ///< the given landmarks, or those found automatically
  bool Found = false; ///< whether the landmarks were found automatically
  /// The result of FindLandmarks, if Found is true and FindLandmarksBy is Distances.
  AutomaticLandmarksResult Start;
  /// Whether the surfaces are the same shape or mirror images, if Found is true.
  std::optional<Congruence> Congruent;
  int VotingMaps = 0; ///< MoebiusVotes: see MoebiusVotes::Maps; otherwise 0
  /// MoebiusVotes: the mean confidence of the landmarks; otherwise -1.
  double VotingConfidence = -1.0;
  SurfacePart Part; ///< which surface is a part of the other one, and the scale between them
  /// Number of points of the larger one of the two surfaces on which the method ran.
  int CoarsePoints = 0;
  /// ReversibleHarmonic: iterations on the coarse surfaces; 0 if it returned its initial maps.
  int Iterations = 0;
  /// CommonBase: the base domain and the energies; its maps are moved to Maps.
  std::optional<CommonBaseMap> Base;
  /// BlendedIntrinsic: the candidate maps and the confidence; its maps are moved to Maps, and all
  /// points are those of the given surfaces.
  std::optional<BlendedIntrinsicResult> Blended;
  /// CommonBase with landmarks that were found, for surfaces with handles: the loops of A and the
  /// candidates, of which Used is one.
  std::optional<HandleLandmarks> Handles;
  ///@{
  /// CommonSphere: see SphereCommonDomainResult::SphereA, SphereB; otherwise empty.
  Eigen::MatrixXd SphereA, SphereB;
  ///@}
  double CouplingDistortion = -1.0; ///< GromovWasserstein: see GromovWassersteinResult::Distortion
  double CouplingError = -1.0;      ///< GromovWasserstein: see GromovWassersteinResult::Error
  double FeatureCost = -1.0;        ///< GromovWasserstein: see GromovWassersteinResult::FeatureCost
  /// GromovWasserstein: of points of the given surfaces. Of other methods with landmarks found by
  /// MoebiusVotes: the votes, and each sample's share of them, which may be 0.
  SampledCoupling Coupling;
  SurfaceMapFacts Facts;
  /// The matrix of Maps.BToA in the bases of a and b, with as many eigenfunctions as
  /// NumberOfEigenpairs and the points allow; empty unless CorrespondenceOptions::FunctionalMatrix.
  FunctionalMatrix Matrix;
  /// How much the maps change distances; empty unless CompareDistances or GeneralizedMDS.
  std::optional<GromovHausdorffResult> Distances;
  ///@{
  /// The genus of the surfaces (ComputeGenus). If they differ, no continuous one-to-one map exists.
  int GenusOfA = 0, GenusOfB = 0;
  ///@}
};

/**
 * Computes corresponding points of two surfaces, in both directions, by one of ten methods. The
 * header of each method says for which surfaces it is suitable. If no landmarks are given,
 * FindLandmarks or VoteByMoebiusMaps finds them; each surface must then have one component. For
 * CommonBase and surfaces with handles, FindHandleLandmarks finds better ones.
 * Landmarks found in this way are not pinned, and CommonOrbifold uses only the first four of them.
 * No landmarks are found for GeneralizedMDS, which needs none, nor if options.Functional.Guide has
 * descriptors or a matrix, which take their place (CorrespondenceOptions::IsGuided).
 *
 * The guide has a row for each point of a and b. Its matrix refers to SolveLaplaceEigenproblem's
 * bases of a and b, as FunctionalMatrix does; its bases are not used.
 *
 * a, b: consistently oriented 2-manifolds, facing outwards if they are closed. Points that no
 * triangle uses are ignored. Throws InvalidInput if the method does not suit the surfaces or the
 * landmarks, if a guide is given for a part, or if an option is out of range; SolveFailure;
 * Aborted.
 */
CorrespondenceResult ComputeCorrespondence(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const CorrespondenceOptions& options = {},
  const Progress& progress = {});

} // namespace shape
