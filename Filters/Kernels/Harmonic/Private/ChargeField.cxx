#include "Harmonic/Private/ChargeField.h"

#include <utility>

namespace shape
{
namespace
{

/// Charges at this many radii of a cube or more become part of the polynomial of its children.
constexpr double FarRatio = 4.0;
/// Fewer charges are not worth a polynomial of the full degree.
constexpr int WorthExpanding = 32;

} // namespace

std::shared_ptr<const ChargeField> Descend(const std::shared_ptr<const ChargeField>& field,
  const ChargeColumns& charges, const BoxCube& cube)
{
  const double radius = cube.Radius();
  std::vector<int> far, near;
  for (const int i : field->Near)
  {
    const double distance = (charges.col(i).head<3>() - cube.Centre).norm();
    (distance > FarRatio * radius ? far : near).push_back(i);
  }
  if (static_cast<int>(far.size()) < WorthExpanding)
  {
    return field;
  }
  auto inner = std::make_shared<ChargeField>();
  inner->Far = field->Far;
  inner->Far.Shift(cube.Centre - field->Centre);
  inner->Far.Add(charges, far, cube.Centre, radius, TaylorExpansion::Degree);
  inner->Centre = cube.Centre;
  inner->Near = std::move(near);
  inner->ValueError = field->ValueError + radius * (inner->Far.Remainder - field->Far.Remainder);
  inner->HighTerms = (1.0 + 1e-12) * inner->Far.BoundHighTerms(cube.Half);
  return inner;
}

} // namespace shape
