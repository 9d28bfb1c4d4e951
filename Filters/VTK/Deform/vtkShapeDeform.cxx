#include "vtkShapeDeform.h"

#include "vtkShapeConvert.h"
#include "vtkShapeHandle.h"
#include "vtkShapeList.h"
#include "vtkShapeSeenInput.h"

#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Deform/Deform.h"
#include "Mesh/BoundaryLoops.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkShapeDeform);

namespace
{

constexpr std::size_t MotionWidth = 8, FrameWidth = 6;

/// Converts three of the numbers of a list, which are degrees, to radians.
Eigen::Vector3d ToRadians(const double* degrees)
{
  return Eigen::Map<const Eigen::Vector3d>(degrees) * (3.14159265358979323846 / 180.0);
}

shape::HandleMotion ToMotion(const std::vector<double>& motions, const std::vector<double>& frames)
{
  shape::HandleMotion motion;
  for (std::size_t i = 0; i < motions.size(); i += MotionWidth)
  {
    const double* row = &motions[i];
    if (row[0] != std::floor(row[0]) || std::abs(row[0]) > std::numeric_limits<int>::max())
    {
      throw shape::InvalidInput("HandleMotions moves part " + std::to_string(row[0]) +
        ", which is no part; give a whole number: 0 for the longest part, 1 for the next");
    }
    motion.Parts.push_back({ static_cast<int>(row[0]), Eigen::Vector3d(row[1], row[2], row[3]),
      ToRadians(row + 4), row[7] });
  }
  for (std::size_t i = 0; i < frames.size(); i += FrameWidth)
  {
    const double* row = &frames[i];
    motion.Frames.push_back({ Eigen::Vector3d(row[0], row[1], row[2]), ToRadians(row + 3) });
  }
  return motion;
}

} // namespace

/// The weights, what was read from the inputs and the boundary of the last surface.
struct vtkShapeDeform::Kept
{
  /// Returns the boundary of the surface, as a handle at rest.
  const shape::BoundaryHandle& FindBoundary(const shape::ShapeElements& shape)
  {
    const bool isKnown = this->Surface.Points.rows() == shape.Points.rows() &&
      this->Surface.Triangles.rows() == shape.Triangles.rows() &&
      this->Surface.Points == shape.Points && this->Surface.Triangles == shape.Triangles;
    if (!isKnown)
    {
      this->Surface = { shape.Points, shape.Triangles };
      const std::vector<std::vector<int>> loops = shape::FindBoundaryLoops(this->Surface).Loops;
      this->Boundary = shape::BuildLoopsHandle(shape.Points, loops);
      this->BoundaryPoints.clear();
      for (const std::vector<int>& loop : loops)
      {
        this->BoundaryPoints.insert(this->BoundaryPoints.end(), loop.begin(), loop.end());
      }
    }
    if (this->Boundary.Positions.rows() == 0)
    {
      throw shape::InvalidInput("the Input has no boundary curve; connect a curve, a surface or "
                                "points on it to Boundary");
    }
    return this->Boundary;
  }

  /// Returns the shape, which is read from the grid only if the input has changed.
  const shape::ShapeElements& ReadShape(
    vtkShapeDeform& filter, vtkUnstructuredGrid* grid, const shape::Progress& progress)
  {
    if (this->Input.IsNew(filter, 0, grid) || !this->Shape)
    {
      this->Shape.reset(); // an error below must not leave the last shape
      this->Unmoved.clear();
      this->Shape = vtkShapeHandle::ToElements(grid, "the Input", progress);
    }
    return *this->Shape;
  }

  std::vector<vtkShapeHandle::Unmoved> Unmoved; ///< of the output
  shape::Deformer Deformer;
  std::vector<int> BoundaryPoints; ///< the point of the surface that each sample is

private:
  vtkShapeSeenInput Input;
  std::optional<shape::ShapeElements> Shape;
  shape::Mesh Surface;
  shape::BoundaryHandle Boundary;
};

