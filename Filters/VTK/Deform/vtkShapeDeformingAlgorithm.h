/**
 * @class   vtkShapeDeformingAlgorithm
 * @brief   base of the filters that deform a shape by its boundary: its parameters
 *
 * RigidityArray, ScaleArray and SegmentArray are arrays of the shape that is deformed. They are
 * properties of the filters whose shape is an input (vtkShapeFieldOptions); the disk that fills a
 * hole has no arrays.
 *
 * All these parameters may be changed interactively. The source is Schmidt and Singh,
 * "Drag-and-drop surface composition" (Graphics Interface 2010), section 2.
 */
#ifndef vtkShapeDeformingAlgorithm_h
#define vtkShapeDeformingAlgorithm_h

#include "vtkShapeAlgorithm.h"

#include "Deform/HandleFrames.h"     // for the options
#include "Deform/ShapeDeformation.h" // for the options

#include <string> // for array names

class vtkDataSet;

/// Set/Get the names of the arrays of the deformed shape.
#define vtkShapeFieldOptions()                                                                     \
  vtkSetStdStringFromCharMacro(RigidityArray);                                                     \
  vtkGetCharFromStdStringMacro(RigidityArray);                                                     \
  vtkSetStdStringFromCharMacro(ScaleArray);                                                        \
  vtkGetCharFromStdStringMacro(ScaleArray);                                                        \
  vtkSetStdStringFromCharMacro(SegmentArray);                                                      \
  vtkGetCharFromStdStringMacro(SegmentArray)

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
  vtkShapeOption(IntegrateCurves, bool);
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
  vtkShapeEnumOption(SegmentBy, shape::DeformOptions::SegmentByType,
    shape::DeformOptions::SegmentByType::Array, shape::DeformOptions::SegmentByType::Protrusions);
  vtkShapeOption(MinimumProtrusion, double);
  vtkShapeEnumOptionOf(Frames, BiasBy, shape::PoseOptions::BiasByType,
    shape::PoseOptions::BiasByType::Direction, shape::PoseOptions::BiasByType::Frame);
  vtkShapeVectorOptionOf(Frames, BiasFrame);
  vtkShapeVectorOptionOf(Frames, BiasRotation);
  vtkShapeOptionOf(Frames, BiasWeight, double);
  vtkShapeOption(LaplacianSmoothing, bool);
  ///@}

protected:
  vtkShapeDeformingAlgorithm();
  ~vtkShapeDeformingAlgorithm() override = default;

  /// Reads the values at the points of a shape from the chosen arrays. name: denotes the shape in
  /// errors. Throws shape::InvalidInput if an array is missing or has several components.
  shape::DeformFields ReadFields(vtkDataSet* shape, const std::string& name) const;

  shape::DeformOptions Options;
  shape::PoseOptions Frames;
  std::string RigidityArray = "None", ScaleArray = "None", SegmentArray = "None";

private:
  vtkShapeDeformingAlgorithm(const vtkShapeDeformingAlgorithm&) = delete;
  void operator=(const vtkShapeDeformingAlgorithm&) = delete;
};

#endif
