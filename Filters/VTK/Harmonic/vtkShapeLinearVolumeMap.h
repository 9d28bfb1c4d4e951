/**
 * @class   vtkShapeLinearVolumeMap
 * @brief   a harmonic volume map that is linear in the boundary's images, with gradients
 *
 * For optimisation: of any number F that depends on a volume map, the gradient by the images of the
 * boundary's points, by one transposed solve. From Python, with arrays of VTK:
 *
 *   solver = vtkShapeLinearVolumeMap(); solver.SetBoundary(surface)
 *   solver.Fit(images, charges)             # a charge set, for vtkShapeHarmonicTransform
 *   ...                                     # F and its derivative by the images of some points
 *   solver.ComputeGradient(points, byImages, None, gradient)
 *
 * Arrays have one tuple for each point: points, images and their derivatives 3 components,
 * Jacobians 9, in the order d f_r / d y_c with index 3 r + c. The system is set up by the first
 * call after SetBoundary, and kept. In the case of an error, it is reported, and functions return
 * false.
 *
 * The mathematics: shape::LinearVolumeMap, shape::ComputeChargeGradient.
 */
#ifndef vtkShapeLinearVolumeMap_h
#define vtkShapeLinearVolumeMap_h

#include "vtkObject.h"
#include "vtkShapeFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"       // for the boundary

#include <functional> // for work that may fail
#include <memory>     // for the solver

class vtkDataArray;
class vtkDoubleArray;
class vtkPoints;
class vtkPolyData;
namespace shape
{
class LinearVolumeMap;
}

class VTKSHAPEFILTERS_EXPORT vtkShapeLinearVolumeMap : public vtkObject
{
public:
  static vtkShapeLinearVolumeMap* New();
  vtkTypeMacro(vtkShapeLinearVolumeMap, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The closed surface around the solid and its voids.
  virtual void SetBoundary(vtkPolyData* boundary);
  virtual vtkPolyData* GetBoundary();
  ///@}

  ///@{
  /// See shape::LinearVolumeMapOptions.
  virtual void SetTolerance(double tolerance);
  vtkGetMacro(Tolerance, double);
  ///@}

  /// Makes `charges` the charge set of the map with the given images of the boundary's points.
  virtual bool Fit(vtkDataArray* images, vtkPolyData* charges);

  /// Sets `gradient` to the derivative of F by the images of the boundary's points, given its
  /// derivatives by the images of `points` and by the Jacobians there, which may be null.
  virtual bool ComputeGradient(
    vtkPoints* points, vtkDataArray* byImages, vtkDataArray* byJacobians, vtkDoubleArray* gradient);

  /// Sets `byCharges` to the derivative of F by the array Charge of a charge set with one region (0
  /// at points without charge), and `byAffine` to that by its field data Affine.
  virtual bool ComputeChargeGradient(vtkPolyData* charges, vtkPoints* points,
    vtkDataArray* byImages, vtkDataArray* byJacobians, vtkDoubleArray* byCharges,
    vtkDoubleArray* byAffine);

protected:
  vtkShapeLinearVolumeMap();
  ~vtkShapeLinearVolumeMap() override;

private:
  vtkShapeLinearVolumeMap(const vtkShapeLinearVolumeMap&) = delete;
  void operator=(const vtkShapeLinearVolumeMap&) = delete;

  bool Try(const std::function<void()>& work);
  const shape::LinearVolumeMap& Solver();

  vtkSmartPointer<vtkPolyData> Boundary;
  double Tolerance;
  std::unique_ptr<shape::LinearVolumeMap> Prepared; ///< empty: to be set up
  vtkMTimeType PreparedTime = 0; ///< modification time of the boundary when it was set up
};

#endif
