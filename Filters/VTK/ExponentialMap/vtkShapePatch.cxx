#include "vtkShapePatch.h"

#include "vtkShapeCarry.h"
#include "vtkShapeCloud.h"
#include "vtkShapeConvert.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <string>
#include <utility>
#include <vector>

namespace
{

Eigen::VectorXi Marked(const std::vector<int>& rows, Eigen::Index count)
{
  Eigen::VectorXi marks = Eigen::VectorXi::Zero(count);
  for (const int row : rows)
  {
    marks(row) = 1;
  }
  return marks;
}

void AddPointData(const shape::PatchLayout& layout, vtkPointData* fields)
{
  const shape::ExponentialPatch& patch = layout.Patch;
  vtkShapeCarry::AddOriginals(layout.Provenance.Points, "OriginalPointId", fields);
  Eigen::MatrixXd flat = Eigen::MatrixXd::Zero(patch.Positions.rows(), 3);
  flat.leftCols(2) = patch.Positions;
  fields->AddArray(vtkShapeConvert::ToArray(flat, "TargetPosition"));
  fields->AddArray(vtkShapeConvert::ToArray(patch.Distances, "GeodesicDistance"));
  // The disk of the given radius fills the unit square of the texture.
  const Eigen::MatrixXd texture = (patch.Positions.array() / (2.0 * layout.Radius) + 0.5).matrix();
  fields->AddArray(vtkShapeConvert::ToArray(texture, "ExponentialMap"));
  fields->SetActiveTCoords("ExponentialMap");
}

void AddCellData(const shape::PatchLayout& layout, vtkCellData* fields)
{
  const shape::ExponentialPatch& patch = layout.Patch;
  const Eigen::Index count = patch.Corners.rows();
  fields->AddArray(vtkShapeConvert::ToIntegers(Marked(patch.Flipped, count), "Flipped"));
  fields->AddArray(vtkShapeConvert::ToIntegers(Marked(patch.Torn, count), "Torn"));
  fields->AddArray(
    vtkShapeConvert::ToArray(layout.Facts.ConformalDistortions, "ConformalDistortion"));
  fields->AddArray(
    vtkShapeConvert::ToArray(layout.Facts.SymmetricDirichlets, "SymmetricDirichlet"));
}

void WriteFacts(const shape::PatchLayout& layout, bool hasEstimatedNormals, vtkPolyData* output)
{
  const shape::ExponentialPatch& patch = layout.Patch;
  const shape::ExponentialFacts& facts = layout.Facts;
  const std::string prefix = "ExponentialMap.";
  const std::pair<const char*, Eigen::RowVector3d> vectors[] = { { "Seed", patch.Seed.Origin },
    { "SeedNormal", patch.Seed.Normal }, { "XAxis", patch.Seed.XAxis } };
  for (const auto& [name, vector] : vectors)
  {
    output->GetFieldData()->AddArray(vtkShapeConvert::ToArray(vector, prefix + name));
  }
  const std::pair<const char*, shape::DistortionStatistics> spreads[] = {
    { "ConformalDistortion", facts.ConformalDistortion },
    { "SymmetricDirichlet", facts.SymmetricDirichlet }
  };
  for (const auto& [name, spread] : spreads)
  {
    output->GetFieldData()->AddArray(vtkShapeConvert::ToArray(
      Eigen::RowVector2d(spread.Median, spread.Percentile95), prefix + name));
  }
  const std::pair<const char*, double> numbers[] = { { "SeedDistance", layout.SeedDistance },
    { "Radius", layout.Radius }, { "Flipped", static_cast<double>(patch.Flipped.size()) },
    { "Torn", static_cast<double>(patch.Torn.size()) }, { "FlipRate", facts.FlipRate },
    { "Mended", layout.Mended }, { "Coverage", facts.Coverage },
    { "Overlaps", facts.Overlaps ? 1.0 : 0.0 }, { "ReachesRim", patch.ReachesBoundary ? 1.0 : 0.0 },
    { "LocalTriangles", static_cast<double>(patch.Shares.size()) },
    { "EstimatedNormals", hasEstimatedNormals ? 1.0 : 0.0 } };
  for (const auto& [name, number] : numbers)
  {
    vtkShapeConvert::AddFact(output, prefix + name, number);
  }
}

} // namespace

void vtkShapePatch::Write(const shape::PatchLayout& layout, const shape::Mesh& mesh,
  vtkPolyData* surface, const Eigen::VectorXi& cells, vtkPolyData* output)
{
  vtkShapeConvert::FromMesh(shape::BuildPatchSurface(mesh, layout.Patch), output);
  shape::Provenance provenance = layout.Provenance;
  provenance.Cells = shape::ComposeIndices(cells, layout.Provenance.Cells);
  vtkShapeCarry::Carry({ { surface, provenance } }, output);
  AddPointData(layout, output->GetPointData());
  AddCellData(layout, output->GetCellData());
  WriteFacts(layout, false, output);
}

void vtkShapePatch::WritePoints(const shape::PatchLayout& layout, vtkPolyData* cloud,
  const Eigen::MatrixXd& estimatedNormals, vtkPolyData* output)
{
  const std::vector<int>& points = layout.Patch.Points;
  vtkShapeConvert::FromMesh(
    { vtkShapeConvert::Rows(vtkShapeConvert::ToPoints(cloud), points), Eigen::MatrixXi(0, 3) },
    output);
  vtkShapeCloud::WriteCells({}, output);
  shape::Provenance provenance = layout.Provenance;
  provenance.Cells = vtkShapeCloud::FindVertices(cloud)(points);
  vtkShapeCarry::Carry({ { cloud, provenance } }, output);
  AddPointData(layout, output->GetPointData());
  if (estimatedNormals.rows() > 0)
  {
    output->GetPointData()->SetNormals(
      vtkShapeConvert::ToArray(vtkShapeConvert::Rows(estimatedNormals, points), "Normals"));
  }
  WriteFacts(layout, estimatedNormals.rows() > 0, output);
}
