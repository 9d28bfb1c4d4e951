#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/SlidingBoundary.h"
#include "Untangle/Private/SolidCells.h"

#include <memory>

namespace shape
{

/// ReduceInverted ends after this many rounds without a new minimum of inverted cells. It ends
/// sooner if tetrahedra can be expanded, but in a star that starts anew, most rounds lower the
/// number first.
constexpr int Patience = 6, PatienceInStar = 3, PatienceBeforeExpansion = 1;

/// A solid on the way to one without inverted cells.
struct Untangling
{
  SolidCells Solid;
  std::unique_ptr<SlidingBoundary> Sliding; ///< none if the boundary is fixed
  int Expansions = 0;                       ///< points that were placed by exact tests
  int Iterations = 0;                       ///< Newton steps so far
  double Work = 0.0;                        ///< of these steps
  bool HasPatchCollar = false;              ///< whether cells are too thin for Newton's method
  // See UntangleOptions.
  int MaximumIterations = 0;
  double MaximumWork = 0.0;
  bool SplitCells = false;

  /// Whether Newton's method may make more steps.
  bool HasWork() const { return this->Work < this->MaximumWork; }
  bool IsMovable(int point) const
  {
    return !this->Solid.OnBoundary(point) || (this->Sliding && this->Sliding->Freedom(point) > 0);
  }
};

/// Minimises the energy of each patch of points around inverted cells. A patch that would have more
/// negative tetrahedra than before is not moved. Throws Aborted.
void MovePoints(Untangling& untangling, int rings, const Progress& progress);

/// Moves points and splits cells until no cell is inverted or no further progress is found. Returns
/// the number of inverted cells. patience: after how many rounds without a new minimum it ends.
/// Throws Aborted.
int ReduceInverted(Untangling& untangling, int patience, const Progress& progress);

/// Moves points, then expands clusters of the tetrahedra that stay inverted, in turn: what one
/// leaves inverted is another start for the other. Returns the number of inverted cells. patience:
/// that of the first turn (ReduceInverted). Throws Aborted.
int ReduceAndExpand(Untangling& untangling, int patience, const Progress& progress);

} // namespace shape
