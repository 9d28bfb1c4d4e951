#include "vtkShapeCutCloud.h"

#include "vtkShapeCarry.h"
#include "vtkShapeCloud.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFeatureBase.h"
#include "vtkShapeFillValues.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Mesh/UsedPoints.h"

#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace
{

/// Returns the rows of the loop's points in a part.
std::vector<int> RowsOfLoop(
  const std::vector<int>& loop, const std::vector<int>& part, Eigen::Index all)
{
  const std::vector<int> rowOf = shape::InvertIndices(part, all);
  std::vector<int> rows;
  for (const int point : loop)
  {
    rows.push_back(rowOf[point]);
  }
  return rows;
}

/// Returns the fill with the data of the cloud, continued from the loop.
vtkSmartPointer<vtkPolyData> ContinueData(const shape::CutPointsResult& cut, vtkPolyData* cloud)
{
  auto patch = vtkSmartPointer<vtkPolyData>::New();
  vtkShapeConvert::FromMesh(cut.Fill, patch);
  shape::ProvenanceWriter writer(cloud->GetNumberOfPoints());
  for (const int point : cut.Loop)
  {
    writer.AddCopy(point);
  }
  for (Eigen::Index i = 0; i < cut.FillNormals.rows(); ++i)
  {
    writer.AddNearest(cut.Loop.front());
  }
  vtkShapeCarry::Carry(
    { { cloud, writer.Finish(Eigen::VectorXi::Constant(cut.Fill.Triangles.rows(), -1)) } }, patch);
  vtkShapeFillValues::Continue(cut.Fill, cut.Holes, 0, patch);
  return patch;
}

/// Writes a part: points of the cloud, and those of a fill, if there is one.
void WritePart(const std::vector<int>& points, const std::vector<int>& loop,
  const shape::CutPointsResult& cut, const shape::SampledSurface& samples, vtkPolyData* cloud,
  bool isFilled, vtkPolyData* output)
{
  const auto kept = static_cast<Eigen::Index>(points.size());
  const Eigen::Index added = isFilled ? cut.FillNormals.rows() : 0;
  Eigen::MatrixXd positions(kept + added, 3), normals(kept + added, 3);
  positions.topRows(kept) = samples.Surface.Points(points, Eigen::all);
  normals.topRows(kept) = samples.Normals(points, Eigen::all);
  positions.bottomRows(added) = cut.Fill.Points.bottomRows(added);
  normals.bottomRows(added) = cut.FillNormals.topRows(added);
  vtkShapeConvert::FromMesh({ positions, Eigen::MatrixXi(0, 3) }, output);
  vtkShapeCloud::WriteCells(loop, output);
  Eigen::VectorXi cells = Eigen::VectorXi::Constant(output->GetNumberOfCells(), -1);
  cells.head(kept) = vtkShapeCloud::FindVertices(cloud)(points);
  shape::ProvenanceWriter fromCloud(cloud->GetNumberOfPoints());
  for (const int point : points)
  {
    fromCloud.AddCopy(point);
  }
  fromCloud.AddNone(added);
  const shape::Provenance provenance = fromCloud.Finish(cells);
  if (added > 0)
  {
    const vtkSmartPointer<vtkPolyData> patch = ContinueData(cut, cloud);
    shape::ProvenanceWriter fromPatch(patch->GetNumberOfPoints());
    fromPatch.AddNone(kept);
    for (Eigen::Index i = 0; i < added; ++i)
    {
      fromPatch.AddCopy(static_cast<int>(cut.Loop.size() + static_cast<std::size_t>(i)));
    }
    vtkShapeCarry::Carry(
      { { cloud, provenance },
        { patch, fromPatch.Finish(Eigen::VectorXi::Constant(cells.size(), -1)) } },
      output);
  }
  else
  {
    vtkShapeCarry::Carry({ { cloud, provenance } }, output);
  }
  vtkDataArray* given = vtkShapeCarry::GetNormals(cloud->GetPointData());
  output->GetPointData()->SetNormals(
    vtkShapeConvert::ToArray(normals, given && given->GetName() ? given->GetName() : "Normals"));
  vtkShapeCarry::AddOriginals(provenance.Points, "OriginalPointId", output->GetPointData());
}

} // namespace

void vtkShapeCutCloud::Write(const shape::CutPointsResult& cut,
  const shape::SampledSurface& samples, vtkPolyData* cloud, vtkPolyData* feature, vtkPolyData* rest)
{
  const Eigen::Index all = samples.Surface.Points.rows();
  const bool isFilled = !cut.Holes.empty();
  WritePart(
    cut.Feature, RowsOfLoop(cut.Loop, cut.Feature, all), cut, samples, cloud, false, feature);
  std::vector<int> ids(cut.Feature.size());
  std::iota(ids.begin(), ids.end(), 0);
  vtkShapeFeatureBase::Write(cut.Bases, ids, false, feature);
  WritePart(cut.Rest, isFilled ? std::vector<int>() : RowsOfLoop(cut.Loop, cut.Rest, all), cut,
    samples, cloud, isFilled, rest);
  Eigen::VectorXi filled = Eigen::VectorXi::Zero(rest->GetNumberOfCells());
  filled.tail(isFilled ? cut.FillNormals.rows() : 0).setOnes();
  rest->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(filled, "Filled"));
}

void vtkShapeCutCloud::AddFacts(
  const shape::CutPointsResult& cut, double spacing, bool hasEstimatedNormals, vtkPolyData* output)
{
  const std::pair<const char*, double> facts[] = { { "Loops", 1.0 }, { "LoopsLeftOut", 0.0 },
    { "CutLength", cut.CutLength }, { "FeatureArea", cut.FeatureArea },
    { "Holes", static_cast<double>(cut.Holes.size()) }, { "WeldedPoints", 0.0 },
    { "PointCloud", 1.0 }, { "Spacing", spacing },
    { "EstimatedNormals", hasEstimatedNormals ? 1.0 : 0.0 } };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("CutFeature.") + fact, value);
  }
}
