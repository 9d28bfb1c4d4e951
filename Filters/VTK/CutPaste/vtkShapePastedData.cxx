#include "vtkShapePastedData.h"

#include "vtkShapeCarry.h"
#include "vtkShapeConvert.h"
#include "vtkShapePreciseMap.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "CutPaste/Seam.h"
#include "Geometry/SurfaceWelding.h"
#include "Mesh/UsedPoints.h"

#include <string>
#include <utility>
#include <vector>

namespace
{

/// The feature's data, its values blended with the target's at the loop.
vtkSmartPointer<vtkPolyData> Blend(const shape::PastedFeature& pasted,
  const shape::FeatureToPaste& feature, const vtkShapePastedData::Part& target,
  const vtkShapePastedData::Part& featurePart, double width)
{
  const Eigen::VectorXd& depths = feature.Deformation().Arrivals();
  const double reach = width * depths.maxCoeff();
  const std::vector<int>& loop = feature.Base().Loop;
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
    const Eigen::MatrixXd values = vtkShapeCarry::GetTuples(own, featurePart.Points);
    const Eigen::MatrixXd differences =
      shape::PullBack(pasted.Position.Cover.Positions, target.Surface.Triangles,
        vtkShapeCarry::GetTuples(array, target.Points)) -
      vtkShapeConvert::Rows(values, loop);
    auto copy = vtkSmartPointer<vtkDataArray>::Take(own->NewInstance());
    copy->DeepCopy(own);
    vtkShapeCarry::SetTuples(shape::BlendAtSeam(values, points, differences,
                               vtkShapeConvert::Rows(points, loop), depths, reach),
      featurePart.Points, copy);
    blended->GetPointData()->AddArray(copy);
  }
  return blended;
}

} // namespace

vtkShapePastedData::Part vtkShapePastedData::Read(
  vtkPolyData* data, const std::string& name, const shape::Progress& progress)
{
  const shape::NumberedSurface numbered = vtkShapePreciseMap::ToSurface(data, name);
  const shape::WeldedSurface welded(numbered.Surface, progress, name);
  const Eigen::Index all = welded.Surface.Points.rows();
  Part part;
  part.Data = data;
  part.Points = shape::FindUsedPoints(welded.Surface.Triangles, all);
  part.Surface = { welded.Surface.Points(part.Points, Eigen::all),
    shape::RenumberPoints(welded.Surface.Triangles, part.Points, all) };
  part.Provenance = shape::TraceCopies(part.Points, all, numbered.Cells(welded.Triangles));
  part.WeldedPoints = welded.WeldedPoints;
  return part;
}

void vtkShapePastedData::Write(const shape::PastedFeature& pasted,
  const shape::FeatureToPaste& feature, const Part& target, const Part& featurePart,
  double blendWidth, vtkPolyData* output)
{
  vtkShapeConvert::FromMesh(pasted.Surface, output);
  const vtkSmartPointer<vtkPolyData> blended =
    Blend(pasted, feature, target, featurePart, blendWidth);
  const shape::Provenance ofTarget = shape::Compose(target.Provenance, pasted.Target);
  const shape::Provenance ofFeature = shape::Compose(featurePart.Provenance, pasted.Feature);
  vtkShapeCarry::Carry({ { target.Data, ofTarget }, { blended, ofFeature } }, output);

  const Eigen::Index all = pasted.Surface.Triangles.rows();
  Eigen::VectorXi parts =
    (pasted.Feature.Cells.array() >= 0).select(Eigen::VectorXi::Constant(all, 2), 0);
  const Eigen::Index ofBoth = (parts.array() == 0).count();
  parts.segment(ofBoth - pasted.BandTriangles, pasted.BandTriangles).setOnes();
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(parts, "Part"));
}
