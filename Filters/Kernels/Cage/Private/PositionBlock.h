#pragma once

namespace shape
{

/// Positions that are evaluated at once, a lane of a vector each.
struct PositionBlock
{
  static constexpr int Size = 8;
  double Points[3][Size]; ///< their coordinates
  double Near[3][Size];   ///< the step of the closest point of the cage
};

/// Their displacements.
struct StepBlock
{
  double Steps[3][PositionBlock::Size];
};

/// The gradients of their displacements, in rows.
struct SlopeBlock
{
  double Slopes[9][PositionBlock::Size];
};

} // namespace shape
