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

void vtkShapeParameterize::Execute(const shape::Progress& progress)
{
  const GatheredInput& whole = this->GetGatheredInput(0);
  const shape::Surface mesh = vtkShapeConvert::ToMesh(whole.Data, "the surface");
  Eigen::MatrixXd landmarks(0, 3);
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    landmarks = vtkShapeConvert::ToPoints(this->GetGatheredInput(1).Grid);
  }
  const shape::ParameterizeResult map =
    shape::Parameterize(mesh, landmarks, this->Options, progress.Part(0.0, 0.93));
  progress(0.93);

  const Eigen::MatrixXd positions = vtkShapeConvert::Rows(map.Positions, whole.OwnPoints);
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  vtkDataObject* surface = this->GetOutputDataObject(0);
  vtkDataObject* image = this->GetOutputDataObject(1);
  vtkShapeComposite::AddPointFields(input, surface, { { "TargetPosition", positions } });
  const bool isCut = map.Cut.Surface.Triangles.rows() > 0;
  const vtkShapeCutImage cut(mesh, whole.GivenPoints, map.Cut, map.CutPositions);
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
    vtkShapeConvert::AddFact(output, "Parameterize.FlippedTriangles", map.FlippedTriangles);
    vtkShapeConvert::AddFact(output, "Parameterize.ConformalDistortion", map.ConformalDistortion);
    vtkShapeConvert::AddFact(output, "Parameterize.Energy", map.Energy);
    vtkShapeConvert::AddFact(output, "Parameterize.LoopLength", map.LoopLength);
  }
}
