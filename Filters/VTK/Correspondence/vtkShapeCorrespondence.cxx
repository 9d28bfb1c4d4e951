#include "vtkShapeCorrespondence.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeMapColors.h"
#include "vtkShapeRepair.h"

#include "Base/Errors.h"
#include "Correspondence/Landmarks/LandmarkPairs.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include "vtkCell.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkShapeCorrespondence);

namespace
{

/// Corresponding positions, one in each row.
struct Partners
{
  std::vector<Eigen::RowVector3d> OnA, OnB;
};

double ComputeMeanEdgeLength(const shape::Mesh& mesh)
{
  double sum = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    sum += (mesh.Points(mesh.Triangles.col(k), Eigen::all) -
      mesh.Points(mesh.Triangles.col((k + 1) % 3), Eigen::all))
             .rowwise()
             .norm()
             .mean();
  }
  return sum / 3.0;
}

/// Returns the points of the landmarks, and positions between them along lines. Lines are sampled
/// at the mean edge length of the surface. Coarser samples would leave points between them
/// unconstrained, and finer samples would have the same nearest points.
Partners ReadPartners(vtkUnstructuredGrid* given, const Eigen::MatrixXd& targets, double step)
{
  const Eigen::MatrixXd positions = vtkShapeConvert::ToPoints(given);
  if (positions.rows() != targets.rows())
  {
    throw shape::InvalidInput("Landmarks has " + std::to_string(positions.rows()) +
      " points, and TargetLandmarks has " + std::to_string(targets.rows()) +
      "; connect equally many, because they are paired by order");
  }
  Partners partners;
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    partners.OnA.emplace_back(positions.row(i));
    partners.OnB.emplace_back(targets.row(i));
  }
  for (vtkIdType cell = 0; cell < given->GetNumberOfCells(); ++cell)
  {
    if (given->GetCell(cell)->GetCellDimension() != 1)
    {
      continue;
    }
    vtkIdList* points = given->GetCell(cell)->GetPointIds();
    for (vtkIdType i = 1; i < points->GetNumberOfIds(); ++i)
    {
      constexpr double maximum = 10000.0; // points on a segment
      const vtkIdType p = points->GetId(i - 1), q = points->GetId(i);
      const int pieces = static_cast<int>(
        std::clamp(std::ceil((positions.row(q) - positions.row(p)).norm() / step), 1.0, maximum));
      for (int k = 1; k < pieces; ++k)
      {
        const double t = static_cast<double>(k) / pieces;
        partners.OnA.emplace_back((1.0 - t) * positions.row(p) + t * positions.row(q));
        partners.OnB.emplace_back((1.0 - t) * targets.row(p) + t * targets.row(q));
      }
    }
  }
  return partners;
}

Eigen::MatrixXd AsRows(const std::vector<Eigen::RowVector3d>& positions)
{
  Eigen::MatrixXd rows(positions.size(), 3);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    rows.row(static_cast<Eigen::Index>(i)) = positions[i];
  }
  return rows;
}

} // namespace

