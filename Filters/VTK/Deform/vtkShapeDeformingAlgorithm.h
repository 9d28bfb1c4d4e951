/**
 * @class   vtkShapeDeformingAlgorithm
 * @brief   base of the filters that deform a shape by its boundary: its parameters
 *
 * All these parameters may be changed interactively. The source is Schmidt and Singh,
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
  /// The properties. Effects and ranges: vtkShapeDeformingAlgorithm.xml. Enumerations and
  /// defaults: shape::DeformOptions.
  vtkShapeEnumOption(Method, shape::DeformOptions::MethodType,
    shape::DeformOptions::MethodType::UpwindFront,
    shape::DeformOptions::MethodType::BoundaryRelative);
  vtkShapeOption(Rigidity, double);
  vtkShapeEnumOption(RigidityBy, shape::DeformOptions::RigidityByType,
    shape::DeformOptions::RigidityByType::Uniform, shape::DeformOptions::RigidityByType::Curvature);
  vtkShapeOption(RigidityContrast, double);
  vtkShapeOption(InnerScale, double);
  vtkShapeOption(UpwindRadius, double);
  vtkShapeEnumOption(Distance, shape::FrontDistance, shape::FrontDistance::Euclidean,
    shape::FrontDistance::Geodesic);
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
