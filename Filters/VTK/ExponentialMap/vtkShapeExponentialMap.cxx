#include "vtkShapeExponentialMap.h"

#include "vtkShapeCarry.h"
#include "vtkShapeCloud.h"
#include "vtkShapeLargeSize.h"
#include "vtkShapePatch.h"
#include "vtkShapePreciseMap.h"
#include "vtkShapeSeenInput.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Geometry/SampledSurface.h"

#include <utility>

vtkStandardNewMacro(vtkShapeExponentialMap);

struct vtkShapeExponentialMap::Kept
{
  vtkShapeSeenInput Input;
  shape::ExponentialMapOptions Options;
  vtkSmartPointer<vtkPolyData> Surface;
  Eigen::VectorXi Cells; ///< the surface's cell that each triangle is a part of
  std::unique_ptr<shape::ExponentialMap> Map;
  bool IsSampled = false;           ///< whether the surface consists of points
  Eigen::MatrixXd EstimatedNormals; ///< of its points, if it has none
};

vtkShapeExponentialMap::vtkShapeExponentialMap()
  : Cache(std::make_unique<Kept>())
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutput("vtkPolyData");
  this->DeclareFacts();
  this->DeclareMeasures({ "Normals", "GeodesicDistance", "ConformalDistortion",
    "SymmetricDirichlet", "Flipped", "Torn" });
}

vtkShapeExponentialMap::~vtkShapeExponentialMap() = default;

vtkShapeExponentialMap::Kept& vtkShapeExponentialMap::Update(const shape::Progress& progress)
{
  Kept& kept = *this->Cache;
  // The search structures of the map do not depend on the seed, so they are reused while it is
  // dragged.
  const bool isNew = kept.Input.IsNew(*this, 0, this->GetGatheredInput(0).Data);
  if (isNew || !kept.Map || kept.Options.NormalSmoothing != this->Options.NormalSmoothing ||
    kept.Options.UpwindAverage != this->Options.UpwindAverage)
  {
    kept.Map.reset();
    kept.Options = this->Options;
    kept.Surface = this->GetGatheredInput(0).Data;
    kept.IsSampled = vtkShapeCloud::IsPointCloud(kept.Surface);
    kept.EstimatedNormals.resize(0, 3);
    if (kept.IsSampled)
    {
      this->ConnectPoints(progress);
      return kept;
    }
    shape::NumberedSurface numbered = vtkShapePreciseMap::ToSurface(kept.Surface, "the Input");
    kept.Cells = std::move(numbered.Cells);
    kept.Map = std::make_unique<shape::ExponentialMap>(numbered.Surface, this->Options, progress);
  }
  return kept;
}

void vtkShapeExponentialMap::ConnectPoints(const shape::Progress& progress)
{
  Kept& kept = *this->Cache;
  shape::SampledSurface samples =
    vtkShapeCloud::Connect(kept.Surface, progress.Part(0.0, 0.8, "connecting the points"));
  kept.Cells = Eigen::VectorXi::Constant(samples.Shares.size(), -1);
  kept.Map =
    std::make_unique<shape::ExponentialMap>(samples, this->Options, progress.Part(0.8, 1.0));
  if (!vtkShapeCloud::HasNormals(kept.Surface))
  {
    kept.EstimatedNormals = std::move(samples.Normals);
  }
}

void vtkShapeExponentialMap::Execute(const shape::Progress& progress)
{
  // Every process has the complete input, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  const std::string warning =
    vtkShapeLargeSize::CheckRadius("Radius", this->Options.Radius, this->GetGatheredInput(0).Data);
  if (!warning.empty())
  {
    this->Warn(warning);
  }
  Kept& kept = this->Update(progress.Part(0.0, 0.7, "preparing the surface"));
  const shape::PatchLayout layout = shape::FlattenPatch(*kept.Map,
    Eigen::Map<const Eigen::RowVector3d>(this->Seed),
    Eigen::Map<const Eigen::RowVector3d>(this->XDirection), this->Options, progress.Part(0.7, 1.0));
  auto* output = vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
  if (kept.IsSampled)
  {
    vtkShapePatch::WritePoints(layout, kept.Surface, kept.EstimatedNormals, output);
  }
  else
  {
    vtkShapePatch::Write(layout, kept.Map->Surface(), kept.Surface, kept.Cells, output);
  }
  vtkShapeCarry::RenumberOriginals(this->GetGatheredInput(0).GivenPoints, output->GetPointData());
}
