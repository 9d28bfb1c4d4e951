/**
 * @class   vtkShapeParameterize
 * @brief   map a surface onto a simple domain without flipping a triangle
 *
 * Inputs
 * - Input: for Sphere and Orbifold, a closed surface of genus 0. For Disk, a surface with one
 *   boundary loop and no handle. For FreeBoundary, a surface with one or more boundary loops.
 *   Polygons are triangulated internally. Blocks and distributed pieces are joined first, and each
 *   process gets its own pieces back.
 * - Landmarks (only for Orbifold): three or more points. The nearest points of the surface become
 *   the cones, in the same order.
 *
 * Outputs
 * - 0: the same surface with the point array `TargetPosition` (double, 3).
 * - 1: the image: the same triangles at their target positions, with `SourcePosition`. The image on
 *   an orbifold is cut open, and points on the cut have several copies at different positions.
 *   `OriginalPointId` of a copy is the index of its point in the input. In output 0,
 *   `TargetPosition` of this point is the position of the copy with the same index.
 * Both have `MapColors` (unsigned char, 3): corresponding points have the same colour.
 *
 * Facts, with the prefix Parameterize
 * - .Method: for Sphere, ConformalFlow or, if that would flip triangles, PositiveFlow or
 *   GlobalReinsertion. With AreaWeight > 0, it is GlobalReinsertion. For Disk, it is the name of
 *   the weights, and for FreeBoundary, it is BoundaryFirst. For Disk and FreeBoundary, it is
 *   the measure of Refine if the map is refined. For Orbifold, it is the name of the tile, or
 *   Hyperbolic with five or more Landmarks.
 * - .Iterations: number of iterations of the method. .ReinsertedPoints: number of points that got a
 *   new position because the method had flipped triangles around them.
 * - .MeasureBefore, .MeasureAfter: mean of the measure of Refine over the area of the surface,
 *   before and after the refinement; 0 without it. Exponential measures are lowered from the result
 *   with SymmetricDirichlet.
 * - .FlippedTriangles: 0, because a map that flips a triangle is an error.
 * - .ConformalDistortion: its mean over the area of the surface. It is 1 if all angles are
 *   preserved.
 * - .Energy: mean symmetric Dirichlet energy over the area of the surface. It is 4 if lengths are
 *   preserved. For Disk and Orbifold, the surface is first scaled to the area of the image. For
 *   Sphere, the energy is not computed and is 0.
 * - .LoopLength: for Disk and FreeBoundary, the length of the longest boundary loop, in the units
 *   of the surface; otherwise 0.
 *
 * The mathematics: shape::Parameterize.
 */
#ifndef vtkShapeParameterize_h
#define vtkShapeParameterize_h

#include "vtkShapeAlgorithm.h"

#include "Parameterize/Parameterize.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeParameterize : public vtkShapeAlgorithm
{
public:
  static vtkShapeParameterize* New();
  vtkTypeMacro(vtkShapeParameterize, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeParameterize.xml. Enumerations and defaults:
  /// shape::ParameterizeOptions.
  vtkShapeEnumOption(Domain, shape::ParameterizeOptions::DomainType,
    shape::ParameterizeOptions::DomainType::Disk, shape::ParameterizeOptions::DomainType::Orbifold);
  vtkShapeEnumOption(Weights, shape::CombinationWeights, shape::CombinationWeights::Uniform,
    shape::CombinationWeights::MeanValue);
  vtkShapeEnumOption(
    Outline, shape::DiskOutline, shape::DiskOutline::Circle, shape::DiskOutline::Square);
  vtkShapeEnumOption(Refine, shape::RefineType, shape::RefineType::None, shape::RefineType::ARAP);
  vtkShapeOption(RefineExponent, double);
  vtkShapeEnumOption(
    Tile, shape::OrbifoldType, shape::OrbifoldType::Square, shape::OrbifoldType::Triangle);
  vtkShapeOption(AreaWeight, double);
  ///@}

protected:
  vtkShapeParameterize();
  ~vtkShapeParameterize() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeParameterize(const vtkShapeParameterize&) = delete;
  void operator=(const vtkShapeParameterize&) = delete;

  shape::ParameterizeOptions Options;
};

#endif
