/**
 * @class   vtkShapeMeshMotion
 * @brief   move the points of a volume mesh with its boundary
 *
 * Inputs
 * - Input: tetrahedra, pyramids, wedges, hexahedra, voxels (which become hexahedra) and polyhedra,
 *   of any data set, which may be composite or distributed. The faces of one cell alone are the
 *   boundary. With the Method Harmonic, it must be one closed surface around the mesh and its
 *   voids. Coincident points of different pieces are connected.
 * - Boundary: a surface with the map array (3 components): the positions that its points move to.
 *   It may be a part of the boundary, such as the body in a flow, and be composite or distributed.
 *
 * Output (vtkUnstructuredGrid): the cells of Input at their moved points. A boundary point on
 * Boundary moves with it, by the displacement interpolated there. Other boundary points are fixed.
 * In parallel, the first process has all cells. Point normals are dropped.
 * - Point array `SourcePosition` (double, 3): the position in Input.
 * - Cell arrays `ScaledJacobian`, `NonOrthogonality` (degrees), `Skewness` (double) and `Inverted`
 *   (int; 1 if inverted, else 0), as in shape::SolidQuality.
 *
 * Facts, with the prefix MeshMotion
 * - .MovingPoints, .FixedPoints: numbers of boundary points. .UnmatchedPoints: number of points of
 *   Boundary that are not on the boundary of the mesh.
 * - .InvertedBefore, .InvertedAfter: numbers of inverted cells.
 * - .MinimumScaledJacobianBefore, .MaximumNonOrthogonalityBefore, .MeanNonOrthogonalityBefore (of
 *   the cells' maxima), .MaximumSkewnessBefore, and the same with After.
 * - .Centres, .BoundaryError: see shape::MeshMotionResult.
 *
 * The mathematics: shape::MoveMesh, shape::FindBoundaryMotion, shape::ComputeSolidQuality.
 */
#ifndef vtkShapeMeshMotion_h
#define vtkShapeMeshMotion_h

#include "vtkShapeAlgorithm.h"

#include "Harmonic/MeshMotion.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeMeshMotion : public vtkShapeAlgorithm
{
public:
  static vtkShapeMeshMotion* New();
  vtkTypeMacro(vtkShapeMeshMotion, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeMeshMotion.xml. Enumerations and defaults:
  /// shape::MeshMotionOptions.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  vtkShapeEnumOption(Method, shape::MeshMotionOptions::MethodType,
    shape::MeshMotionOptions::MethodType::Harmonic,
    shape::MeshMotionOptions::MethodType::RadialBasis);
  vtkShapeOption(Tolerance, double);
  vtkShapeOption(MatchTolerance, double);
  vtkShapeEnumOption(Kernel, shape::RadialBasisOptions::KernelType,
    shape::RadialBasisOptions::KernelType::Wendland,
    shape::RadialBasisOptions::KernelType::ThinPlate);
  vtkShapeOption(SupportRadius, double);
  vtkShapeOption(MaximumCentres, int);
  ///@}

protected:
  vtkShapeMeshMotion();
  ~vtkShapeMeshMotion() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeMeshMotion(const vtkShapeMeshMotion&) = delete;
  void operator=(const vtkShapeMeshMotion&) = delete;

  std::string MapArray = "TargetPosition";
  shape::MeshMotionOptions Options;
};

#endif
