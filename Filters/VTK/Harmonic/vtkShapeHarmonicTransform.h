/**
 * @class   vtkShapeHarmonicTransform
 * @brief   a harmonic volume map as a transformation of space, with its derivative and inverse
 *
 * Use it wherever VTK accepts a vtkAbstractTransform. The transform filters of VTK also transform
 * normals and vectors by the map. To move an image with vtkImageReslice, set the inverse transform,
 * because the filter needs the position from which a value comes:
 *
 *   carried = vtkImageReslice(); carried.SetInputData(image)
 *   transform = vtkShapeHarmonicTransform(); transform.SetChargeSetData(charges)
 *   transform.Inverse(); carried.SetResliceTransform(transform); carried.Update()
 *
 * The map is given by a charge set, which is the output Charges of vtkShapeHarmonicVolumeMap. It
 * may have several layers. Points outside the domain or, for the inverse, outside the image of the
 * domain keep their position. Points whose preimage is not found also keep their position, and
 * NotInverted counts them. If the charge set is missing or invalid, an error is reported, and all
 * points keep their position.
 *
 * The derivative is analytic. The inverse is computed by Newton's method, like in
 * vtkShapeApplyVolumeMap. f(f^-1(y)) differs from y by at most 1e-11 of the size of the image.
 * InverseTolerance and InverseIterations of the base class are not used. Single points are
 * transformed by the calling thread, and sets of points by all threads. After Update, both
 * functions may be called from any thread.
 *
 * Where the map folds, the inverse is not unique. vtkShapeCertificate tells where, from the same
 * charge set:
 *
 *   certificate = vtkShapeCertificate(); certificate.SetInputData(0, charges); certificate.Update()
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
  /// Sets the charge set: the output of a filter, which Update updates, or data.
  virtual void SetChargeSetConnection(vtkAlgorithmOutput* charges);
  virtual void SetChargeSetData(vtkPolyData* charges);
  virtual vtkPolyData* GetChargeSet();
  ///@}

  /// Returns the number of points whose preimage was not found since the last update. These points
  /// lie inside the image of the boundary of the domain and keep their position. If the same point
  /// is inverted repeatedly, each attempt counts.
  virtual vtkIdType GetNotInverted() { return this->NotInverted; }

  vtkAbstractTransform* MakeTransform() override;
  vtkMTimeType GetMTime() override;

  ///@{
  /// Appends the transformed points to `outPts`.
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

  vtkSmartPointer<vtkAlgorithm> Producer; ///< the filter whose output is the charge set
  int Port = 0;
  std::shared_ptr<const shape::VolumeTransform> Map; ///< empty: every point keeps its position
  vtkSmartPointer<vtkPolyData> MappedCharges;        ///< the charge set from which Map was built
  vtkMTimeType MappedTime = 0; ///< modification time of MappedCharges when Map was built
  bool MapHasInverse = false;
  std::atomic<vtkIdType> NotInverted{ 0 };
};

#endif
