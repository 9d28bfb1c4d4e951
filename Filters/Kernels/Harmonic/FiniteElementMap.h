#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Search/CellLocator.h"

#include <Eigen/Core>

#include <limits>

namespace shape
{

/// A map of a solid that is linear in each tetrahedron.
struct FiniteElements
{
  Eigen::MatrixXd Points = Eigen::MatrixXd(0, 3);     ///< k x 3
  Eigen::MatrixXi Tetrahedra = Eigen::MatrixXi(0, 4); ///< m x 4
  Eigen::MatrixXd Images = Eigen::MatrixXd(0, 3);     ///< k x 3: the values of the map
  /// m' x 3: the triangles of the solid's surface, which face outwards
  Eigen::MatrixXi Boundary = Eigen::MatrixXi(0, 3);
  int FreePoints = 0; ///< number of points inside: the unknowns
};

/**
 * Computes the harmonic map of a solid from given values on its boundary, by linear finite elements
 * on tetrahedra: the map of least Dirichlet energy among those that are linear in each tetrahedron
 * (Wang, Gu, Chan, Thompson and Yau, "Volumetric harmonic brain mapping", 2004; the variational
 * approach with which Li et al. 2010 compare theirs, section 2).
 *
 * The edge of two points has the cotangent weight sum |e| cot(angle) / 6 over the tetrahedra around
 * it, where e is the opposite edge of a tetrahedron and the angle that of the faces which meet
 * there. The matrix is factorised once for all coordinates. The boundary values are met exactly:
 * they are linear in each triangle of `boundary`. Affine maps are reproduced to rounding. For
 * smooth values the error falls with the square of the size of the tetrahedra, if the triangles of
 * the boundary become smaller, too.
 *
 * boundary: the closed surface around a solid and its voids, facing either way. values: n x d, at
 * its points. tetrahedra: their approximate number, > 0. There are more if the boundary has many
 * triangles. Points are added on the triangles, too. The result does not depend on the numbering of
 * the boundary.
 *
 * Throws InvalidInput if the surface is not closed or its components touch, a value is not finite,
 * or `tetrahedra` is not positive; the exceptions of Tetrahedralize, SolveFailure of
 * SparseCholesky, and Aborted.
 */
FiniteElements ComputeFiniteElements(const Surface& boundary, const Eigen::MatrixXd& values,
  int tetrahedra, const Progress& progress = {});

/// Fills a solid with tetrahedra as ComputeFiniteElements does. Images has the values at the
/// boundary, and 0 inside. preserveBoundary, maximumNewPoints: as in TetrahedralizeOptions. Throws
/// what ComputeFiniteElements throws.
FiniteElements FillWithElements(const Surface& boundary, const Eigen::MatrixXd& values,
  int tetrahedra, bool preserveBoundary, int maximumNewPoints, const Progress& progress = {});

/// Sets the images of the points that are not `fixed` (ascending) such that the Dirichlet energy is
/// least. Throws SolveFailure of SparseCholesky, and Aborted.
void SolveLaplace(
  FiniteElements& elements, const std::vector<int>& fixed, const Progress& progress = {});

/// Returns the faces of only one tetrahedron, facing outwards: k x 3, sorted.
Eigen::MatrixXi FindBoundaryTriangles(const FiniteElements& elements);

/// Evaluates a map of finite elements anywhere. Can be used from several threads.
class FiniteElementMap
{
public:
  /// Throws InvalidInput if there are no tetrahedra, or an index or the number of images is wrong;
  /// Aborted.
  explicit FiniteElementMap(FiniteElements elements, const Progress& progress = {});

  const FiniteElements& Elements() const { return this->Data; }

  struct Values
  {
    Eigen::MatrixXd Images;    ///< n x d: outside, of the closest point of the solid
    Eigen::VectorXi Cells;     ///< n: the tetrahedron of each point; -1 if it is too far
    Eigen::VectorXd Distances; ///< n: 0 inside, else the distance from the solid
  };
  /// Interpolates linearly in the tetrahedron that contains each point (n x 3, finite). A point
  /// farther from the solid than `farthest` has the image 0 and an infinite distance. Throws
  /// Aborted.
  Values Evaluate(const Eigen::MatrixXd& points, const Progress& progress = {},
    double farthest = std::numeric_limits<double>::infinity()) const;

  /// The derivative of the map in each of the given tetrahedra: n x 3 d, with the gradient of
  /// image coordinate r in columns 3 r to 3 r + 2.
  Eigen::MatrixXd Jacobians(const Eigen::VectorXi& cells, const Progress& progress = {}) const;

  /// Returns the map from the images to the points. Where the map folds, a point has several
  /// preimages; its Evaluate always finds the same one. Needs images of three coordinates.
  FiniteElementMap Inverse(const Progress& progress = {}) const;

private:
  FiniteElements Data;
  CellLocator Locator;
};

} // namespace shape