vtkShapeCorrespondence::vtkShapeCorrespondence()
{
  this->DeclareInput("SurfaceA", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("SurfaceB", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Landmarks", PortData::WholeGrid, PortUse::Optional, { "vtkDataSet" });
  this->DeclareInput("TargetLandmarks", PortData::WholeGrid, PortUse::Optional, { "vtkDataSet" });
  this->DeclareOutputLikeInput(0);
  this->DeclareOutputLikeInput(1);
  this->DeclareFacts();
  this->DeclareShown(0, { "MapColors" });
  this->DeclareShown(1, { "MapColors" });
}

/// Every process computes the same maps from the gathered surfaces, and writes the rows of its own
/// points.
void vtkShapeCorrespondence::Execute(const shape::Progress& progress)
{
  const shape::Surface a = vtkShapeConvert::ToMesh(this->GetGatheredInput(0).Data, "SurfaceA"),
                       b = vtkShapeConvert::ToMesh(this->GetGatheredInput(1).Data, "SurfaceB");
  shape::RequireManifold(a, "SurfaceA");
  shape::RequireManifold(b, "SurfaceB");
  shape::Landmarks landmarks;
  const bool hasLandmarks = this->GetNumberOfInputConnections(2) > 0;
  const bool hasTargets = this->GetNumberOfInputConnections(3) > 0;
  if (hasTargets && !hasLandmarks)
  {
    throw shape::InvalidInput("there are TargetLandmarks without Landmarks; connect both");
  }
  if (hasLandmarks)
  {
    vtkUnstructuredGrid* given = this->GetGatheredInput(2).Grid;
    const Partners partners = ReadPartners(given,
      hasTargets ? vtkShapeConvert::ToPoints(this->GetGatheredInput(3).Grid)
                 : vtkShapeConvert::ToPointArray(given, "TargetPosition", 3, "the input Landmarks",
                     "make it with Shape Landmarks"),
      ComputeMeanEdgeLength(a));
    landmarks = shape::PairLandmarks(a, AsRows(partners.OnA), b, AsRows(partners.OnB));
  }
  const shape::CorrespondenceResult result =
    shape::ComputeCorrespondence(a, b, landmarks, this->Options, progress);
  const bool isPart = result.Part.Which != shape::SurfacePart::WhichType::None;
  if (result.GenusOfA != result.GenusOfB && !isPart)
  {
    this->Warn("the surfaces have genus " + std::to_string(result.GenusOfA) + " and " +
      std::to_string(result.GenusOfB) +
      ": no continuous one-to-one map exists; expect folds, or map surfaces of equal genus");
  }
  this->WriteMap(0, result.Maps.AToB, b, 1);
  this->WriteMap(1, result.Maps.BToA, a, 0);
  vtkShapeMapColors::Add(this->GetOutputDataObject(0), "TargetPosition", b);
  vtkShapeMapColors::Add(this->GetOutputDataObject(1), "", b);
  for (const int port : { 0, 1 })
  {
    const auto add = [&](const std::string& fact, double value)
    { vtkShapeConvert::AddFact(this->GetOutputDataObject(port), "Correspondence." + fact, value); };
    add("Landmarks", static_cast<double>(result.Used.size()));
    add("LandmarksFound", result.Found ? 1.0 : 0.0);
    if (hasLandmarks)
    {
      vtkShapeConvert::AddFact(this->GetOutputDataObject(port), "Correspondence.LandmarkTargets",
        hasTargets ? "TargetLandmarks" : "TargetPosition");
    }
    add("Distortion", result.Found ? result.Start.Distortion : -1.0);
    add("MirroredDistortion", result.Found ? result.Start.MirroredDistortion : -1.0);
    add("MirrorImage", !result.Found ? -1.0 : result.Start.MirrorImage ? 1.0 : 0.0);
    add("Confidence", result.Found ? result.Start.Confidence : -1.0);
    add("DirichletEnergy", result.Facts.DirichletEnergy);
    add("RoundTrip", result.Facts.RoundTrip);
    add("ReversedArea", result.Facts.ReversedArea);
    add("Mirrored", result.Facts.Mirrored ? 1.0 : 0.0);
    add("Part", static_cast<double>(result.Part.Which));
    add("Scale", result.Part.Scale);
    add("PartShare", result.Part.Share);
    add("CoverageOfA", result.Facts.CoverageOfA);
    add("CoverageOfB", result.Facts.CoverageOfB);
    add("CouplingDistortion", result.CouplingDistortion);
    add("CouplingError", result.CouplingError);
    add("CoarsePoints", result.CoarsePoints);
    add("Iterations", result.Iterations);
  }
}

void vtkShapeCorrespondence::WriteMap(
  int port, const shape::SurfacePoints& map, const shape::Mesh& other, int otherPort)
{
  const GatheredInput& whole = this->GetGatheredInput(port);
  const GatheredInput& target = this->GetGatheredInput(otherPort);
  // Cell ids of polygons follow those of vertices and lines.
  const auto before =
    static_cast<double>(target.Given->GetNumberOfVerts() + target.Given->GetNumberOfLines());
  const Eigen::VectorXi triangles = vtkShapeRepaired::ToGiven(target.GivenTriangles, map.Triangles);
  const auto own = [&](const Eigen::MatrixXd& values)
  { return vtkShapeConvert::Rows(values, whole.OwnPoints); };
  vtkShapeComposite::AddPointFields(this->GetInputDataObject(port, 0),
    this->GetOutputDataObject(port),
    { { "TargetPosition", own(shape::PullBack(map, other.Triangles, other.Points)) },
      { "TargetCell", own(triangles.cast<double>().array() + before), true },
      { "TargetBarycentric", own(map.Barycentrics) } });
}
