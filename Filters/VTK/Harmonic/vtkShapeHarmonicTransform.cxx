#include "vtkShapeHarmonicTransform.h"

#include "vtkShapeChargeSet.h"

#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include "Base/Errors.h"
#include "Harmonic/VolumeTransform.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <exception>
#include <vector>

vtkStandardNewMacro(vtkShapeHarmonicTransform);

namespace
{

/// Returns the inverse, or the matrix itself if it is singular.
Eigen::Matrix3d Inverted(const Eigen::Matrix3d& matrix)
{
  const Eigen::Matrix3d inverse = matrix.inverse();
  return inverse.allFinite() ? inverse : matrix;
}

/// Transforms a normal at a point at which the map has this derivative.
Eigen::Vector3d TurnedNormal(const Eigen::Matrix3d& jacobian, const Eigen::Vector3d& normal)
{
  // J^-T n = cof(J) n / det(J), which is finite before it is normalised, even if the map is nearly
  // singular.
  Eigen::Matrix3d cofactors;
  for (int r = 0; r < 3; ++r)
  {
    cofactors.row(r) = jacobian.row((r + 1) % 3).cross(jacobian.row((r + 2) % 3));
  }
  const double sign = jacobian.determinant() < 0.0 ? -1.0 : 1.0;
  const Eigen::Vector3d turned = sign * (cofactors * normal);
  const double length = turned.norm();
  return length > 0.0 ? Eigen::Vector3d(turned / length) : normal;
}

Eigen::Vector3d Tuple(vtkDataArray* array, vtkIdType i)
{
  Eigen::Vector3d tuple;
  array->GetTuple(i, tuple.data());
  return tuple;
}

} // namespace

vtkShapeHarmonicTransform::vtkShapeHarmonicTransform() = default;
vtkShapeHarmonicTransform::~vtkShapeHarmonicTransform() = default;

void vtkShapeHarmonicTransform::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ChargeSet: " << this->GetChargeSet() << "\n";
  os << indent << "NotInverted: " << this->GetNotInverted() << "\n";
}

void vtkShapeHarmonicTransform::SetChargeSetConnection(vtkAlgorithmOutput* charges)
{
  vtkAlgorithm* producer = charges ? charges->GetProducer() : nullptr;
  const int port = charges ? charges->GetIndex() : 0;
  if (producer != this->Producer || port != this->Port)
  {
    this->Producer = producer;
    this->Port = port;
    this->Modified();
  }
}

void vtkShapeHarmonicTransform::SetChargeSetData(vtkPolyData* charges)
{
  if (charges == this->GetChargeSet())
  {
    return;
  }
  if (!charges)
  {
    this->SetChargeSetConnection(nullptr);
    return;
  }
  vtkNew<vtkTrivialProducer> producer;
  producer->SetOutput(charges);
  this->SetChargeSetConnection(producer->GetOutputPort());
}

vtkPolyData* vtkShapeHarmonicTransform::GetChargeSet()
{
  return this->Producer ? vtkPolyData::SafeDownCast(this->Producer->GetOutputDataObject(this->Port))
                        : nullptr;
}

vtkAbstractTransform* vtkShapeHarmonicTransform::MakeTransform()
{
  return vtkShapeHarmonicTransform::New();
}

/// A filter that uses the transform must run again when the charges' pipeline is modified.
vtkMTimeType vtkShapeHarmonicTransform::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Producer)
  {
    this->Producer->UpdateInformation();
    if (auto* pipeline =
          vtkStreamingDemandDrivenPipeline::SafeDownCast(this->Producer->GetExecutive()))
    {
      time = std::max(time, pipeline->GetPipelineMTime());
    }
  }
  return time;
}

void vtkShapeHarmonicTransform::InternalDeepCopy(vtkAbstractTransform* transform)
{
  auto* source = static_cast<vtkShapeHarmonicTransform*>(transform);
  this->SetInverseTolerance(source->InverseTolerance);
  this->SetInverseIterations(source->InverseIterations);
  if (source->Producer != this->Producer || source->Port != this->Port)
  {
    this->Producer = source->Producer;
    this->Port = source->Port;
    this->Modified();
  }
  if (this->InverseFlag != source->InverseFlag)
  {
    this->InverseFlag = source->InverseFlag;
    this->Modified();
  }
}

/// A transform cannot return an error. Without a valid map, it reports an error and does not move
/// any point.
void vtkShapeHarmonicTransform::InternalUpdate()
{
  if (this->Producer)
  {
    this->Producer->Update(this->Port);
  }
  vtkPolyData* charges = this->GetChargeSet();
  const bool inverted = this->InverseFlag != 0;
  // Building the map takes long, so it is reused as long as the charges do not change.
  if (this->Map && charges == this->MappedCharges && charges->GetMTime() == this->MappedTime &&
    (this->MapHasInverse || !inverted))
  {
    return;
  }
  this->Map.reset();
  this->NotInverted = 0;
  this->MappedCharges = charges;
  try
  {
    if (!charges)
    {
      throw shape::InvalidInput("there is no charge set; connect one, such as the output Charges "
                                "of Shape Harmonic Volume Map");
    }
    this->Map = std::make_shared<const shape::VolumeTransform>(
      vtkShapeChargeSet::Read(charges, "the charge set"), inverted);
    this->MappedTime = charges->GetMTime();
    this->MapHasInverse = inverted;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("Shape Harmonic Transform: " << error.what());
  }
}

