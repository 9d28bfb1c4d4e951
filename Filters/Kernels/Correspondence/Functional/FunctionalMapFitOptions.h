#pragma once

#include "Mesh/Surface.h"
#include "Spectrum/LaplaceEigenproblem.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct FunctionalMapFitOptions
{
  /// The penalty w_L of coefficients between eigenfunctions of different eigenvalues.
  enum class MaskType
  {
    Laplacian = 0, ///< commutativity with the Laplacians, which is strict for large eigenvalues
    Resolvent = 1  ///< commutativity with their resolvents, which treats all eigenvalues alike
  };
  MaskType Mask = MaskType::Laplacian;
  int Size = 30;                  ///< eigenfunctions of each surface; >= 1
  double LaplacianWeight = 1e-2;  ///< w_L: commutativity with the Laplacians; >= 0
  double DescriptorWeight = 1e-1; ///< w_D: commutativity with multiplication by descriptors; >= 0
  /// w_O: commutativity with the descriptors' rotated gradients; >= 0.
  double OrientationWeight = 1e-2;
  double CurveWeight = 0.0; ///< w_K: commutativity with multiplication by curves; >= 0
  /// w_N: commutativity with the change of the Laplacians under a displacement; >= 0.
  double DisplacementWeight = 0.0;
  /// The displacement along the normals, of surfaces of area 1, or the factor of given vectors; 0:
  /// the rate of change; >= 0.
  double Displacement = 0.0;
  /// w_C: how strongly each of the two maps preserves inner products; >= 0.
  double OrthonormalityWeight = 0.0;
  /// w_I: how strongly the two maps are inverse to each other; >= 0.
  double InverseWeight = 0.0;
  /// A number n >= 1: only every n-th computed descriptor gives operators, since consecutive ones
  /// are similar. Each given descriptor does.
  int OperatorStride = 5;
};

/// A surface, its spectrum, and functions of its points that are invariant under bending.
struct SurfaceDescriptors
{
  shape::Surface Surface;
  const LaplaceEigenpairs& Spectrum;
  const Eigen::MatrixXd& Descriptors; ///< n x q
  /// How many of the descriptors, the last ones, are given and not computed.
  Eigen::Index Given = 0;
  std::vector<std::vector<int>> Curves; ///< the points of each curve
  /// n x 3: the vectors along which the points are displaced; empty: the unit normals.
  Eigen::MatrixXd Displacements = {};
};

} // namespace shape
