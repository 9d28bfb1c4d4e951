#include "vtkShapeChargeSet.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFiniteElements.h"
#include "vtkShapeGather.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace
{

using Affine = Eigen::Matrix<double, 3, 4>;

/// Reads [A b] of each region: 3 tuples of 4 if there is one region, otherwise one tuple of 12 for
/// each region.
std::vector<Affine> ReadAffines(vtkPolyData* data, const std::string& name)
{
  vtkDataArray* array = data->GetFieldData()->GetArray("Affine");
  const vtkIdType tuples = array ? array->GetNumberOfTuples() : 0;
  const int components = array ? array->GetNumberOfComponents() : 0;
  const bool one = tuples == 3 && components == 4;
  if (!one && (tuples == 0 || components != 12))
  {
    throw shape::InvalidInput(name +
      " has no field data array 'Affine' with 3 tuples of 4 numbers, or with one tuple of 12 "
      "numbers for each region; connect a charge set, such as the output Charges of Shape Harmonic "
      "Volume Map");
  }
  std::vector<Affine> affines(one ? 1 : tuples);
  for (int i = 0; i < 12 * static_cast<int>(affines.size()); ++i)
  {
    affines[i / 12](i % 12 / 4, i % 4) = array->GetComponent(i / components, i % components);
  }
  for (const Affine& affine : affines)
  {
    shape::RequireFinite(affine, "the affine part of " + name);
  }
  return affines;
}

/// Returns RegionId at the points; 0 if there is no such array and one region.
std::vector<int> ReadRegions(vtkPolyData* data, int regions, const std::string& name)
{
  std::vector<int> ids(data->GetNumberOfPoints(), 0);
  if (regions == 1 && !data->GetPointData()->HasArray("RegionId"))
  {
    return ids;
  }
  const Eigen::VectorXd values = vtkShapeConvert::ToPointArray(data, "RegionId", 1, name);
  for (Eigen::Index i = 0; i < values.size(); ++i)
  {
    if (!(values(i) >= shape::PiecewiseCharges::Void && values(i) < regions))
    {
      throw shape::InvalidInput(name + " has " + std::to_string(regions) +
        " affine parts, but RegionId is " + std::to_string(values(i)) + " at point " +
        std::to_string(i) + "; number the regions from 0, and use -1 at the boundaries of voids");
    }
    ids[i] = static_cast<int>(values(i));
  }
  return ids;
}

/// Returns half the minimum distance of a charge from the surface. Without charges the map is valid
/// everywhere.
double MeasuredMaximum(const Eigen::MatrixXd& charges, const shape::Surface& surface)
{
  return charges.rows() > 0
    ? 0.5 * shape::SurfaceLocator(surface).Find(charges).Distances.minCoeff()
    : shape::ComputeLongestBoxEdge(surface);
}

/// Returns the rows of a charge set that have a charge.
/// Charges that are 0 contribute nothing; this also distinguishes sources from points of
/// the surface.
std::vector<int> ChargedRows(const Eigen::MatrixXd& charges)
{
  std::vector<int> rows;
  for (int i = 0; i < charges.rows(); ++i)
  {
    if ((charges.row(i).array() != 0.0).any())
    {
      rows.push_back(i);
    }
  }
  return rows;
}

/// The rows of a field data array, which must have this number of components.
Eigen::MatrixXd ReadFieldRows(
  vtkPolyData* data, const char* array, int components, const std::string& name)
{
  vtkDataArray* found = data->GetFieldData()->GetArray(array);
  if (!found || found->GetNumberOfComponents() != components)
  {
    throw shape::InvalidInput(name + " is repaired, but has no field data array '" + array +
      "' of " + std::to_string(components) +
      " components; use the complete output Charges of Shape Harmonic Volume Map");
  }
  Eigen::MatrixXd rows(found->GetNumberOfTuples(), components);
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
  {
    for (int k = 0; k < components; ++k)
    {
      rows(i, k) = found->GetComponent(i, k);
    }
  }
  shape::RequireFinite(rows, "the array '" + std::string(array) + "' of " + name);
  return rows;
}

/// Returns the repair of a repaired map; without tetrahedra if the map is not repaired.
shape::MapRepair ReadRepair(vtkPolyData* data, const std::string& name)
{
  shape::MapRepair repair;
  if (vtkDataArray* corners = data->GetFieldData()->GetArray("RepairTetrahedra"))
  {
    if (corners->GetNumberOfComponents() != 4)
    {
      throw shape::InvalidInput(
        name + " has an array 'RepairTetrahedra' without 4 components; compute the map again");
    }
    repair.Elements.Tetrahedra = vtkShapeFiniteElements::ReadCorners(corners);
    repair.Elements.Points = ReadFieldRows(data, "RepairPoints", 3, name);
    repair.Elements.Images = ReadFieldRows(data, "RepairTargetPosition", 3, name);
    repair.Shares = ReadFieldRows(data, "RepairShare", 1, name);
  }
  return repair;
}

void WriteRepair(const shape::MapRepair& repair, vtkPolyData* output)
{
  if (repair.Elements.Tetrahedra.rows() == 0)
  {
    return;
  }
  vtkFieldData* data = output->GetFieldData();
  data->AddArray(vtkShapeConvert::ToArray(repair.Elements.Points, "RepairPoints"));
  data->AddArray(vtkShapeConvert::ToArray(repair.Elements.Images, "RepairTargetPosition"));
  data->AddArray(vtkShapeConvert::ToArray(repair.Shares, "RepairShare"));
  data->AddArray(
    vtkShapeFiniteElements::WriteCorners(repair.Elements.Tetrahedra, "RepairTetrahedra"));
}

} // namespace

