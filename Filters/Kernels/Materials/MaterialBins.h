#pragma once

#include <Eigen/Core>

namespace shape
{

/// What the materials of a mesh are: bins of equal relative width of the modulus. Bins of several
/// parts of a mesh are made with a common range, and their sums are added.
class MaterialBins
{
public:
  /// Divides [minimum, maximum] into `count` bins; 0 < minimum <= maximum. Throws InvalidInput if
  /// count < 1.
  MaterialBins(double minimum, double maximum, int count);

  /// Returns the bin of a modulus in the range, from 0.
  int FindBin(double modulus) const;

  /// Adds cells to the sums. own: m values; cells with 0, such as ghosts, are left out. Empty: all
  /// cells count.
  void Add(const Eigen::VectorXd& modulus, const Eigen::VectorXd& density,
    const Eigen::VectorXd& volumes, const Eigen::VectorXi& own = {});

  /// The sums over each bin, in its columns: of volume times modulus, volume times density, volume,
  /// and number of cells.
  Eigen::MatrixXd Sums;

private:
  double Minimum, Scale;
};

/**
 * The materials: bins that have cells, numbered from 0 by ascending modulus.
 *
 * The modulus and the density of a material are the means of its cells, weighted by volume. So the
 * integrals of both over the mesh are those of the cells.
 */
struct Materials
{
  Eigen::VectorXi OfBin; ///< the material of each bin, or -1
  Eigen::VectorXd Modulus, Density, Volume, Cells;
};

Materials FindMaterials(const MaterialBins& bins);

} // namespace shape
