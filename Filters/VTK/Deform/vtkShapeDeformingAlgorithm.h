/**
 * @class   vtkShapeDeformingAlgorithm
 * @brief   base of the filters that deform a shape by its boundary: its parameters
 *
 * All of them may be changed live: see shape::DeformOptions, and Schmidt and Singh,
 * "Drag-and-drop surface composition" (Graphics Interface 2010), section 2.
 */
#ifndef vtkShapeDeformingAlgorithm_h
#define vtkShapeDeformingAlgorithm_h

#include "vtkShapeAlgorithm.h"

#include "Deform/ShapeDeformation.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeDeformingAlgorithm : public vtkShapeAlgorithm
{
public:
  vtkTypeMacro(vtkShapeDeformingAlgorithm, vtkShapeAlgorithm);

  ///@{
  /// 0 = UpwindFront: each point relative to those just nearer to the boundary. 1 =
  /// BoundaryRelative: each point relative to the boundary alone. Default: UpwindFront.
  vtkShapeEnumOption(Method, shape::DeformOptions::MethodType,
    shape::DeformOptions::MethodType::UpwindFront,
    shape::DeformOptions::MethodType::BoundaryRelative);
  ///@}
  ///@{
  /// How strongly the shape is kept: the inverse of the power of the distance in the weights. > 0.
  /// Default: 1.
  vtkShapeOption(Rigidity, double);
  ///@}
  ///@{
  /// 0 = Uniform. 1 = Distance: more rigid far from the boundary. 2 = Curvature: more rigid where
  /// flat. Default: Uniform.
  vtkShapeEnumOption(RigidityBy, shape::DeformOptions::RigidityByType,
    shape::DeformOptions::RigidityByType::Uniform, shape::DeformOptions::RigidityByType::Curvature);
  ///@}
  ///@{
  /// How many times as rigid the most rigid points are, by distance or curvature. > 0. Default: 4.
  vtkShapeOption(RigidityContrast, double);
  ///@}
  ///@{
  /// How much larger the points farthest from the boundary become. > 0. Default: 1.
  vtkShapeOption(InnerScale, double);
  ///@}
  ///@{
  /// How far the band reaches that a point is placed by, in mean edges: a larger one pulls the
  /// shape towards the boundary. > 0. Default: 2.1.
  vtkShapeOption(UpwindRadius, double);
  ///@}
  ///@{
  /// 0 = Euclidean: stiffer. 1 = Geodesic: along the shape. Default: Euclidean.
  vtkShapeEnumOption(Distance, shape::FrontDistance, shape::FrontDistance::Euclidean,
    shape::FrontDistance::Geodesic);
  ///@}
  ///@{
  /// 0 = Automatic: above 2000 points the deformation is computed on a coarse shape, which the
  /// points follow. 1 = On. 2 = Off. Default: Automatic.
  vtkShapeEnumOption(Multiresolution, shape::DeformOptions::MultiresolutionType,
    shape::DeformOptions::MultiresolutionType::Automatic,
    shape::DeformOptions::MultiresolutionType::Off);
  ///@}

protected:
  vtkShapeDeformingAlgorithm();
  ~vtkShapeDeformingAlgorithm() override = default;

  shape::DeformOptions Options;

private:
  vtkShapeDeformingAlgorithm(const vtkShapeDeformingAlgorithm&) = delete;
  void operator=(const vtkShapeDeformingAlgorithm&) = delete;
};

#endif
