#include "vtkShapeCertificate.h"

#include "vtkShapeChargeSet.h"
#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Harmonic/PiecewiseHarmonicMap.h"
#include "Solids/Nesting.h"

#include <array>
#include <map>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkShapeCertificate);

vtkShapeCertificate::vtkShapeCertificate()
{
  this->DeclareInput("Map", PortData::Whole, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Domain", PortData::WholeSurface, PortUse::Optional, { "vtkPolyData" });
  this->DeclareOutput("vtkUnstructuredGrid");
  this->DeclareOutput("vtkPolyData");
  this->DeclareFacts();
  this->DeclareMeasures({ "Certified", "VolumeInside", "MinimumDeterminant", "Determinant" });
  this->DeclareShown(0, { "Certified" });
  this->DeclareShown(1, { "Determinant" });
}

namespace
{

/// Returns the surface of the solid to examine, facing outwards.
shape::Surface ReadDomain(vtkPolyData* domain, const shape::PiecewiseHarmonicMap& map)
{
  const shape::Surface surface =
    shape::OrientByNesting(vtkShapeConvert::ToMesh(domain, "the Domain"), "the Domain");
  const Eigen::VectorXi outside =
    shape::FindPointsOutsideDomain(map.Domain(), surface.Points(), map.Farthest());
  if (Eigen::Index first = 0; outside.maxCoeff(&first) > 0)
  {
    throw shape::InvalidInput("the Domain has " + std::to_string(outside.sum()) +
      " points outside the surface of the Map (first at point " + std::to_string(first) +
      "); use a Domain inside it");
  }
  return surface;
}

/// Writes voxels. Corners of neighbours have the same coordinates, bit for bit, and become one.
void WriteBoxes(const shape::MapCertificate& certificate, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::map<std::array<double, 3>, vtkIdType> known;
  vtkNew<vtkCellArray> cells;
  for (Eigen::Index i = 0; i < certificate.Edges.size(); ++i)
  {
    cells->InsertNextCell(8);
    for (int corner = 0; corner < 8; ++corner)
    {
      std::array<double, 3> position{};
      for (int axis = 0; axis < 3; ++axis)
      {
        const double half = 0.5 * certificate.Edges(i);
        position[axis] = certificate.Centres(i, axis) + ((corner >> axis & 1) != 0 ? half : -half);
      }
      const auto [entry, isNew] = known.emplace(position, points->GetNumberOfPoints());
      if (isNew)
      {
        points->InsertNextPoint(position.data());
      }
      cells->InsertCellPoint(entry->second);
    }
  }
  output->SetPoints(points);
  output->SetCells(VTK_VOXEL, cells);
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(certificate.States, "Certified"));
  output->GetCellData()->AddArray(vtkShapeConvert::ToArray(certificate.Volumes, "VolumeInside"));
  output->GetCellData()->AddArray(
    vtkShapeConvert::ToArray(certificate.Determinants, "MinimumDeterminant"));
}

void WriteWitnesses(
  const shape::MapCertificate& certificate, const shape::ChargeSet& map, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(vtkShapeConvert::ToArray(certificate.Witnesses, "Points"));
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < certificate.Witnesses.rows(); ++i)
  {
    vertices->InsertNextCell(1, &i);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->AddArray(
    vtkShapeConvert::ToArray(certificate.WitnessDeterminants, "Determinant"));
  output->GetPointData()->AddArray(
    vtkShapeConvert::ToArray(shape::Evaluate(map, certificate.Witnesses), "TargetPosition"));
}

} // namespace

void vtkShapeCertificate::Execute(const shape::Progress& progress)
{
  // Every process has the complete input, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  const shape::PiecewiseHarmonicMap map(
    vtkShapeChargeSet::Read(this->GetGatheredInput(0).Data, "the Map"));
  if (map.RegionCount() > 1)
  {
    throw shape::InvalidInput("the Map has " + std::to_string(map.RegionCount()) +
      " regions, between which it is not harmonic; compute the map without Exact");
  }
  if (map.HasRepair())
  {
    throw shape::InvalidInput("the Map is repaired, and was certified by its repair: see its facts "
                              "CertifiedShare and InvertedShare; or compute it without Repair");
  }
  const shape::Surface domain = this->GetNumberOfInputConnections(1) > 0
    ? ReadDomain(this->GetGatheredInput(1).Data, map)
    : map.Domain().GetSurface();
  const shape::MapCertificate certificate =
    shape::CertifyMap(map.Map(0), domain, this->Options, progress);

  auto* boxes = vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(0));
  WriteBoxes(certificate, boxes);
  WriteWitnesses(certificate, map.Map(0), vtkPolyData::SafeDownCast(this->GetOutputDataObject(1)));
  if (certificate.BoundaryReversed)
  {
    this->Warn(
      "the image of the boundary faces inwards, so the map mirrors the solid; reverse the boundary "
      "before it is mapped, or mirror its image");
  }
  if (!certificate.Complete)
  {
    this->Warn("Maximum Boxes was reached; raise it, or raise Tolerance");
  }
  const std::pair<const char*, double> facts[] = {
    { "Certified", certificate.CertifiedShare },
    { "Undecided", certificate.UndecidedShare },
    { "Inverted", certificate.InvertedShare },
    { "Bijective", certificate.Bijective },
    { "BoundaryCrossings", certificate.BoundaryCrossings },
    { "BoundaryReversed", certificate.BoundaryReversed },
    { "Witnesses", static_cast<double>(certificate.Witnesses.rows()) },
    { "Boxes", static_cast<double>(certificate.Edges.size()) },
    { "ExaminedBoxes", certificate.ExaminedBoxes },
  };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(boxes, std::string("Certificate.") + fact, value);
  }
}
