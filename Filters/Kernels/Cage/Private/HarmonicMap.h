#pragma once

#include "Cage/Private/CageMap.h"
#include "Harmonic/FiniteElementMap.h"
#include "Mesh/Surface.h"

namespace shape
{

/// Harmonic coordinates (CageDeform.h): displacements that are harmonic in the cage, on tetrahedra.
class HarmonicMap : public CageMap
{
public:
  /// cage: its longest side is 1. steps: the displacement of each point (n x 3). tetrahedra: their
  /// approximate number. Throws what ComputeFiniteElements throws.
  HarmonicMap(
    const Surface& cage, const Eigen::MatrixXd& steps, int tetrahedra, const Progress& progress);
  CageMotion Evaluate(const CagePositions& positions, const Progress& progress) const override;

  int GetTetrahedra() const { return static_cast<int>(this->Map.Elements().Tetrahedra.rows()); }

private:
  FiniteElementMap Map; ///< its images are displacements
};

} // namespace shape
