#include "vtkShapePastedData.h"

#include "vtkShapeCarry.h"
#include "vtkShapeCloud.h"
#include "vtkShapeConvert.h"
#include "vtkShapeHandle.h"
#include "vtkShapePreciseMap.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "CutPaste/PointTarget.h"
#include "CutPaste/Seam.h"
#include "Geometry/SurfaceWelding.h"
#include "Mesh/UsedPoints.h"

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace
{

/// Returns the data of the feature. Point values that the target has, too, are changed near the
/// loop, so that they agree with the target's values there.
vtkSmartPointer<vtkPolyData> Blend(const shape::PastedFeature& pasted,
  const shape::FeatureToPaste& feature, const vtkShapePastedData::Part& target,
  const vtkShapePastedData::Part& featurePart, double width)
{
  const Eigen::VectorXd& depths = feature.Deformation().Arrivals();
  const double reach = width * depths.maxCoeff();
  const std::vector<int>& loop = feature.LoopPoints();
  const Eigen::MatrixXd& points = feature.Surface().Points();
  auto blended = vtkSmartPointer<vtkPolyData>::New();
  blended->ShallowCopy(featurePart.Data);
  vtkPointData* data = featurePart.Data->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* own = data->GetArray(i);
    vtkDataArray* array =
      own && own->GetName() ? target.Data->GetPointData()->GetArray(own->GetName()) : nullptr;
    if (!vtkShapeCarry::AreAlike(own, array) || !vtkShapeCarry::AreValues(own) ||
      own == vtkShapeCarry::GetNormals(data))
    {
      continue;
    }
    const Eigen::MatrixXd values = vtkShapeCarry::GetTuples(own);
    Eigen::MatrixXd differences = -vtkShapeConvert::Rows(values, loop);
    Eigen::Index row = 0;
    for (const shape::LoopOnTarget& landing : pasted.Landings)
    {
      const Eigen::MatrixXd there = shape::PullBack(
        landing.Cover.Positions, target.Surface.Triangles, vtkShapeCarry::GetTuples(array));
      differences.middleRows(row, there.rows()) += there;
      row += there.rows();
    }
    auto copy = vtkSmartPointer<vtkDataArray>::Take(own->NewInstance());
    copy->DeepCopy(own);
    vtkShapeCarry::SetTuples(shape::BlendAtSeam(values, points, differences,
                               vtkShapeConvert::Rows(points, loop), depths, reach),
      0, copy);
    blended->GetPointData()->AddArray(copy);
  }
  return blended;
}

/// Removes the normals that the parts had before they were pasted, and adds new ones, if there are
/// any, under the name of the old ones.
void ReplaceNormals(const Eigen::MatrixXd& normals, vtkPolyData* output)
{
  std::string name = "Normals";
  for (vtkDataSetAttributes* data : { static_cast<vtkDataSetAttributes*>(output->GetCellData()),
         static_cast<vtkDataSetAttributes*>(output->GetPointData()) })
  {
    while (vtkDataArray* old = vtkShapeCarry::GetNormals(data))
    {
      name = old->GetName() ? old->GetName() : name;
      old->SetName(name.c_str()); // only arrays with a name can be removed
      data->RemoveArray(name.c_str());
    }
  }
  if (normals.rows() > 0)
  {
    output->GetPointData()->SetNormals(vtkShapeConvert::ToArray(normals, name));
  }
}

} // namespace

vtkShapePastedData::Part vtkShapePastedData::Read(
  vtkPolyData* data, const std::string& name, const shape::Progress& progress)
{
  const shape::NumberedSurface numbered = vtkShapePreciseMap::ToSurface(data, name);
  const shape::WeldedSurface welded(numbered.Surface, progress, name);
  const Eigen::Index all = welded.Surface.Points.rows();
  const std::vector<int> used = shape::FindUsedPoints(welded.Surface.Triangles, all);
  Part part;
  part.Surface = { welded.Surface.Points(used, Eigen::all),
    shape::RenumberPoints(welded.Surface.Triangles, used, all) };
  part.Data = vtkSmartPointer<vtkPolyData>::New();
  vtkShapeConvert::FromMesh(part.Surface, part.Data);
  const shape::Provenance provenance =
    shape::TraceCopies(used, all, numbered.Cells(welded.Triangles));
  vtkShapeCarry::Carry({ { data, provenance } }, part.Data);
  part.WeldedPoints = welded.WeldedPoints;
  return part;
}

