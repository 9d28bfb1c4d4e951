#pragma once

#include "Base/Progress.h"
#include "Correspondence/CommonBase/CommonBaseMap.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

/// A loop around a handle or through a tunnel of a surface.
struct HandleLoop
{
  std::vector<int> Points; ///< along edges, in order; the last one is the first one again
  bool IsTunnel = false;   ///< whether it bounds outside the surface, and not inside
  double Length = 0.0;     ///< in the model's units
};

/// Landmarks, and the mean symmetric Dirichlet energy of the maps of coarse surfaces through them.
struct HandleCandidate
{
  Landmarks Pairs;
  double Energy = 0.0;
};

/// Landmarks on the handles of two surfaces, and the loops there.
struct HandleLandmarks
{
  std::vector<HandleCandidate> Candidates; ///< at least one, that of the least energy first
  /// For each handle, a loop around it and one through its tunnel.
  std::vector<HandleLoop> LoopsOfA;
  /// The shortest loop of each surface, divided by the root of its area: noise if it is tiny.
  double ShortestOfA = 0.0, ShortestOfB = 0.0;
};

/**
 * Finds landmarks for a map through a common base of closed surfaces with handles.
 *
 * 1. Both surfaces are coarsened. On A, the shortest handle loops and tunnel loops that cross once
 *    are found, a pair for each handle (HandleLoops).
 * 2. Partners of a pair of loops are the pairs through points of B, in the directions in which they
 *    cross alike. Landmarks are at the crossing and at each third of both loops. Combinations for
 *    all handles are searched (beam search), in which loops of different handles also cross alike.
 *    As in FindLandmarks, the best ones are those whose maps of samples, by distances from the
 *    landmarks, change the distances between samples least.
 * 3. Candidates are the best combination, with and without landmarks that are near each other and
 *    with landmarks far from all others, the same added to `others`, and `others` alone. The coarse
 *    surfaces are mapped through a common base with each (MapThroughBase), and the candidates are
 *    returned in the order of the symmetric Dirichlet energies.
 *
 * a, b: of one genus from 1 to MaximumBaseGenus, equally oriented, without unused points. others:
 * landmarks that were found in another way. The result does not depend on the numbers of the
 * points. Throws InvalidInput if a surface intersects itself; SolveFailure if no candidate gives a
 * map; Aborted.
 */
HandleLandmarks FindHandleLandmarks(
  const Surface& a, const Surface& b, const Landmarks& others, const Progress& progress = {});

/**
 * Maps the surfaces through a common base by the landmarks of a candidate. Paths may run another
 * way on the given surfaces than on coarse ones, so their order by energy may differ: while there
 * is no map, or its energy is more than 1.25 times that of an isometry, the next candidate is
 * tried, of the first three, and the best map is returned. landmarks: on return, those of the map.
 * Throws the exceptions of MapThroughBase.
 */
CommonBaseMap MapByHandles(const Surface& a, const Surface& b, const HandleLandmarks& handles,
  Landmarks& landmarks, const CommonBaseOptions& options = {}, const Progress& progress = {});

} // namespace shape
