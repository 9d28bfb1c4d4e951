#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <memory>

namespace shape
{

/// What carries the motion of a cage to a position.
enum class CageCoordinates
{
  MeanValue, ///< everywhere in space, continuous across the cage
  Harmonic,  ///< inside: Laplace's equation on tetrahedra; never negative between boundary values
  Green      ///< inside: also the motion of normals, so that shapes are preserved
};

struct CageDeformOptions
{
  CageCoordinates Coordinates = CageCoordinates::MeanValue;

  /// Harmonic: the approximate number of tetrahedra inside the cage: 1,000 to 100,000,000. It is
  /// larger if the cage has many triangles. The error falls with its power 2/3. With the default,
  /// it is at most about 1e-3 of the size of a motion like x^2 - y^2 across the cage.
  int Tetrahedra = 200000;

  /// Green: whether affine motions are reproduced. If false, the cage's triangles alone determine
  /// how normals are stretched, and only similarities are reproduced. If true, this is done for the
  /// difference to the cage's best affine motion, so that shear and uneven scaling of the whole
  /// cage apply to the whole shape. The best affine motion must be invertible.
  bool ReproduceAffine = false;

  /// Whether the gradient of the map is computed.
  bool DeformationGradient = false;
};

/// Positions that a cage has moved.
struct CageMovedPoints
{
  Eigen::MatrixXd Points;        ///< n x 3
  Eigen::VectorXi OutsideDomain; ///< n: 1 if the point lies outside and is not moved, else 0
  /// n x 9 with DeformationGradient, otherwise empty: d y_0 / d x_0, d y_0 / d x_1, ... in rows of
  /// the gradient of the position y by x; the identity at points that are not moved.
  Eigen::MatrixXd Gradients;
};

/**
 * The deformation of space by a cage: a closed surface whose points move. Its triangles must not
 * cross each other.
 *
 * - MeanValue (Ju, Schaefer and Warren, "Mean value coordinates for closed triangular meshes",
 *   2005): y(x) = sum_i w_i y_i / sum_i w_i. Affine motions are reproduced inside and outside, up
 *   to rounding. The map is smooth off the cage, and follows the cage on it. Coordinates may be
 *   negative where the cage is not convex, and outside. There, rounding grows with the cube of the
 *   distance, so points farther away than 100 times the size of the cage are not moved.
 * - Harmonic (Joshi et al., "Harmonic coordinates for character articulation", 2007): each
 *   coordinate is the solution of Laplace's equation with the values of the cage on the boundary,
 *   by linear finite elements on tetrahedra. Affine motions are reproduced up to rounding, and the
 *   map follows the cage on it. The gradient is constant in each tetrahedron.
 * - Green (Lipman, Levin and Cohen-Or, "Green coordinates", 2008): y(x) = sum_i phi_i y_i +
 *   sum_j psi_j s_j n_j, where n_j is the normal of a moved triangle, and s_j its mean stretch.
 *   Exactly the similarities are reproduced: for another affine motion A, Green's identity needs
 *   A n instead of s_j n_j (see ReproduceAffine). The map does not follow the cage on the cage
 *   itself, except for these motions.
 *
 * Harmonic and Green are defined in the cage. Points up to 1e-6 of the size of the cage outside
 * move as the closest point of the cage does, and points farther outside are not moved. At points
 * on the cage, gradients are those just inside; at its edges, those in one of the triangles.
 * Evaluation takes O(points * triangles) time, for Harmonic O(points), and memory for points and
 * cage.
 */
class CageDeformer
{
public:
  /**
   * cage: closed; its components may be voids of others, and face anywhere. moved: a row for each
   * point of the cage, its new position.
   *
   * Throws InvalidInput if the cage is not closed, has triangles without area or components that
   * touch, or `moved` has another number of rows or is not finite, or an option is out of range.
   * With Green, throws it if a moved cage is flat and affine motions are reproduced. With Harmonic,
   * throws what Tetrahedralize throws: the cage must not cross itself, and ShapeMap must have been
   * built with TetGen. Throws Aborted.
   */
  CageDeformer(const Surface& cage, const Eigen::MatrixXd& moved,
    const CageDeformOptions& options = {}, const Progress& progress = {});
  ~CageDeformer();
  CageDeformer(CageDeformer&&) noexcept;
  CageDeformer& operator=(CageDeformer&&) noexcept;

  /// Moves points (n x 3). Throws InvalidInput if one is not finite; Aborted.
  CageMovedPoints Evaluate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// The number of tetrahedra of Harmonic, otherwise 0.
  int GetTetrahedra() const;

private:
  struct Data;
  std::unique_ptr<Data> Impl;
};

} // namespace shape