shape::PiecewiseCharges vtkShapeChargeSet::Read(vtkPolyData* data, const std::string& name)
{
  if (vtkShapeFiniteElements::Has(data))
  {
    throw shape::InvalidInput(name +
      " is a map of finite elements, which has no charges; use Shape Apply Volume Map, or compute "
      "the map with the Method Accelerated");
  }
  const std::vector<Affine> affines = ReadAffines(data, name);
  const auto count = static_cast<int>(affines.size());
  const Eigen::MatrixXd charges = vtkShapeConvert::ToPointArray(data, "Charge", 3, name);
  shape::RequireFinite(charges, "the charges of " + name);
  if (data->GetPointData()->HasArray("Dipole"))
  {
    throw shape::InvalidInput(
      name + " has dipoles, which cannot be evaluated; use a charge set without dipoles");
  }
  const std::vector<int> regions = ReadRegions(data, count, name);
  const shape::Mesh all = vtkShapeConvert::ToMesh(data, name);
  shape::RequireFinite(all.Points, name);

  shape::PiecewiseCharges contents;
  contents.Maps.resize(count);
  const std::vector<int> sources = ChargedRows(charges);
  for (int r = 0; r < count; ++r)
  {
    std::vector<int> own;
    std::copy_if(sources.begin(), sources.end(), std::back_inserter(own),
      [&](int i) { return regions[i] == r; });
    contents.Maps[r] = { vtkShapeConvert::Rows(all.Points, own),
      vtkShapeConvert::Rows(charges, own), affines[r] };
  }
  std::vector<int> corners;
  std::vector<int> positionInSurface(all.Points.rows(), -1);
  for (int i = 0; i < charges.rows(); ++i)
  {
    if (!std::binary_search(sources.begin(), sources.end(), i))
    {
      positionInSurface[i] = static_cast<int>(corners.size());
      corners.push_back(i);
    }
  }
  Eigen::MatrixXi triangles = all.Triangles.unaryExpr(
    [&](int point)
    {
      if (positionInSurface[point] < 0)
      {
        throw shape::InvalidInput(name +
          " has a charge on the surface that bounds its domain (at "
          "point " +
          std::to_string(point) +
          "); move the charge outside, or set Charge to 0 at the points of the surface");
      }
      return positionInSurface[point];
    });
  if (triangles.rows() == 0)
  {
    throw shape::InvalidInput(
      name + " has no triangles; its cells must be the surface that bounds the map's domain");
  }
  contents.Surface =
    shape::Surface(vtkShapeConvert::Rows(all.Points, corners), std::move(triangles));
  shape::RequireClosedSurface(contents.Surface, "the surface of " + name);
  // One region needs no labels.
  if (count > 1)
  {
    contents.Regions = all.Triangles.col(0).unaryExpr([&](int point) { return regions[point]; });
    if (vtkDataArray* skin = data->GetFieldData()->GetArray("Skin");
        skin && skin->GetNumberOfTuples() == count)
    {
      contents.Skins.resize(count);
      for (int r = 0; r < count; ++r)
      {
        contents.Skins(r) = skin->GetComponent(r, 0);
      }
    }
  }
  vtkDataArray* offset = data->GetFieldData()->GetArray("HarmonicVolumeMap.OffsetDistance");
  // Charge sets that other programs wrote do not have this fact.
  contents.Farthest = offset && offset->GetNumberOfTuples() > 0
    ? shape::ComputeFarthest(offset->GetComponent(0, 0), contents.Surface.Points())
    : MeasuredMaximum(vtkShapeConvert::Rows(all.Points, sources), contents.Surface);
  contents.Repair = ReadRepair(data, name);
  return contents;
}

