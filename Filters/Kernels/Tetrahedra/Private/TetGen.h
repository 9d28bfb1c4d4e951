#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

namespace shape
{

/// The input of TetGen.
struct TetGenInput
{
  const Mesh& Surfaces;          ///< facets over distinct points, all used; none cross each other
  const Eigen::MatrixXd& Holes;  ///< n x 3: a position in each void
  double MaximumRadiusEdgeRatio; ///< > 1, or 0 for none
  double MaximumVolume;          ///< bound on the volume of a tetrahedron; 0 for none
  bool PreserveBoundary;         ///< no new points on the facets
  int MaximumNewPoints;          ///< refinement stops at this number even if bounds are not met
};

/// The output of TetGen.
struct TetGenOutput
{
  Eigen::MatrixXd Points;     ///< n x 3: those of the facets first
  Eigen::MatrixXi Tetrahedra; ///< m x 4, all of the same orientation
  Eigen::MatrixXi Faces;      ///< k x 3: the faces of tetrahedra that lie on facets
};

/**
 * Runs TetGen (Hang Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator", 2015).
 *
 * TetGen 1.5 asserts, crashes or loops on some inputs. It therefore runs in a forked copy of this
 * process that shares only a pipe with it, so a crash ends only the copy, and an abort kills it.
 * Throws InvalidInput if ShapeMap was built without TetGen or TetGen rejects the input. Throws
 * SolveFailure if TetGen gives up or crashes; Aborted within 0.2 s.
 */
TetGenOutput RunTetGen(const TetGenInput& input, const Progress& progress = {});

} // namespace shape
