#include "vtkShapeParameterize.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeCutImage.h"
#include "vtkShapeMapColors.h"

#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Mesh/SurfacePoints.h"
#include "Mesh/UsedPoints.h"
#include "Search/ClosestPoint.h"

#include <numeric>

vtkStandardNewMacro(vtkShapeParameterize);

vtkShapeParameterize::vtkShapeParameterize()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Landmarks", PortData::WholeGrid, PortUse::Optional, { "vtkDataSet" });
  this->DeclareOutputLikeInput();
  this->DeclareMovedOutput();
  this->DeclareFacts();
  this->DeclareShown(0, { "MapColors" });
  this->DeclareShown(1, { "MapColors" });
}

namespace
{

/// Returns the points that triangles use after a repair. Without a repair, and if the given surface
/// has points that no triangle uses, returns all points: the kernel refuses the latter.
std::vector<int> FindKept(const shape::Mesh& mesh, const shape::Mesh& given)
{
  std::vector<int> kept = shape::FindUsedPoints(mesh.Triangles, mesh.Points.rows());
  const Eigen::Index used =
    static_cast<Eigen::Index>(shape::FindUsedPoints(given.Triangles, given.Points.rows()).size());
  if (used < given.Points.rows())
  {
    kept.resize(mesh.Points.rows());
    std::iota(kept.begin(), kept.end(), 0);
  }
  return kept;
}

/// Returns the positions of all points by those of the kept ones. A point that the repair left out
/// gets the image of the position on the kept surface that is closest to it.
Eigen::MatrixXd Expand(const Eigen::MatrixXd& positions, const shape::Surface& surface,
  const std::vector<int>& kept, const Eigen::MatrixXd& points)
{
  if (static_cast<Eigen::Index>(kept.size()) == points.rows())
  {
    return positions;
  }
  Eigen::MatrixXd all(points.rows(), positions.cols());
  const std::vector<int> indices = shape::InvertIndices(kept, points.rows());
  const shape::SurfaceLocator locator(surface);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (indices[i] >= 0)
    {
      all.row(i) = positions.row(indices[i]);
      continue;
    }
    const shape::ClosestPoint closest = locator.FindOne(points.row(i));
    all.row(i) =
      shape::PullBack({ Eigen::VectorXi::Constant(1, closest.Triangle), closest.Barycentric },
        surface.Triangles(), positions);
  }
  return all;
}

} // namespace

void vtkShapeParameterize::Execute(const shape::Progress& progress)
{
  const GatheredInput& whole = this->GetGatheredInput(0);
  const shape::Mesh repaired = vtkShapeConvert::ToMesh(whole.Data, "the surface");
  const std::vector<int> kept =
    FindKept(repaired, vtkShapeConvert::ToMesh(whole.Given, "the surface"));
  const shape::Surface mesh(vtkShapeConvert::Rows(repaired.Points, kept),
    shape::RenumberPoints(repaired.Triangles, kept, repaired.Points.rows()));
  std::vector<int> given; // the given point of each point of the mesh
  if (!whole.GivenPoints.empty())
  {
    for (const int point : kept)
    {
      given.push_back(whole.GivenPoints[point]);
    }
  }
  Eigen::MatrixXd landmarks(0, 3);
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    landmarks = vtkShapeConvert::ToPoints(this->GetGatheredInput(1).Grid);
  }
  const shape::ParameterizeResult map =
    shape::Parameterize(mesh, landmarks, this->Options, progress.Part(0.0, 0.93));
  progress(0.93);

  const Eigen::MatrixXd positions =
    vtkShapeConvert::Rows(Expand(map.Positions, mesh, kept, repaired.Points), whole.OwnPoints);
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  vtkDataObject* surface = this->GetOutputDataObject(0);
  vtkDataObject* image = this->GetOutputDataObject(1);
  vtkShapeComposite::AddPointFields(input, surface, { { "TargetPosition", positions } });
  const bool isCut = map.Cut.Surface.Triangles.rows() > 0;
  const vtkShapeCutImage cut(mesh, given, map.Cut, map.CutPositions);
  vtkIdType first = 0; // of this process's points, which are ordered by block
  vtkShapeComposite::ForEach(input, image, vtkShapeComposite::Points::Moved,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      const vtkIdType count = from->GetNumberOfPoints();
      const auto begin = whole.OwnPoints.begin() + first;
      first += count;
      if (isCut)
      {
        cut.Fill(from, { begin, begin + count }, to);
        return;
      }
      vtkShapeComposite::Move(from, positions.middleRows(first - count, count), to);
      to->GetPointData()->AddArray(
        vtkShapeConvert::ToArray(vtkShapeConvert::ToPoints(from), "SourcePosition"));
    });

  progress(0.96);
  vtkShapeMapColors::Add(surface, "", mesh);
  vtkShapeMapColors::Add(image, "SourcePosition", mesh);
  for (vtkDataObject* output : { surface, image })
  {
    vtkShapeConvert::AddFact(output, "Parameterize.Method", map.Method);
    vtkShapeConvert::AddFact(output, "Parameterize.Iterations", map.Iterations);
    vtkShapeConvert::AddFact(output, "Parameterize.ReinsertedPoints", map.ReinsertedPoints);
    vtkShapeConvert::AddFact(output, "Parameterize.MeasureBefore", map.MeasureBefore);
    vtkShapeConvert::AddFact(output, "Parameterize.MeasureAfter", map.MeasureAfter);
    vtkShapeConvert::AddFact(output, "Parameterize.FlippedTriangles", map.FlippedTriangles);
    vtkShapeConvert::AddFact(output, "Parameterize.ConformalDistortion", map.ConformalDistortion);
    vtkShapeConvert::AddFact(output, "Parameterize.Energy", map.Energy);
    vtkShapeConvert::AddFact(output, "Parameterize.LoopLength", map.LoopLength);
  }
}
