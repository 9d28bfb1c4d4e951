#include "Deform/HandleFrames.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Deform/Private/LaplacianSmoothing.h"
#include "Geometry/RotationVector.h"
#include "Mesh/Mesh.h"
#include "Search/PointTree.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Pairs of neighbouring samples of the handle; of coincident samples, the first one stands for
/// all.
std::vector<std::pair<int, int>> HandleLinks(
  const BoundaryHandle& handle, const std::vector<int>& first)
{
  std::vector<std::pair<int, int>> links;
  const auto add = [&](int a, int b)
  {
    if (first[a] != first[b])
    {
      links.emplace_back(std::min(first[a], first[b]), std::max(first[a], first[b]));
    }
  };
  for (const auto& segment : handle.Segments.rowwise())
  {
    add(segment(0), segment(1));
  }
  for (const auto& triangle : handle.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      add(triangle(k), triangle((k + 1) % 3));
    }
  }
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

} // namespace

/// Between the samples where rotations are prescribed, rotation vectors are harmonic on the
/// handle's graph. Quaternions would lose full turns.
Eigen::MatrixXd InterpolateRotations(const BoundaryHandle& handle, const PrescribedRotations& turns)
{
  const auto samples = static_cast<int>(handle.Positions.rows());
  if (turns.Turns.rows() != samples || turns.Turns.cols() != 3 || turns.IsSet.size() != samples)
  {
    throw InvalidInput("the handle has " + std::to_string(samples) + " points, but rotations for " +
      std::to_string(turns.Turns.rows()) +
      "; give each point a rotation of three numbers, and a flag");
  }
  const std::vector<int> first = GetFirstSamples(handle);
  const std::vector<std::pair<int, int>> links = HandleLinks(handle, first);
  DisjointSets components(samples);
  for (const auto& [a, b] : links)
  {
    components.Merge(a, b);
  }
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(samples, 3);
  std::vector<char> given(samples, 0), reached(samples, 0);
  for (int i = 0; i < samples; ++i)
  {
    if (turns.IsSet(i) != 0 && !given[first[i]])
    {
      if (!turns.Turns.row(i).allFinite())
      {
        throw InvalidInput("the rotation that is prescribed at point " + std::to_string(i) +
          " of the handle is not finite; prescribe finite numbers");
      }
      given[first[i]] = 1;
      values.row(first[i]) = turns.Turns.row(i);
      reached[components.Find(first[i])] = 1;
    }
  }
  // Free are the other samples of these components: along a curve, weights 1 / length make the
  // solution linear in length.
  std::vector<int> fixed;
  for (int i = 0; i < samples; ++i)
  {
    if (first[i] != i || given[i] || !reached[components.Find(i)])
    {
      fixed.push_back(i);
    }
  }
  const Eigen::SparseMatrix<double> laplacian = BuildGraphLaplacian(handle.Positions, links);
  DirichletProblem(laplacian, fixed).Solve(values, Eigen::MatrixXd::Zero(samples, 3));
  return values(first, Eigen::all);
}

void AddPrescribedRotations(
  const BoundaryHandle& handle, const PrescribedRotations& turns, HandlePose& pose)
{
  const Eigen::MatrixXd values = InterpolateRotations(handle, turns);
  for (Eigen::Index i = 0; i < values.rows(); ++i)
  {
    pose.Rotations[i] = ToRotation(values.row(i).transpose()) * pose.Rotations[i];
  }
}

void RequireOptions(const PoseOptions& options)
{
  RequireOption(options.BiasWeight >= 0.0 && options.BiasWeight <= 1.0, "BiasWeight",
    options.BiasWeight, "at least 0 and at most 1");
  const double length = Eigen::Map<const Eigen::Vector3d>(options.BiasFrame.data()).norm();
  // A direction without effect may be 0.
  const bool hasEffect =
    options.BiasWeight != 0.0 && options.BiasBy == PoseOptions::BiasByType::Direction;
  RequireOption(std::isfinite(length) && (length > 0.0 || !hasEffect), "the length of BiasFrame",
    length, "positive and finite");
  const double angle = Eigen::Map<const Eigen::Vector3d>(options.BiasRotation.data()).norm();
  RequireOption(std::isfinite(angle), "the angle of BiasRotation", angle, "finite");
}

