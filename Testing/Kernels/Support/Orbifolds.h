#pragma once

#include "Parameterize/OrbifoldTutte.h"

#include <vector>

// What the tests of maps to orbifolds share.
namespace shapetest
{

constexpr shape::OrbifoldType AllOrbifolds[] = { shape::OrbifoldType::Square,
  shape::OrbifoldType::Rhombus, shape::OrbifoldType::Triangle, shape::OrbifoldType::Rectangle };

/// Corners of an icosahedron, none beside another but the last.
inline std::vector<int> ConesOnIcosphere(shape::OrbifoldType type)
{
  return shape::GetConeCount(type) == 3 ? std::vector<int>{ 0, 4, 8 }
                                        : std::vector<int>{ 0, 4, 8, 2 };
}

} // namespace shapetest
