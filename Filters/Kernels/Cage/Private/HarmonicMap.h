#pragma once

#include "Cage/Private/CageMap.h"
#include "Mesh/Surface.h"
#include "Search/CellLocator.h"

#include <memory>

namespace shape
{

/// Harmonic coordinates (CageDeform.h): displacements that are harmonic in the cage, on tetrahedra.
class HarmonicMap : public CageMap
{
public:
  /// cage: its longest side is 1. steps: the displacement of each point (n x 3). tetrahedra: their
  /// approximate number. Throws what Tetrahedralize throws.
  HarmonicMap(
    const Surface& cage, const Eigen::MatrixXd& steps, int tetrahedra, const Progress& progress);
  CageMotion Evaluate(const CagePositions& positions, const Progress& progress) const override;

  int GetTetrahedra() const { return static_cast<int>(this->Tetrahedra.rows()); }

private:
  Eigen::MatrixXd Points;     ///< k x 3
  Eigen::MatrixXi Tetrahedra; ///< m x 4
  Eigen::MatrixXd Steps;      ///< k x 3: the solution
  std::unique_ptr<CellLocator> Locator;
};

} // namespace shape
