/**
 * @class   vtkShapeParameterize
 * @brief   maps a surface onto a simple domain without flipping a triangle
 *
 * Input: a closed surface of genus 0 (polygons are triangulated inside). Blocks and distributed
 * pieces are joined first; each process gets its own back.
 *
 * Output 0: the same surface with the point array `TargetPosition` (double, 3): where each point
 * goes. Output 1: the image: the same triangles at their target positions with `SourcePosition`.
 *
 * Field data of both: Parameterize.Method (ConformalFlow; where that would flip triangles,
 * PositiveFlow or GlobalReinsertion, which AreaWeight > 0 asks for), Parameterize.Iterations,
 * Parameterize.ReinsertedPoints (how many points needed a new place to end the method's flips),
 * Parameterize.ConformalDistortion (mean over the surface's area; 1 keeps every angle).
 *
 * The mathematics: shape::Parameterize.
 */
#ifndef vtkShapeParameterize_h
#define vtkShapeParameterize_h

#include "vtkShapeAlgorithm.h"

#include "Surface/Parameterize.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeParameterize : public vtkShapeAlgorithm
{
public:
  static vtkShapeParameterize* New();
  vtkTypeMacro(vtkShapeParameterize, vtkShapeAlgorithm);

  ///@{
  /// What the surface is mapped onto. 1 = Sphere: the unit sphere, centred so that the mean of the
  /// image, weighted by the surface's area, is the origin. Default: Sphere.
  vtkShapeEnumOption(Domain, shape::ParameterizeOptions::DomainType,
    shape::ParameterizeOptions::DomainType::Sphere, shape::ParameterizeOptions::DomainType::Sphere);
  ///@}

  ///@{
  /// Equal areas against equal angles. 0 keeps angles alone, and shrinks limbs exponentially with
  /// their length over their girth; larger keeps areas more, so that the image of a limb stays
  /// large enough to compute on. Default: 0.
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