template <bool Forward, typename Number>
void vtkShapeHarmonicTransform::Transform(
  const Number in[3], Number out[3], Number (*derivative)[3])
{
  const Eigen::Vector3d point(in[0], in[1], in[2]);
  shape::VolumeTransform::Result result{ point };
  if (this->Map)
  {
    result = Forward ? this->Map->Forward(point) : this->Map->Backward(point);
    this->NotInverted += result.State == shape::InverseMap::State::Missed;
  }
  for (int r = 0; r < 3; ++r)
  {
    out[r] = static_cast<Number>(result.Position(r));
    for (int c = 0; derivative && c < 3; ++c)
    {
      derivative[r][c] = static_cast<Number>(result.Jacobian(r, c));
    }
  }
}

void vtkShapeHarmonicTransform::ForwardTransformPoint(const float in[3], float out[3])
{
  this->Transform<true, float>(in, out, nullptr);
}

void vtkShapeHarmonicTransform::ForwardTransformPoint(const double in[3], double out[3])
{
  this->Transform<true, double>(in, out, nullptr);
}

void vtkShapeHarmonicTransform::ForwardTransformDerivative(
  const float in[3], float out[3], float derivative[3][3])
{
  this->Transform<true, float>(in, out, derivative);
}

void vtkShapeHarmonicTransform::ForwardTransformDerivative(
  const double in[3], double out[3], double derivative[3][3])
{
  this->Transform<true, double>(in, out, derivative);
}

void vtkShapeHarmonicTransform::InverseTransformPoint(const float in[3], float out[3])
{
  this->Transform<false, float>(in, out, nullptr);
}

void vtkShapeHarmonicTransform::InverseTransformPoint(const double in[3], double out[3])
{
  this->Transform<false, double>(in, out, nullptr);
}

void vtkShapeHarmonicTransform::InverseTransformDerivative(
  const float in[3], float out[3], float derivative[3][3])
{
  this->Transform<false, float>(in, out, derivative);
}

void vtkShapeHarmonicTransform::InverseTransformDerivative(
  const double in[3], double out[3], double derivative[3][3])
{
  this->Transform<false, double>(in, out, derivative);
}

/// Computes the new positions of points, and the derivative of the transformation there.
struct vtkShapeHarmonicTransform::Many
{
  std::vector<Eigen::Vector3d> Positions;
  std::vector<Eigen::Matrix3d> Derivatives;
};

vtkShapeHarmonicTransform::Many vtkShapeHarmonicTransform::TransformMany(vtkPoints* points)
{
  this->Update();
  const vtkIdType count = points->GetNumberOfPoints();
  Eigen::MatrixXd rows(count, 3);
  for (vtkIdType i = 0; i < count; ++i)
  {
    Eigen::Vector3d position;
    points->GetPoint(i, position.data());
    rows.row(i) = position.transpose();
  }
  std::vector<shape::VolumeTransform::Result> results;
  if (this->Map)
  {
    results = this->InverseFlag ? this->Map->Backward(rows) : this->Map->Forward(rows);
  }
  Many many;
  for (vtkIdType i = 0; i < count; ++i)
  {
    const shape::VolumeTransform::Result result =
      this->Map ? results[i] : shape::VolumeTransform::Result{ rows.row(i).transpose() };
    this->NotInverted += result.State == shape::InverseMap::State::Missed;
    many.Positions.push_back(result.Position);
    // Backward returns the derivative of the forward map at the position found.
    many.Derivatives.push_back(this->InverseFlag ? Inverted(result.Jacobian) : result.Jacobian);
  }
  return many;
}

void vtkShapeHarmonicTransform::TransformPoints(vtkPoints* inPts, vtkPoints* outPts)
{
  for (const Eigen::Vector3d& position : this->TransformMany(inPts).Positions)
  {
    outPts->InsertNextPoint(position.data());
  }
}

void vtkShapeHarmonicTransform::TransformPointsNormalsVectors(vtkPoints* inPts, vtkPoints* outPts,
  vtkDataArray* inNms, vtkDataArray* outNms, vtkDataArray* inVrs, vtkDataArray* outVrs,
  int nOptionalVectors, vtkDataArray** inVrsArr, vtkDataArray** outVrsArr)
{
  const Many many = this->TransformMany(inPts);
  for (std::size_t i = 0; i < many.Positions.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    const Eigen::Matrix3d& derivative = many.Derivatives[i];
    outPts->InsertNextPoint(many.Positions[i].data());
    if (inNms)
    {
      outNms->InsertNextTuple(TurnedNormal(derivative, Tuple(inNms, id)).data());
    }
    if (inVrs)
    {
      outVrs->InsertNextTuple(Eigen::Vector3d(derivative * Tuple(inVrs, id)).data());
    }
    for (int k = 0; inVrsArr && k < nOptionalVectors; ++k)
    {
      outVrsArr[k]->InsertNextTuple(Eigen::Vector3d(derivative * Tuple(inVrsArr[k], id)).data());
    }
  }
}
