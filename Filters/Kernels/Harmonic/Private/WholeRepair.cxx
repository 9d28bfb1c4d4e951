#include "Harmonic/Private/WholeRepair.h"

#include "Base/Errors.h"
#include "Harmonic/Private/CorePart.h"

#include <numeric>
#include <utility>

namespace shape
{

MapRepair RepairWhole(const ChargeSet& map, const Surface& domain, const Eigen::MatrixXd& images,
  const Progress& progress)
{
  constexpr double maximumWork = 8e7; // of Newton's method (UntangleOptions)
  CorePart part;
  try
  {
    // One tetrahedron means that their volume has no limit. No point is added on the boundary.
    part.Elements = FillWithElements(domain, images, 1, true,
      10 * static_cast<int>(domain.Points().rows()), progress.Part(0.0, 0.2));
  }
  catch (const SolveFailure&)
  {
    return {};
  }
  FiniteElements& elements = part.Elements;
  Eigen::MatrixXd values = Evaluate(map, elements.Points, progress.Part(0.2, 0.3));
  for (const int point : elements.Boundary.reshaped())
  {
    values.row(point) = elements.Images.row(point);
  }
  elements.Images = std::move(values);
  part.Points.resize(elements.Points.rows());
  std::iota(part.Points.begin(), part.Points.end(), 0);
  UntanglePart(part, maximumWork, progress.Part(0.3, 1.0));
  if (!part.IsUntangled)
  {
    return {};
  }
  const Eigen::Index count = elements.Points.rows();
  return { { std::move(elements.Points), std::move(elements.Tetrahedra),
             std::move(elements.Images) },
    Eigen::VectorXd::Zero(count) };
}

} // namespace shape
