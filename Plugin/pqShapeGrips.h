#pragma once

/// What the handles that rotate and scale have in common. Sizes are in pixels of a standard screen.
namespace pqShapeGrips
{

constexpr double Pi = 3.14159265358979323846;
constexpr double BallPixels = 8.0, KnobPixels = 6.0, SmallestRing = 36.0, GrabPixels = 4.0;
constexpr double RingPixels = 2.0, DotPixels = 12.0;
constexpr int RingSegments = 72;
/// Maximum radius of the ring, as a share of the smaller of the view's width and height.
constexpr double LargestRing = 0.4;
/// Rotation and scaling for a key or a step of the wheel.
constexpr double KeyDegrees = 5.0, KeyFactor = 1.05;

} // namespace pqShapeGrips
