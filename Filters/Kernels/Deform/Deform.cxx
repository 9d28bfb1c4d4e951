#include "Deform/Deform.h"

#include "Deform/DeformOptions.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

template <typename Matrix>
bool AreSame(const Matrix& a, const Matrix& b)
{
  return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
}

std::vector<int> OrderByPosition(const Eigen::MatrixXd& points)
{
  std::vector<int> order(points.rows());
  std::iota(order.begin(), order.end(), 0);
  // The index makes the order of coincident points unique.
  const auto key = [&](int i)
  { return std::make_tuple(points(i, 0), points(i, 1), points(i, 2), i); };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  return order;
}

/// The elements over renumbered points, in order. Corners out of range stay so.
Eigen::MatrixXi Sorted(const Eigen::MatrixXi& elements, const std::vector<int>& number)
{
  std::vector<std::vector<int>> rows;
  for (const auto& element : elements.rowwise())
  {
    rows.emplace_back();
    for (const int point : element)
    {
      const bool known = point >= 0 && point < static_cast<int>(number.size());
      rows.back().push_back(known ? number[point] : point);
    }
  }
  std::sort(rows.begin(), rows.end());
  Eigen::MatrixXi sorted(elements.rows(), elements.cols());
  for (Eigen::Index i = 0; i < sorted.rows(); ++i)
  {
    sorted.row(i) = Eigen::Map<const Eigen::RowVectorXi>(rows[i].data(), sorted.cols());
  }
  return sorted;
}

ShapeElements Sorted(const ShapeElements& shape, const std::vector<int>& order)
{
  std::vector<int> number(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    number[order[i]] = static_cast<int>(i);
  }
  return { shape.Points(order, Eigen::all), Sorted(shape.Lines, number),
    Sorted(shape.Triangles, number), Sorted(shape.Tetrahedra, number) };
}

/// A field of a wrong size is returned as it is: RequireFields reports it.
template <typename Field>
Field Sorted(const Field& field, const std::vector<int>& order)
{
  return field.size() == static_cast<Eigen::Index>(order.size()) ? Field(field(order)) : field;
}

} // namespace

/// The order matters, since rotations do not commute: first the rotation that the curve determines,
/// then the user's. Frames rotate before their part moves, so that they move with it.
HandlePose PoseHandleAt(const BoundaryHandle& handle, const HandleTarget& target,
  const PoseOptions& options, const Eigen::MatrixXd& normals)
{
  HandlePose pose = PoseHandle(handle, target.Positions, target.Normals);
  if (target.Turns.Turns.rows() > 0)
  {
    AddPrescribedRotations(handle, target.Turns, pose);
  }
  if (!target.Motion.Frames.empty())
  {
    AddPrescribedRotations(handle, PrescribeRotations(handle, target.Motion.Frames), pose);
  }
  MoveParts(handle, target.Motion.Parts, pose);
  BiasFrames(handle, normals, options, pose);
  return pose;
}

bool Deformer::HasShape(const ShapeElements& shape) const
{
  const ShapeElements& own = this->Problem.Shape;
  return this->Graph.Size() > 0 && AreSame(shape.Points, own.Points) &&
    AreSame(shape.Lines, own.Lines) && AreSame(shape.Triangles, own.Triangles) &&
    AreSame(shape.Tetrahedra, own.Tetrahedra);
}

bool Deformer::Fits(const DeformProblem& problem) const
{
  const DeformProblem& own = this->Problem;
  return this->Deformation && problem.Options == own.Options &&
    AreSame(problem.Handle.Positions, own.Handle.Positions) &&
    AreSame(problem.Handle.Segments, own.Handle.Segments) &&
    AreSame(problem.Handle.Triangles, own.Handle.Triangles) &&
    AreSame(problem.Fields.Rigidity, own.Fields.Rigidity) &&
    AreSame(problem.Fields.Scale, own.Fields.Scale) &&
    AreSame(problem.Fields.Segments, own.Fields.Segments);
}

DeformedShape Deformer::Deform(const DeformProblem& problem, const HandleTarget& target,
  const PoseOptions& options, const Progress& progress)
{
  const bool hasShape = this->HasShape(problem.Shape);
  // Weights depend on the shape and the handle at rest (section 2.3 caches them too); a moved
  // target takes only the last step.
  this->Fresh = !hasShape || !this->Fits(problem);
  if (this->Fresh)
  {
    // If this fails or is aborted, nothing can be reused afterwards.
    this->Deformation.reset();
    if (!hasShape)
    {
      this->Graph = {};
    }
    this->Problem = problem;
    RequireFields(problem.Fields, problem.Shape.Points.rows());
    if (!hasShape)
    {
      RequireFinite(problem.Shape.Points, "the shape");
      this->Order = OrderByPosition(problem.Shape.Points);
      this->Graph = BuildPointGraph(
        Sorted(problem.Shape, this->Order), {}, progress.Part(0.0, 0.2, "connecting the points"));
    }
    const DeformFields& fields = problem.Fields;
    this->Deformation = PrepareDeformation(this->Graph, problem.Handle, problem.Options,
      { Sorted(fields.Rigidity, this->Order), Sorted(fields.Scale, this->Order),
        Sorted(fields.Segments, this->Order) },
      progress.Part(0.2, 0.8));
    const BoundaryHandle& handle = problem.Handle;
    this->ShapeNormals = ComputeHandleNormals(
      { handle.Positions, handle.Segments, handle.Triangles, {} }, this->Graph);
  }
  const bool hasNormals = problem.Handle.Normals.size() > 0;
  this->LastPose = PoseHandleAt(
    problem.Handle, target, options, hasNormals ? problem.Handle.Normals : this->ShapeNormals);
  this->LastNormals = hasNormals ? problem.Handle.Normals : this->ShapeNormals;
  const DeformedShape sorted = this->Deformation->Deform(this->LastPose,
    std::numeric_limits<double>::infinity(), progress.Part(0.8, 1.0, "moving the points"));
  DeformedShape deformed{ Eigen::MatrixXd(sorted.Points.rows(), 3),
    std::vector<Eigen::Matrix3d>(sorted.Rotations.size()), Eigen::VectorXd(sorted.Points.rows()) };
  for (std::size_t i = 0; i < this->Order.size(); ++i)
  {
    deformed.Points.row(this->Order[i]) = sorted.Points.row(static_cast<Eigen::Index>(i));
    deformed.Rotations[this->Order[i]] = sorted.Rotations[i];
    deformed.Arrivals(this->Order[i]) = this->Deformation->Arrivals()(static_cast<Eigen::Index>(i));
  }
  const Eigen::VectorXi& protrusions = this->Deformation->Protrusions();
  deformed.Protrusions.resize(protrusions.size());
  for (Eigen::Index i = 0; i < protrusions.size(); ++i)
  {
    deformed.Protrusions(this->Order[i]) = protrusions(i);
  }
  return deformed;
}

} // namespace shape
