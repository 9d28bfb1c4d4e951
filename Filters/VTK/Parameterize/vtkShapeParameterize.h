/**
 * @class   vtkShapeParameterize
 * @brief   maps a surface onto a simple domain without flipping a triangle
 *
 * Input: for the Sphere and the Orbifold a closed surface of genus 0, for the Disk one with one
 * open loop and no handle, for FreeBoundary with one or more (polygons are triangulated inside).
 * Blocks and distributed pieces are joined first; each process gets its own back. Landmarks
 * (optional): for the Orbifold three or four points, whose nearest points of the surface become its
 * cones.
 *
 * Output 0: the same surface with the point array `TargetPosition` (double, 3): where each point
 * goes. Output 1: the image: the same triangles at their target positions with `SourcePosition`.
 * The Orbifold's image is cut open, as triangles: points on the cut have a copy for each place, and
 * `OriginalPointId` is the input's point; TargetPosition is the place of the copy with its number.
 *
 * Field data of both: Parameterize.Method (Sphere: ConformalFlow; where that would flip triangles,
 * PositiveFlow or GlobalReinsertion, which AreaWeight > 0 asks for. Disk: the weights;
 * FreeBoundary: BoundaryFirst; both, refined: SymmetricDirichlet. Orbifold: the tile),
 * Parameterize.Iterations, Parameterize.ReinsertedPoints (how many points needed a new place to end
 * the method's flips), Parameterize.FlippedTriangles (0: a map that flips one is an error),
 * Parameterize.ConformalDistortion (mean over the surface's area; 1 keeps every angle),
 * Parameterize.Energy (mean symmetric Dirichlet energy over the surface's area: 4 where lengths
 * stay; Disk and Orbifold: scaled to the image's area; Sphere: 0), Parameterize.LoopLength (Disk,
 * FreeBoundary: of the longest open loop, in the surface's units; else 0).
 *
 * Each factorisation is one library call: an abort takes effect at its end (within a second at
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
  /// What the surface is mapped onto. 0 = Disk: the disk in the plane z = 0, or the square, as
  /// Outline says; counter-clockwise seen from +z. 1 = Sphere: the unit sphere, centred so that the
  /// mean of the image, weighted by the surface's area, is the origin. 2 = FreeBoundary: the plane
  /// z = 0, conformal, with the surface's area (where refined, the size of least distortion),
  /// around its centroid, x its longer principal axis. 3 = Orbifold: a Tile of the plane z = 0,
  /// whose copies, turned around the cones, continue the map across the cut. Default: Sphere.
  vtkShapeEnumOption(Domain, shape::ParameterizeOptions::DomainType,
    shape::ParameterizeOptions::DomainType::Disk, shape::ParameterizeOptions::DomainType::Orbifold);
  ///@}

  ///@{
  /// Disk: each point is the mean of its neighbours, weighted: 0 = Uniform (Tutte) never flips a
  /// triangle and does not see the shape. 1 = Cotangent (harmonic) keeps angles best; where it
  /// flips triangles, which obtuse angles allow, that is an error. 2 = MeanValue never flips one
  /// and keeps angles well. Default: MeanValue.
  vtkShapeEnumOption(Weights, shape::CombinationWeights, shape::CombinationWeights::Uniform,
    shape::CombinationWeights::MeanValue);
  ///@}

  ///@{
  /// Disk: what the open loop becomes, by arc length. 0 = Circle: the unit circle, from (1, 0) at
  /// the loop's point of the greatest x on. 1 = Square: the sides of [-1, 1] x [-1, 1], from the
  /// corner (1, 1) on. Default: Circle.
  vtkShapeEnumOption(
    Outline, shape::DiskOutline, shape::DiskOutline::Circle, shape::DiskOutline::Square);
  ///@}

  ///@{
  /// Disk and FreeBoundary: 0 = None. 1 = SymmetricDirichlet: points move until lengths and areas
  /// change least (scalable locally injective mappings), and no triangle flips on the way; the
  /// Disk's outline stays. FreeBoundary starts from Tutte's map where the conformal one flips a
  /// triangle, which without Refine is an error. Default: None.
  vtkShapeEnumOption(Refine, shape::ParameterizeOptions::RefineType,
    shape::ParameterizeOptions::RefineType::None,
    shape::ParameterizeOptions::RefineType::SymmetricDirichlet);
  ///@}

  ///@{
  /// Orbifold with three Landmarks, the angles of the surface around them in the image: 0 = Square:
  /// 90, 180 and 90 degrees. 1 = Rhombus: 120 each. 2 = Triangle: 60, 120 and 180. With four
  /// Landmarks it is a parallelogram, 180 each, as conformal as can be. Default: Rhombus.
  vtkShapeEnumOption(
    Tile, shape::OrbifoldType, shape::OrbifoldType::Square, shape::OrbifoldType::Triangle);
  ///@}

  ///@{
  /// Sphere: equal areas against equal angles. 0 keeps angles alone, and shrinks limbs
  /// exponentially with their length over their girth; larger keeps areas more, so that the image
  /// of a limb stays large enough to compute on. Default: 0.
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
