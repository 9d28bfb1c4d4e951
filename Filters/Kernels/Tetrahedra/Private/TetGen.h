#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

namespace shape
{

/// The input of TetGen.
struct TetGenInput
{
  const Mesh& Surfaces;          ///< triangles that do not cross; all points are distinct and used
  const Eigen::MatrixXd& Holes;  ///< n x 3: a position in each void
  double MaximumRadiusEdgeRatio; ///< > 1, or 0 for no bound
  double MaximumVolume;          ///< upper bound on the volume of a tetrahedron; 0 for no bound
  bool PreserveBoundary;         ///< whether no points are added on the triangles
  int MaximumNewPoints;          ///< refinement stops at this number, even if a bound is not met
  int MaximumSeconds;            ///< of processor time
};

/// The output of TetGen.
struct TetGenOutput
{
  Eigen::MatrixXd Points;     ///< n x 3: first the points of Surfaces, then the new ones
  Eigen::MatrixXi Tetrahedra; ///< m x 4, all of the same orientation
  Eigen::MatrixXi Faces;      ///< k x 3: the faces of tetrahedra that lie on Surfaces
};

/**
 * Runs TetGen (Hang Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator", 2015).
 *
 * On some inputs, TetGen 1.5 fails an assertion, crashes or never ends. It therefore runs in a
 * forked copy of this process, which is connected to this process by a pipe only. A crash ends only
 * the copy, and an abort kills it. Throws InvalidInput if ShapeMap was built without TetGen, or if
 * TetGen rejects the input. Throws SolveFailure if TetGen gives up, crashes or needs too long;
 * Aborted within 0.2 s.
 */
TetGenOutput RunTetGen(const TetGenInput& input, const Progress& progress = {});

} // namespace shape
