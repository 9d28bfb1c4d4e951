/**
 * @class   vtkShapeParameterize
 * @brief   map a surface onto a simple domain without flipping a triangle
 *
 * Inputs
 * - Input: for Sphere and Orbifold a closed surface of genus 0, for Disk a surface with one
 *   boundary loop and no handle, for FreeBoundary one or more boundary loops. Polygons are
 *   triangulated internally. Blocks and distributed pieces are joined first, and each process gets
 *   its own back.
 * - Landmarks (optional): for Orbifold three or four points, whose nearest points of the surface
 *   become its cones.
 *
 * Outputs
 * - 0: the same surface with the point array `TargetPosition` (double, 3).
 * - 1: the image: the same triangles at their target positions with `SourcePosition`. The image on
 *   an orbifold is cut open. Points on the cut have one copy for each position. `OriginalPointId`
 *   of a copy is its point of the input. `TargetPosition` of that point is the position of the
 *   copy that has the same number as the point.
 *
 * Field data of both, with the prefix Parameterize
 * - .Method: ConformalFlow for Sphere, or PositiveFlow or GlobalReinsertion, if the former would
 *   flip triangles or AreaWeight > 0 requires the latter. For Disk it is the weights, and for
 *   FreeBoundary BoundaryFirst; both become SymmetricDirichlet if the map is refined. For Orbifold
 *   it is the tile.
 * - .Iterations. .ReinsertedPoints: points that needed a new position to remove flips of the
 *   method.
 * - .FlippedTriangles: 0, because a map that flips a triangle is an error.
 * - .ConformalDistortion: mean over the area of the surface, 1 if all angles are preserved.
 * - .Energy: mean symmetric Dirichlet energy over the area of the surface, 4 where lengths are
 *   preserved. For Disk and Orbifold it is scaled to the area of the image, for Sphere it is 0.
 * - .LoopLength: for Disk and FreeBoundary the length of the longest boundary loop, in the units
 *   of the surface, otherwise 0.
 *
 * A factorisation cannot be interrupted, so an abort takes effect at its end (within a second at
 * 100,000 points).
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
  vtkShapeEnumOption(Refine, shape::ParameterizeOptions::RefineType,
    shape::ParameterizeOptions::RefineType::None,
    shape::ParameterizeOptions::RefineType::SymmetricDirichlet);
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
