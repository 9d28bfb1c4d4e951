#include "IO/MeshMaterials.h"

#include "Base/Errors.h"

#include <cmath>
#include <string>

namespace shape
{

MeshMaterials FindMeshMaterials(const Eigen::VectorXi& numbers, const Eigen::VectorXd& moduli,
  const Eigen::VectorXd& densities, const MeshMaterialsOptions& options)
{
  RequireOption(options.PoissonRatio > -1.0 && options.PoissonRatio < 0.5, "PoissonRatio",
    options.PoissonRatio, "greater than -1 and less than 0.5");
  RequireOption(options.DensityScale > 0.0 && std::isfinite(options.DensityScale), "DensityScale",
    options.DensityScale, "positive");
  MeshMaterials materials;
  materials.OfCell = numbers;
  for (Eigen::Index cell = 0; cell < numbers.size(); ++cell)
  {
    const std::string where = " at cell " + std::to_string(cell);
    const double modulus = moduli(cell), density = densities(cell);
    if (numbers(cell) < 0)
    {
      throw InvalidInput("MaterialId is " + std::to_string(numbers(cell)) + where +
        "; number materials from 0, or remove the array with Pass Arrays");
    }
    if (!(modulus > 0.0) || !std::isfinite(modulus) || !(density >= 0.0) || !std::isfinite(density))
    {
      throw InvalidInput("MaterialModulus is " + std::to_string(modulus) +
        " and MaterialDensity is " + std::to_string(density) + where +
        "; a modulus is positive, and a density is not negative: correct them in Shape Image "
        "Values, or remove the arrays with Pass Arrays");
    }
    const MeshMaterial material = { modulus, options.PoissonRatio, options.DensityScale * density };
    const auto [known, isNew] = materials.ByNumber.emplace(numbers(cell), material);
    if (!isNew && (known->second.Modulus != modulus || known->second.Density != material.Density))
    {
      throw InvalidInput("cells of MaterialId " + std::to_string(numbers(cell)) +
        " have different values of MaterialModulus or MaterialDensity (first" + where +
        "); compute the materials of all parts of the mesh in one run of Shape Image Values");
    }
  }
  return materials;
}

} // namespace shape