void vtkShapeChargeSet::Share(
  vtkMultiProcessController* controller, shape::PiecewiseCharges& charges)
{
  if (!controller || controller->GetNumberOfProcesses() == 1)
  {
    return;
  }
  // All numbers are sent as doubles, which represent indices exactly.
  Eigen::MatrixXd sizes(1, 2);
  sizes << static_cast<double>(charges.Maps.size()), charges.Farthest;
  vtkShapeGather::Share(controller, sizes);
  charges.Maps.resize(static_cast<std::size_t>(sizes(0)));
  charges.Farthest = sizes(1);
  for (shape::ChargeSet& map : charges.Maps)
  {
    Eigen::MatrixXd affine = map.Affine;
    vtkShapeGather::Share(controller, map.Points);
    vtkShapeGather::Share(controller, map.Charges);
    vtkShapeGather::Share(controller, affine);
    map.Affine = affine;
  }
  Eigen::MatrixXd points = charges.Surface.Points();
  Eigen::MatrixXd triangles = charges.Surface.Triangles().cast<double>();
  Eigen::MatrixXd regions = charges.Regions.cast<double>(), skins = charges.Skins;
  for (Eigen::MatrixXd* matrix : { &points, &triangles, &regions, &skins })
  {
    vtkShapeGather::Share(controller, *matrix);
  }
  charges.Surface = shape::Surface(std::move(points), triangles.cast<int>());
  charges.Regions = regions.cast<int>();
  charges.Skins = skins;
  shape::MapRepair& repair = charges.Repair;
  Eigen::MatrixXd tetrahedra = repair.Elements.Tetrahedra.cast<double>(), shares = repair.Shares;
  for (Eigen::MatrixXd* matrix :
    { &repair.Elements.Points, &repair.Elements.Images, &tetrahedra, &shares })
  {
    vtkShapeGather::Share(controller, *matrix);
  }
  repair.Elements.Tetrahedra = tetrahedra.cast<int>();
  repair.Shares = shares;
}

