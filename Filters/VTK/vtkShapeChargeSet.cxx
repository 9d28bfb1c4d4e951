#include "vtkShapeChargeSet.h"

#include "vtkShapeConvert.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include "Core/Errors.h"
#include "Core/Topology.h"
#include "Geometry/ClosestPoint.h"

#include <algorithm>
#include <vector>

namespace
{

using Affine = Eigen::Matrix<double, 3, 4>;

Affine ReadAffine(vtkPolyData* data, const std::string& name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray("Affine");
  if (!array || array->GetNumberOfTuples() != 3 || array->GetNumberOfComponents() != 4)
  {
    throw shape::InvalidInput(name +
      " has no field data 'Affine' of 3 tuples of 4 numbers; connect a charge set, such as the "
      "output Charges of Shape Harmonic Volume Map");
  }
  Affine affine;
  for (int i = 0; i < 12; ++i)
  {
    affine(i / 4, i % 4) = array->GetComponent(i / 4, i % 4);
  }
  return affine;
}

/// Half the least distance of a charge to the surface; without charges the map holds everywhere.
double MeasuredFarthest(const shape::ChargeSet& map, const shape::Mesh& surface)
{
  return map.Points.rows() > 0
    ? 0.5 * shape::SurfaceLocator(surface).Find(map.Points).Distances.minCoeff()
    : shape::LongestSide(surface.Points);
}

} // namespace

double vtkShapeChargeSet::Farthest(double offsetDistance, const shape::Mesh& surface)
{
  return 0.5 * offsetDistance * shape::LongestSide(surface.Points);
}

vtkShapeChargeSet::Contents vtkShapeChargeSet::Read(vtkPolyData* data, const std::string& name)
{
  const Affine affine = ReadAffine(data, name);
  shape::RequireFinite(affine, "the affine part of " + name);
  const Eigen::MatrixXd charges = vtkShapeConvert::ToPointArray(data, "Charge", 3, name);
  shape::RequireFinite(charges, "the charges of " + name);
  if (data->GetPointData()->HasArray("Dipole"))
  {
    throw shape::InvalidInput(
      name + " has dipoles, which cannot be evaluated; make a charge set without");
  }
  const shape::Mesh all = vtkShapeConvert::ToMesh(data, name);
  shape::RequireFinite(all.Points, name);

  std::vector<int> sources, corners;
  std::vector<int> placeInSurface(all.Points.rows(), -1);
  for (int i = 0; i < charges.rows(); ++i)
  {
    if ((charges.row(i).array() != 0.0).any())
    {
      sources.push_back(i);
    }
    else
    {
      placeInSurface[i] = static_cast<int>(corners.size());
      corners.push_back(i);
    }
  }
  Contents contents;
  contents.Map = { vtkShapeConvert::Rows(all.Points, sources),
    vtkShapeConvert::Rows(charges, sources), affine };
  contents.Surface.Points = vtkShapeConvert::Rows(all.Points, corners);
  contents.Surface.Triangles = all.Triangles.unaryExpr(
    [&](int point)
    {
      if (placeInSurface[point] < 0)
      {
        throw shape::InvalidInput(name +
          " has a charge on the surface that bounds its domain (at "
          "point " +
          std::to_string(point) + "); charges belong outside, and 0 at the surface's points");
      }
      return placeInSurface[point];
    });
  if (contents.Surface.Triangles.rows() == 0)
  {
    throw shape::InvalidInput(
      name + " has no triangles; its cells must be the surface that bounds the map's domain");
  }
  shape::RequireClosedSurface(contents.Surface, "the surface of " + name);
  vtkDataArray* offset = data->GetFieldData()->GetArray("HarmonicVolumeMap.OffsetDistance");
  contents.Farthest = offset && offset->GetNumberOfTuples() > 0
    ? Farthest(offset->GetComponent(0, 0), contents.Surface)
    : MeasuredFarthest(contents.Map, contents.Surface);
  return contents;
}

void vtkShapeChargeSet::Write(
  const shape::ChargeSet& map, const shape::Mesh& surface, vtkPolyData* output)
{
  std::vector<int> sources;
  for (int i = 0; i < map.Charges.rows(); ++i)
  {
    if ((map.Charges.row(i).array() != 0.0).any())
    {
      sources.push_back(i);
    }
  }
  // The charges come first, then the surface's points, which carry no charge.
  const auto count = static_cast<int>(sources.size());
  shape::Mesh mesh{ Eigen::MatrixXd(count + surface.Points.rows(), 3),
    surface.Triangles.array() + count };
  mesh.Points << vtkShapeConvert::Rows(map.Points, sources), surface.Points;
  Eigen::MatrixXd charges = Eigen::MatrixXd::Zero(mesh.Points.rows(), 3);
  charges.topRows(count) = vtkShapeConvert::Rows(map.Charges, sources);
  vtkShapeConvert::FromMesh(mesh, output);
  output->GetPointData()->AddArray(vtkShapeConvert::ToArray(charges, "Charge"));
  output->GetFieldData()->AddArray(vtkShapeConvert::ToArray(map.Affine, "Affine"));
}

std::array<vtkIdType, 3> vtkShapeChargeSet::Move(vtkDataObject* domain, vtkDataObject* moved,
  const std::function<shape::MovedPoints(
    const Eigen::MatrixXd& points, const shape::Progress& progress)>& place,
  const shape::Progress& progress)
{
  std::array<vtkIdType, 3> counts{};
  double done = 0.0;
  const double share =
    1.0 / std::max<vtkIdType>(1, domain->GetNumberOfElements(vtkDataObject::POINT));
  vtkShapeConvert::ForEachLeaf(domain, moved, vtkShapeConvert::Points::Moved,
    [&](vtkDataSet* input, vtkDataSet* output)
    {
      const Eigen::MatrixXd sources = vtkShapeConvert::ToPoints(input);
      const double next = std::min(1.0, done + share * sources.rows());
      const shape::MovedPoints places = place(sources, progress.Part(done, next));
      done = next;
      vtkUnsignedCharArray* ghosts = input->GetPointGhostArray();
      for (Eigen::Index i = 0; i < sources.rows(); ++i)
      {
        const bool own =
          !ghosts || (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT) == 0;
        counts[places.OutsideDomain(i)] += own;
      }
      vtkShapeConvert::Move(input, places.Points, output);
      output->GetPointData()->AddArray(vtkShapeConvert::ToArray(sources, "SourcePosition"));
      output->GetPointData()->AddArray(
        vtkShapeConvert::ToIntegers(places.OutsideDomain, "OutsideDomain"));
    });
  return counts;
}
