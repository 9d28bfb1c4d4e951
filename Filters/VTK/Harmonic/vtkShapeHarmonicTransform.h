/**
 * @class   vtkShapeHarmonicTransform
 * @brief   a harmonic volume map as a transformation of space, with its derivative and inverse
 *
 * Works with every user of vtkAbstractTransform. The transform filters of VTK rotate normals and
 * vectors with the map. The reslice filter vtkImageReslice moves images: it needs the position from
 * which a value comes, so it takes the inverse.
 *
 *   carried = vtkImageReslice(); carried.SetInputData(image)
 *   transform = vtkShapeHarmonicTransform(); transform.SetChargeSetData(charges)
 *   transform.Inverse(); carried.SetResliceTransform(transform); carried.Update()
 *
 * The map is that of a charge set, the output Charges of vtkShapeHarmonicVolumeMap, also of
 * several layers. Points outside its domain, or for the inverse outside its image, keep their
 * position. So do points whose preimage is not found, which NotInverted counts. A missing or
 * invalid charge set is an error, and each point keeps its position.
 *
 * The derivative is analytic. The inverse is that of vtkShapeApplyVolumeMap, by Newton's method.
 * f(f^-1(y)) is y to 1e-11 of the size of the image. InverseTolerance and InverseIterations of the
 * base class are not used. The calling thread transforms single points, and all threads transform
 * sets of points. Both are safe from any thread after Update.
 *
 * The mathematics: shape::VolumeTransform.
 */
#ifndef vtkShapeHarmonicTransform_h
#define vtkShapeHarmonicTransform_h

#include "vtkShapeFiltersModule.h" // for the export macro

#include "vtkSmartPointer.h"
#include "vtkWarpTransform.h"

#include <atomic>
#include <memory>

class vtkAlgorithm;
class vtkAlgorithmOutput;
class vtkPolyData;
namespace shape
{
class VolumeTransform;
}

class VTKSHAPEFILTERS_EXPORT vtkShapeHarmonicTransform : public vtkWarpTransform
{
public:
  static vtkShapeHarmonicTransform* New();
  vtkTypeMacro(vtkShapeHarmonicTransform, vtkWarpTransform);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The charge set: the output of a filter, which is updated, or data.
  virtual void SetChargeSetConnection(vtkAlgorithmOutput* charges);
  virtual void SetChargeSetData(vtkPolyData* charges);
  virtual vtkPolyData* GetChargeSet();
  ///@}

  /// The number of preimages not found since the last update. These are points that lie inside the
  /// image of the domain's boundary and keep their position. Each inversion of the same point
  /// counts.
  virtual vtkIdType GetNotInverted() { return this->NotInverted; }

  vtkAbstractTransform* MakeTransform() override;
  vtkMTimeType GetMTime() override;

  ///@{
  /// The points are appended to `outPts`.
  void TransformPoints(vtkPoints* inPts, vtkPoints* outPts) override;
  void TransformPointsNormalsVectors(vtkPoints* inPts, vtkPoints* outPts, vtkDataArray* inNms,
    vtkDataArray* outNms, vtkDataArray* inVrs, vtkDataArray* outVrs, int nOptionalVectors = 0,
    vtkDataArray** inVrsArr = nullptr, vtkDataArray** outVrsArr = nullptr) override;
  ///@}

protected:
  vtkShapeHarmonicTransform();
  ~vtkShapeHarmonicTransform() override;

  void InternalUpdate() override;
  void InternalDeepCopy(vtkAbstractTransform* transform) override;

  ///@{
  void ForwardTransformPoint(const float in[3], float out[3]) override;
  void ForwardTransformPoint(const double in[3], double out[3]) override;
  void ForwardTransformDerivative(const float in[3], float out[3], float derivative[3][3]) override;
  void ForwardTransformDerivative(
    const double in[3], double out[3], double derivative[3][3]) override;
  void InverseTransformPoint(const float in[3], float out[3]) override;
  void InverseTransformPoint(const double in[3], double out[3]) override;
  void InverseTransformDerivative(const float in[3], float out[3], float derivative[3][3]) override;
  void InverseTransformDerivative(
    const double in[3], double out[3], double derivative[3][3]) override;
  ///@}

private:
  vtkShapeHarmonicTransform(const vtkShapeHarmonicTransform&) = delete;
  void operator=(const vtkShapeHarmonicTransform&) = delete;

  struct Many;
  Many TransformMany(vtkPoints* points);
  template <bool Forward, typename Number>
  void Transform(const Number in[3], Number out[3], Number (*derivative)[3]);

  vtkSmartPointer<vtkAlgorithm> Producer; ///< of the charge set
  int Port = 0;
  std::shared_ptr<const shape::VolumeTransform> Map; ///< empty: every point keeps its position
  vtkSmartPointer<vtkPolyData> MappedCharges;        ///< the data from which Map was built
  vtkMTimeType MappedTime = 0;                       ///< modification time of these data
  bool MapHasInverse = false;
  std::atomic<vtkIdType> NotInverted{ 0 };
};

#endif
