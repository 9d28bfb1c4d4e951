#pragma once

#include <Eigen/Core>

#include <map>

namespace shape
{

struct MeshMaterialsOptions
{
  /// Poisson's ratio of all materials; > -1 and < 0.5.
  double PoissonRatio = 0.3;
  /// Factor from the given densities to the unit of the solver; > 0. 1e-9 converts g/cm^3 to
  /// t/mm^3, which belongs to mm, N and MPa.
  double DensityScale = 1.0;
};

/// A linear elastic material.
struct MeshMaterial
{
  double Modulus; ///< Young's modulus
  double PoissonRatio;
  double Density;
};

/// The materials of the solid cells of a mesh.
struct MeshMaterials
{
  Eigen::VectorXi OfCell; ///< the number of the material of each cell; empty: there are none
  std::map<int, MeshMaterial> ByNumber;
};

/**
 * Finds the materials of a mesh. numbers, moduli, densities: m values, those of the material of
 * each cell. Throws InvalidInput if a number is negative, a modulus is not positive or a density is
 * negative, if one is not finite, if cells of one material have different values, or if an option
 * is out of range.
 */
MeshMaterials FindMeshMaterials(const Eigen::VectorXi& numbers, const Eigen::VectorXd& moduli,
  const Eigen::VectorXd& densities, const MeshMaterialsOptions& options = {});

} // namespace shape
