#pragma once

#include "Base/Errors.h"
#include "Base/Progress.h"
#include "Fill/FillHoles.h"
#include "Mesh/Surface.h"
#include "Mesh/TouchingSheets.h"
#include "Solidify/MendedSurface.h"
#include "Solidify/Private/SoupRepair.h"
#include "Solidify/SurfaceDefects.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// Returns "(x, y, z)", for messages.
std::string DescribePosition(const Eigen::RowVector3d& position);

/// A draft without edges of several triangles, oriented, with holes.
struct OrientedDraft
{
  MendedDraft Draft;
  ///@{
  /// See MendedSurface.
  int SplitPoints = 0;
  int ReversedTriangles = 0;
  int RemovedTriangles = 0;
  int RemovedPieces = 0;
  ///@}
};

/// Does the steps 1 to 3 of MendSurface. Throws InvalidInput if no triangle is left, or under the
/// conditions of JoinSoup and SeparateSheets; Aborted.
OrientedDraft DraftSurface(
  const Mesh& surface, const SurfaceDefectOptions& options, const Progress& progress);

/// Thrown if triangles, or parts of them, enclose nothing: no other way to fill them is better.
class NoSolid : public InvalidInput
{
public:
  using InvalidInput::InvalidInput;
};

/// Throws NoSolid if sheets (see MendSurface) make up a tenth of the area of a surface or more.
void RequireNoSheets(const Mesh& surface);

/// A draft whose holes are filled. Its triangles come first, then the fills.
struct ClosedDraft
{
  MendedDraft Draft;       ///< before
  FilledSurface Filled;    ///< the draft and the fills
  SplitSheets Split;       ///< without points where fans touch
  std::vector<int> Points; ///< the points of Split that are used
  Surface Result;          ///< with these points, and copies of a point apart

  /// Number of copies of points.
  int SplitPoints() const
  {
    return static_cast<int>(this->Split.Copied.size() - this->Filled.Surface.Points.rows());
  }
};

/// Fills the holes of a draft. The result is a closed manifold, but may intersect itself. Throws
/// InvalidInput if the boundary forms no loops, or if a triangle has no area; SolveFailure if a
/// hole cannot be filled; Aborted.
ClosedDraft CloseDraft(MendedDraft draft, const Progress& progress);

/// Returns the provenance of `closed.Result` from the surface that was drafted. points: the number
/// of its points.
Provenance TraceClosing(const ClosedDraft& closed, Eigen::Index points);

/// Compares triangles with those of the input from which they come. Returns their TriangleOrigin.
/// isMade: for each triangle, whether it is new.
Eigen::VectorXi FindOrigins(const Mesh& mended, const Mesh& input, const Eigen::VectorXi& cells,
  const std::vector<char>& isMade);

} // namespace shape