vtkShapeDeform::vtkShapeDeform()
  : Cache(std::make_unique<Kept>())
{
  this->DeclareInput("Input", PortData::WholeGrid, PortUse::Required, { "vtkDataSet" });
  this->DeclareInput("Boundary", PortData::WholeGrid, PortUse::Optional, { "vtkDataSet" });
  this->DeclareMovedOutput();
  this->DeclareOutput("vtkPolyData");
  this->DeclareFacts();
  this->DeclareMeasures({ "Normals", "ArrivalTime", "Protrusion" });
}

vtkShapeDeform::~vtkShapeDeform() = default;

void vtkShapeDeform::SetNumberOfHandleMotions(int count)
{
  vtkShapeList::Resize(this, this->HandleMotions, count, MotionWidth);
}

void vtkShapeDeform::SetHandleMotions(int index, double part, double x, double y, double z,
  double rotationX, double rotationY, double rotationZ, double scale)
{
  vtkShapeList::Set(this, "Handle Motions", this->HandleMotions, index,
    { part, x, y, z, rotationX, rotationY, rotationZ, scale });
}

void vtkShapeDeform::SetNumberOfFrameRotations(int count)
{
  vtkShapeList::Resize(this, this->FrameRotations, count, FrameWidth);
}

void vtkShapeDeform::SetFrameRotations(
  int index, double x, double y, double z, double rotationX, double rotationY, double rotationZ)
{
  vtkShapeList::Set(this, "Frame Rotations", this->FrameRotations, index,
    { x, y, z, rotationX, rotationY, rotationZ });
}

void vtkShapeDeform::Execute(const shape::Progress& progress)
{
  vtkUnstructuredGrid* grid = this->GetGatheredInput(0).Grid;
  shape::DeformProblem problem;
  problem.Shape = this->Cache->ReadShape(*this, grid, progress.Part(0.0, 0.1));
  vtkShapeHandle::Boundary boundary;
  vtkUnstructuredGrid* handleGrid = grid;
  std::vector<int> handlePoints;
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    handleGrid = this->GetGatheredInput(1).Grid;
    boundary = vtkShapeHandle::Read(handleGrid, problem.Shape);
    handlePoints.resize(static_cast<std::size_t>(handleGrid->GetNumberOfPoints()));
    std::iota(handlePoints.begin(), handlePoints.end(), 0);
  }
  else
  {
    boundary.Source = this->Cache->FindBoundary(problem.Shape);
    boundary.Target.Positions = boundary.Source.Positions;
    handlePoints = this->Cache->BoundaryPoints;
  }
  boundary.Target.Motion = ToMotion(this->HandleMotions, this->FrameRotations);
  problem.Handle = std::move(boundary.Source);
  problem.Fields = this->ReadFields(grid, "the Input");
  problem.Options = this->Options;
  shape::Deformer& deformer = this->Cache->Deformer;
  const shape::DeformedShape deformed =
    deformer.Deform(problem, boundary.Target, this->Frames, progress.Part(0.1, 0.95));

  if (deformer.HasPrepared())
  {
    this->Cache->Unmoved.clear(); // other arrival times
  }
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeHandle::Write(
    this->GetInputDataObject(0, 0), problem.Shape.Points, deformed, this->Cache->Unmoved, output);
  const shape::HandleParts parts = shape::FindHandleParts(problem.Handle);
  // Every process has the complete handle, and one of them writes it.
  if (!this->GetController() || this->GetController()->GetLocalProcessId() == 0)
  {
    vtkShapeHandle::WriteHandle(problem.Handle, deformer, parts, boundary.Target.Motion.Frames,
      handleGrid, handlePoints, vtkPolyData::SafeDownCast(this->GetOutputDataObject(1)));
  }
  const shape::DeformFacts& facts = deformer.Facts();
  const std::pair<const char*, double> all[] = { { "Parts", parts.Count },
    { "Islands", facts.Islands }, { "EmptyBands", facts.EmptyBands },
    { "ZeroWeights", facts.ZeroWeights }, { "WeldedPoints", facts.WeldedPoints },
    { "Segments", facts.Segments }, { "BasePoints", facts.BasePoints },
    { "Streamed", facts.Streamed ? 1.0 : 0.0 },
    { "Prepared", deformer.HasPrepared() ? 1.0 : 0.0 } };
  for (const auto& [fact, value] : all)
  {
    vtkShapeConvert::AddFact(output, std::string("Deform.") + fact, value);
  }
}