void vtkShapeChargeSet::Write(const shape::PiecewiseCharges& set, vtkPolyData* output)
{
  const auto regions = static_cast<int>(set.Maps.size());
  std::vector<std::vector<int>> sources;
  int count = 0;
  for (const shape::ChargeSet& map : set.Maps)
  {
    sources.push_back(ChargedRows(map.Charges));
    count += static_cast<int>(sources.back().size());
  }
  // The charges come first, region by region, then the surface's points, which have no charge.
  shape::Mesh mesh{ Eigen::MatrixXd(count + set.Surface.Points().rows(), 3),
    set.Surface.Triangles().array() + count };
  mesh.Points.bottomRows(set.Surface.Points().rows()) = set.Surface.Points();
  Eigen::MatrixXd charges = Eigen::MatrixXd::Zero(mesh.Points.rows(), 3);
  Eigen::VectorXi ids = Eigen::VectorXi::Zero(mesh.Points.rows());
  Eigen::MatrixXd affines(regions, 12);
  for (int r = 0, first = 0; r < regions; first += static_cast<int>(sources[r++].size()))
  {
    const auto size = static_cast<Eigen::Index>(sources[r].size());
    mesh.Points.middleRows(first, size) = vtkShapeConvert::Rows(set.Maps[r].Points, sources[r]);
    charges.middleRows(first, size) = vtkShapeConvert::Rows(set.Maps[r].Charges, sources[r]);
    ids.segment(first, size).setConstant(r);
    for (int i = 0; i < 12; ++i)
    {
      affines(r, i) = set.Maps[r].Affine(i / 4, i % 4);
    }
  }
  vtkShapeConvert::FromMesh(mesh, output);
  output->GetPointData()->AddArray(vtkShapeConvert::ToArray(charges, "Charge"));
  if (regions == 1)
  {
    output->GetFieldData()->AddArray(vtkShapeConvert::ToArray(set.Maps[0].Affine, "Affine"));
    WriteRepair(set.Repair, output);
    return;
  }
  for (Eigen::Index t = 0; t < set.Regions.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      ids(mesh.Triangles(t, k)) = set.Regions(t);
    }
  }
  output->GetPointData()->AddArray(vtkShapeConvert::ToIntegers(ids, "RegionId"));
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(set.Regions, "RegionId"));
  output->GetFieldData()->AddArray(vtkShapeConvert::ToArray(affines, "Affine"));
  output->GetFieldData()->AddArray(vtkShapeConvert::ToArray(set.Skins, "Skin"));
}

std::array<std::vector<Eigen::RowVector3d>, 2> vtkShapeChargeSet::Move(vtkDataObject* domain,
  vtkDataObject* moved,
  const std::function<shape::MovedPoints(
    const Eigen::MatrixXd& points, const shape::Progress& progress)>& position,
  const shape::Progress& progress)
{
  std::array<std::vector<Eigen::RowVector3d>, 2> found;
  double done = 0.0;
  const double share =
    1.0 / std::max<vtkIdType>(1, domain->GetNumberOfElements(vtkDataObject::POINT));
  vtkShapeComposite::ForEach(domain, moved, vtkShapeComposite::Points::Moved,
    [&](vtkDataSet* input, vtkDataSet* output)
    {
      const Eigen::MatrixXd sources = vtkShapeConvert::ToPoints(input);
      const double next = std::min(1.0, done + share * sources.rows());
      const shape::MovedPoints positions = position(sources, progress.Part(done, next));
      done = next;
      vtkUnsignedCharArray* ghosts = input->GetPointGhostArray();
      for (Eigen::Index i = 0; i < sources.rows(); ++i)
      {
        // Points that belong to another process are counted by that process.
        const bool own =
          !ghosts || (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT) == 0;
        if (own && positions.OutsideDomain(i) > 0)
        {
          found[positions.OutsideDomain(i) - 1].emplace_back(sources.row(i));
        }
      }
      vtkShapeComposite::Move(input, positions.Points, output);
      output->GetPointData()->AddArray(vtkShapeConvert::ToArray(sources, "SourcePosition"));
      output->GetPointData()->AddArray(
        vtkShapeConvert::ToIntegers(positions.OutsideDomain, "OutsideDomain"));
    });
  return found;
}
