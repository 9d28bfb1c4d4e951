#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace shape
{

/**
 * A stroke of a brush over a surface.
 *
 * The weight of a point p for a position c of the stroke is w = (1 - (d / Radius)^2)^2 with the
 * straight distance d = |p - c| if d < Radius, and otherwise 0. It is also 0 unless edges connect p
 * with the triangle closest to c without leaving the ball around c. So a brush on one side of a
 * thin part does not paint the other side. Unlike distances along the surface, d does not depend on
 * the triangles, is exact, and costs only the points in the ball. Where the least radius of
 * curvature is R, it is shorter than the distance along the surface by a fraction of about
 * (d / R)^2 / 24.
 */
struct BrushStroke
{
  enum class ModeType
  {
    Set,   ///< v becomes v + Strength w (Value - v), with the maximum w over all positions
    Add,   ///< v becomes v + Strength w Value, with the maximum w over all positions
    Smooth ///< at each position in turn, v becomes v + Strength w (mean - v)
  };
  ModeType Mode = ModeType::Set;
  double Radius = 1.0;       ///< in the units of the surface; positive
  double Strength = 1.0;     ///< in [0, 1]
  double Value = 1.0;        ///< not used by Smooth
  Eigen::MatrixXd Positions; ///< k x 3, on the surface or near it, in their order
};

/**
 * Values at the points of a surface, changed by strokes.
 *
 * Set and Add act once in each stroke, however slowly the brush moves. The mean of Smooth is that
 * of the values in the ball, weighted by w and the area of each point: a third of its triangles.
 * Smooth leaves the integral of the values over the surface unchanged, up to rounding. Repeated at
 * one position, it makes the values in the ball equal to their mean. Coincident points are
 * connected, so that strokes cross seams. A point of no triangle is never painted.
 */
class SurfacePainter
{
public:
  /// surface: any triangles. initial: n values, one for each point. Throws InvalidInput if there is
  /// no triangle, an index is out of range, a coordinate or a value is not finite, or the number of
  /// values differs from the number of points.
  SurfacePainter(const Surface& surface, Eigen::VectorXd initial);
  ~SurfacePainter();
  SurfacePainter(SurfacePainter&&) noexcept;
  SurfacePainter& operator=(SurfacePainter&&) noexcept;

  /// Returns the initial values as changed by the strokes, in their order (n). If the strokes begin
  /// with those of the last call, or add positions to the last one of them, only what is new is
  /// computed; the result is the same bits. Throws InvalidInput if a stroke is not as BrushStroke
  /// says; Aborted.
  const Eigen::VectorXd& Paint(
    const std::vector<BrushStroke>& strokes, const Progress& progress = {});

private:
  struct Canvas;
  std::unique_ptr<Canvas> Impl;
};

/// Returns SurfacePainter(surface, initial).Paint(strokes, progress).
Eigen::VectorXd PaintArray(const Surface& surface, Eigen::VectorXd initial,
  const std::vector<BrushStroke>& strokes, const Progress& progress = {});

} // namespace shape