vtkShapePastedData::Part vtkShapePastedData::ReadCloud(
  vtkPolyData* data, const shape::Progress& progress)
{
  Part part;
  part.Samples = vtkShapeCloud::Connect(data, progress);
  part.Surface = part.Samples.Surface;
  part.Data = data;
  return part;
}

vtkShapePastedData::Part vtkShapePastedData::SamplePart(
  const Part& part, double spacing, const shape::Progress& progress)
{
  shape::SurfaceSamples samples = shape::SampleTriangles(part.Surface, spacing, progress);
  Part sampled;
  sampled.Samples = std::move(samples.Samples);
  sampled.Surface = sampled.Samples.Surface;
  sampled.Data = vtkSmartPointer<vtkPolyData>::New();
  vtkShapeConvert::FromMesh({ sampled.Surface.Points, Eigen::MatrixXi(0, 3) }, sampled.Data);
  vtkShapeCarry::Carry({ { part.Data, samples.Origin } }, sampled.Data);
  sampled.WeldedPoints = part.WeldedPoints;
  return sampled;
}

Eigen::MatrixXd vtkShapePastedData::NormalsOf(const Part& part, const shape::Progress& progress)
{
  constexpr double asItIs = std::numeric_limits<double>::infinity();
  return part.Samples.Normals.rows() > 0
    ? part.Samples.Normals
    : shape::SampleTriangles(part.Surface, asItIs, progress).Samples.Normals;
}

void vtkShapePastedData::Write(const shape::PastedFeature& pasted,
  const shape::FeatureToPaste& feature, const Part& target, const Part& featurePart,
  double blendWidth, vtkPolyData* output)
{
  vtkShapeConvert::FromMesh(pasted.Surface, output);
  const vtkSmartPointer<vtkPolyData> blended =
    Blend(pasted, feature, target, featurePart, blendWidth);
  vtkShapeCarry::Carry({ { target.Data, pasted.Target }, { blended, pasted.Feature } }, output);
  ReplaceNormals(pasted.Normals, output);
  if (pasted.IsOfPoints)
  {
    vtkShapeCloud::WriteCells({}, output);
    const Eigen::Index points = pasted.Surface.Points.rows();
    const Eigen::Index ofFeature = feature.Surface().Points().rows();
    Eigen::VectorXi parts = Eigen::VectorXi::Zero(points);
    parts.segment(points - ofFeature - pasted.AddedPoints, pasted.AddedPoints).setOnes();
    parts.tail(ofFeature).setConstant(2);
    output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(parts, "Part"));
    return;
  }
  const Eigen::Index all = pasted.Surface.Triangles.rows();
  Eigen::VectorXi parts =
    (pasted.Feature.Cells.array() >= 0).select(Eigen::VectorXi::Constant(all, 2), 0);
  const Eigen::Index ofBoth = (parts.array() == 0).count();
  parts.segment(ofBoth - pasted.BandTriangles, pasted.BandTriangles).setOnes();
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(parts, "Part"));
}

void vtkShapePastedData::WriteLoop(
  const shape::PastedFeature& pasted, const shape::FeatureToPaste& feature, vtkPolyData* output)
{
  const shape::BoundaryHandle& handle = feature.LoopHandle();
  const shape::HandleTarget& loop = pasted.Loop;
  vtkShapeHandle::WriteCells(handle, loop.Positions, output);
  const std::pair<const char*, const Eigen::MatrixXd&> arrays[] = {
    { "SourcePosition", handle.Positions }, { "SourceNormal", handle.Normals },
    { "TargetNormal", loop.Normals }, { "FrameRotation", loop.Turns.Turns }
  };
  for (const auto& [name, values] : arrays)
  {
    output->GetPointData()->AddArray(vtkShapeConvert::ToArray(values, name));
  }
  output->GetPointData()->AddArray(vtkShapeConvert::ToIntegers(loop.Turns.IsSet, "FrameSet"));
}
