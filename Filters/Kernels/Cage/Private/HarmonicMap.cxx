#include "Cage/Private/HarmonicMap.h"

#include <utility>

namespace shape
{

HarmonicMap::HarmonicMap(
  const Surface& cage, const Eigen::MatrixXd& steps, int tetrahedra, const Progress& progress)
  : Map(ComputeFiniteElements(cage, steps, tetrahedra, progress.Part(0.0, 0.9)),
      progress.Part(0.9, 1.0))
{
}

CageMotion HarmonicMap::Evaluate(const CagePositions& positions, const Progress& progress) const
{
  FiniteElementMap::Values found = this->Map.Evaluate(positions.Points, progress.Part(0.0, 0.9));
  CageMotion motion{ std::move(found.Images), Eigen::MatrixXd(0, 9) };
  if (positions.GradientAt.rows() > 0)
  {
    motion.Gradients = this->Map.Jacobians(found.Cells, progress.Part(0.9, 1.0));
  }
  progress(1.0);
  return motion;
}

} // namespace shape
