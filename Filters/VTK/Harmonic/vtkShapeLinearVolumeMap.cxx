#include "vtkShapeLinearVolumeMap.h"

#include "vtkShapeChargeSet.h"
#include "vtkShapeConvert.h"

#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"
#include "Harmonic/LinearVolumeMap.h"

#include <exception>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeLinearVolumeMap);

namespace
{

Eigen::MatrixXd ReadTuples(vtkDataArray* array, int components, const std::string& name)
{
  if (!array || array->GetNumberOfComponents() != components)
  {
    throw shape::InvalidInput(name + " is not an array of " + std::to_string(components) +
      " components; give one tuple for each point");
  }
  Eigen::MatrixXd rows(array->GetNumberOfTuples(), components);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      rows(i, k) = array->GetComponent(i, k);
    }
  }
  return rows;
}

Eigen::MatrixXd ReadJacobians(vtkDataArray* array)
{
  return array ? ReadTuples(array, 9, "the derivative by Jacobians") : Eigen::MatrixXd();
}

Eigen::MatrixXd ReadPoints(vtkPoints* points)
{
  return ReadTuples(points ? points->GetData() : nullptr, 3, "the list of points");
}

void WriteTuples(const Eigen::MatrixXd& rows, vtkDoubleArray* array)
{
  if (!array)
  {
    throw shape::InvalidInput("there is no array for the result; give an empty vtkDoubleArray");
  }
  const std::string name = array->GetName() ? array->GetName() : "Gradient";
  array->DeepCopy(vtkShapeConvert::ToArray(rows, name));
}

} // namespace

vtkShapeLinearVolumeMap::vtkShapeLinearVolumeMap()
  : Tolerance(shape::LinearVolumeMapOptions().Tolerance)
{
}

vtkShapeLinearVolumeMap::~vtkShapeLinearVolumeMap() = default;

void vtkShapeLinearVolumeMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Boundary: " << this->Boundary.Get() << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}

void vtkShapeLinearVolumeMap::SetBoundary(vtkPolyData* boundary)
{
  if (this->Boundary != boundary)
  {
    this->Boundary = boundary;
    this->Prepared.reset();
    this->Modified();
  }
}

vtkPolyData* vtkShapeLinearVolumeMap::GetBoundary()
{
  return this->Boundary;
}

void vtkShapeLinearVolumeMap::SetTolerance(double tolerance)
{
  if (this->Tolerance != tolerance)
  {
    this->Tolerance = tolerance;
    this->Prepared.reset();
    this->Modified();
  }
}

bool vtkShapeLinearVolumeMap::Try(const std::function<void()>& work)
{
  try
  {
    work();
    return true;
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro("Shape Linear Volume Map: " << error.what());
    return false;
  }
}

const shape::LinearVolumeMap& vtkShapeLinearVolumeMap::Solver()
{
  if (!this->Boundary)
  {
    throw shape::InvalidInput("there is no boundary; call SetBoundary with a closed surface");
  }
  if (!this->Prepared || this->PreparedTime != this->Boundary->GetMTime())
  {
    this->Prepared.reset();
    shape::LinearVolumeMapOptions options;
    options.Tolerance = this->Tolerance;
    this->Prepared = std::make_unique<shape::LinearVolumeMap>(
      vtkShapeConvert::ToMesh(this->Boundary, "the boundary"), options);
    this->PreparedTime = this->Boundary->GetMTime();
  }
  return *this->Prepared;
}

bool vtkShapeLinearVolumeMap::Fit(vtkDataArray* images, vtkPolyData* charges)
{
  return this->Try(
    [&]
    {
      const Eigen::MatrixXd rows = ReadTuples(images, 3, "the boundary map");
      if (!charges)
      {
        throw shape::InvalidInput("there is no data set for the charges; give a vtkPolyData");
      }
      shape::PiecewiseCharges set;
      set.Maps[0] = this->Solver().Fit(rows);
      set.Surface = vtkShapeConvert::ToMesh(this->Boundary, "the boundary");
      charges->Initialize();
      vtkShapeChargeSet::Write(set, charges);
    });
}

bool vtkShapeLinearVolumeMap::ComputeGradient(
  vtkPoints* points, vtkDataArray* byImages, vtkDataArray* byJacobians, vtkDoubleArray* gradient)
{
  return this->Try(
    [&]
    {
      const Eigen::MatrixXd positions = ReadPoints(points),
                            images = ReadTuples(byImages, 3, "the derivative by images");
      WriteTuples(this->Solver().Gradient(positions, images, ReadJacobians(byJacobians)), gradient);
    });
}

bool vtkShapeLinearVolumeMap::ComputeChargeGradient(vtkPolyData* charges, vtkPoints* points,
  vtkDataArray* byImages, vtkDataArray* byJacobians, vtkDoubleArray* byCharges,
  vtkDoubleArray* byAffine)
{
  return this->Try(
    [&]
    {
      if (!charges)
      {
        throw shape::InvalidInput("there is no charge set; give the output Charges of Shape "
                                  "Harmonic Volume Map");
      }
      const Eigen::MatrixXd all =
        vtkShapeConvert::ToPointArray(charges, "Charge", 3, "the charge set");
      std::vector<int> charged;
      for (int i = 0; i < all.rows(); ++i)
      {
        if ((all.row(i).array() != 0.0).any())
        {
          charged.push_back(i);
        }
      }
      shape::ChargeSet map;
      map.Points = vtkShapeConvert::Rows(vtkShapeConvert::ToPoints(charges), charged);
      map.Charges = vtkShapeConvert::Rows(all, charged);
      const shape::ChargeGradient found = shape::ComputeChargeGradient(map, ReadPoints(points),
        ReadTuples(byImages, 3, "the derivative by images"), ReadJacobians(byJacobians));
      Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(all.rows(), 3);
      rows(charged, Eigen::all) = found.Charges;
      WriteTuples(rows, byCharges);
      WriteTuples(found.Affine, byAffine);
    });
}
