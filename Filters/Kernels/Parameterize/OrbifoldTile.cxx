#include "Parameterize/OrbifoldTile.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace shape
{
namespace
{

using Complex = std::complex<double>;

/// Returns the rotation by `turn` around `fixed`.
PlaneIsometry TurnAround(Complex fixed, Complex turn)
{
  return { turn, fixed - turn * fixed };
}

PlaneIsometry Inverse(const PlaneIsometry& motion)
{
  return { std::conj(motion.Turn), -std::conj(motion.Turn) * motion.Shift };
}

bool AreSame(const PlaneIsometry& a, const PlaneIsometry& b)
{
  constexpr double rounding = 1e-6; // different isometries of these groups differ by at least 0.1
  return std::abs(a.Turn - b.Turn) < rounding && std::abs(a.Shift - b.Shift) < rounding;
}

} // namespace

int GetConeCount(OrbifoldType type)
{
  return type == OrbifoldType::Rectangle ? 4 : 3;
}

OrbifoldTile BuildOrbifoldTile(OrbifoldType type)
{
  // The first and the last leg have an end with one position: their isometries are rotations around
  // it. Both ends of the Rectangle's middle leg have two positions: its isometry is a translation.
  const double height = std::sqrt(0.75);
  const Complex sixth(0.5, height), third(-0.5, height), quarter(0.0, 1.0), half(-1.0, 0.0);
  OrbifoldTile tile;
  tile.Type = type;
  switch (type)
  {
    case OrbifoldType::Square:
      tile.There = { 0.0, 1.0, { 1.0, 1.0 } };
      tile.Back = { 0.0, quarter, { 1.0, 1.0 } };
      tile.Legs = { TurnAround(0.0, quarter), TurnAround({ 1.0, 1.0 }, -quarter) };
      break;
    case OrbifoldType::Rhombus:
      tile.There = { 0.0, 1.0, sixth };
      tile.Back = { 0.0, third, sixth };
      tile.Legs = { TurnAround(0.0, third), TurnAround(sixth, std::conj(third)) };
      break;
    case OrbifoldType::Triangle:
      tile.There = { 0.0, 1.0, 0.5 * (1.0 + sixth) };
      tile.Back = { 0.0, sixth, 0.5 * (1.0 + sixth) };
      tile.Legs = { TurnAround(0.0, sixth), TurnAround(0.5 * (1.0 + sixth), half) };
      break;
    case OrbifoldType::Rectangle:
      tile.There = { 0.0, { 0.0, -0.5 }, { 1.0, -0.5 }, 1.0 };
      tile.Back = { 0.0, { 0.0, 0.5 }, { 1.0, 0.5 }, 1.0 };
      tile.Legs = { TurnAround(0.0, half), { 1.0, quarter }, TurnAround(1.0, half) };
      break;
  }
  return tile;
}

std::vector<PlaneIsometry> ComputeOrbifoldMotions(
  const OrbifoldTile& tile, std::complex<double> centre, double radius)
{
  std::vector<PlaneIsometry> generators;
  for (const PlaneIsometry& leg : tile.Legs)
  {
    generators.push_back(leg);
    generators.push_back(Inverse(leg));
  }
  // A generator moves a position near the tile by less than this. So every wanted isometry is
  // reached from the identity through isometries within this slack.
  constexpr double slack = 4.0;
  const auto moved = [&](const PlaneIsometry& motion) { return std::abs(motion(centre) - centre); };
  // A breadth-first search through the group.
  std::vector<PlaneIsometry> found = { PlaneIsometry() };
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    for (const PlaneIsometry& generator : generators)
    {
      const PlaneIsometry next = found[i].After(generator);
      if (moved(next) <= radius + slack &&
        std::none_of(found.begin(), found.end(),
          [&](const PlaneIsometry& other) { return AreSame(next, other); }))
      {
        found.push_back(next);
      }
    }
  }
  found.erase(std::remove_if(found.begin() + 1, found.end(),
                [&](const PlaneIsometry& motion) { return moved(motion) > radius; }),
    found.end());
  // The sort is stable: isometries of equal distance keep the order of discovery, which does not
  // depend on rounding.
  std::stable_sort(found.begin() + 1, found.end(),
    [&](const PlaneIsometry& a, const PlaneIsometry& b) { return moved(a) < moved(b) - 1e-6; });
  return found;
}

} // namespace shape