/// Section 2.2: interpolation between the original frame and the bias frame by alpha.
void BiasFrames(const BoundaryHandle& handle, const Eigen::MatrixXd& normals,
  const PoseOptions& options, HandlePose& pose, const Eigen::Matrix3d& rest)
{
  RequireOptions(options);
  if (options.BiasWeight == 0.0)
  {
    return;
  }
  if (options.BiasBy == PoseOptions::BiasByType::Frame)
  {
    const Eigen::Map<const Eigen::Vector3d> degrees(options.BiasRotation.data());
    const Eigen::Matrix3d frame = ToRotation(degrees * M_PI / 180.0) * rest;
    for (Eigen::Matrix3d& rotation : pose.Rotations)
    {
      const Eigen::AngleAxisd turn(Eigen::Matrix3d(frame * rotation.transpose()));
      rotation = ToRotation(options.BiasWeight * turn.angle() * turn.axis()) * rotation;
    }
    return;
  }
  const Eigen::Vector3d given = Eigen::Map<const Eigen::Vector3d>(options.BiasFrame.data());
  const Eigen::Vector3d direction = given.normalized();
  const Eigen::MatrixXd tangents = ComputeHandleTangents(handle, pose.Positions);
  for (Eigen::Index i = 0; i < normals.rows(); ++i)
  {
    if (!(normals.row(i).norm() > 0.0))
    {
      continue;
    }
    const Eigen::Vector3d normal = (pose.Rotations[i] * normals.row(i).transpose()).normalized();
    Eigen::Vector3d axis = normal.cross(direction);
    const double angle = std::atan2(axis.norm(), normal.dot(direction));
    // The sine of the angle; below, the axis is decided by rounding.
    if (!(axis.norm() > 1e-12))
    {
      // Opposite: all rotations by half a turn are least; the one about the curve does not twist
      // it.
      const Eigen::Vector3d tangent = tangents.row(i).transpose();
      axis = tangent - tangent.dot(normal) * normal;
      axis = axis.norm() > 0.0 ? axis : normal.unitOrthogonal();
    }
    pose.Rotations[i] =
      ToRotation(options.BiasWeight * angle * axis.normalized()) * pose.Rotations[i];
  }
}

Eigen::MatrixXd ComputeHandleNormals(const BoundaryHandle& handle, const PointGraph& shape)
{
  if (handle.Normals.size() > 0)
  {
    return handle.Normals;
  }
  const Eigen::RowVector3d centre = handle.Positions.colwise().mean();
  const Eigen::MatrixXd ways = handle.Positions.rowwise() - centre;
  // The normal of the best plane is the axis of least variance; it is unique unless the handle is
  // straight.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(ways.transpose() * ways);
  Eigen::RowVector3d plane = Eigen::RowVector3d::Zero();
  if (axes.eigenvalues()(1) > 1e-12 * axes.eigenvalues()(2))
  {
    plane = axes.eigenvectors().col(0).transpose();
    // Closed curves run counter-clockwise around their normal.
    Eigen::RowVector3d area = Eigen::RowVector3d::Zero();
    for (const auto& segment : handle.Segments.rowwise())
    {
      const Eigen::RowVector3d from = ways.row(segment(0)), to = ways.row(segment(1));
      area += from.cross(to);
    }
    plane = plane.dot(area) < 0.0 ? Eigen::RowVector3d(-plane) : plane;
  }
  const PointTree tree(shape.Positions);
  // A handle may lie beside the shape, up to an edge away.
  const double near = 1e-6 * ComputeBoxDiagonal(shape.Positions) + shape.MeanLength;
  Eigen::MatrixXd normals(handle.Positions.rows(), 3);
  for (Eigen::Index i = 0; i < normals.rows(); ++i)
  {
    const int node = tree.Nearest(handle.Positions.row(i), 1).front();
    const bool known = (shape.Positions.row(node) - handle.Positions.row(i)).norm() <= near &&
      shape.Normals.row(node).norm() > 0.0;
    normals.row(i) = known ? Eigen::RowVector3d(shape.Normals.row(node)) : plane;
  }
  return normals;
}

} // namespace shape
