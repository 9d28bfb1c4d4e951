#include "Deform/HandleMotion.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Geometry/RotationVector.h"
#include "Mesh/Mesh.h"
#include "Mesh/Topology.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// The samples at both ends of each edge of the handle.
std::vector<std::pair<int, int>> ListEdges(const BoundaryHandle& handle)
{
  std::vector<std::pair<int, int>> edges;
  for (const auto& segment : handle.Segments.rowwise())
  {
    edges.emplace_back(segment(0), segment(1));
  }
  for (const auto& triangle : handle.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.emplace_back(triangle(k), triangle((k + 1) % 3));
    }
  }
  return edges;
}

double FindLongestEdge(const Eigen::MatrixXd& points, const Eigen::MatrixXi& elements)
{
  double longest = 0.0;
  for (const auto& corners : elements.rowwise())
  {
    for (Eigen::Index a = 0; a < corners.size(); ++a)
    {
      for (Eigen::Index b = 0; b < a; ++b)
      {
        longest = std::max(longest, (points.row(corners(a)) - points.row(corners(b))).norm());
      }
    }
  }
  return longest;
}

} // namespace

void RequireOnShape(const BoundaryHandle& handle, const ShapeElements& shape)
{
  RequireFinite(shape.Points, "the shape");
  RequireFinite(handle.Positions, "the handle");
  double near = 1e-6 * ComputeBoxDiagonal(shape.Points);
  for (const Eigen::MatrixXi* elements : { &shape.Lines, &shape.Triangles, &shape.Tetrahedra })
  {
    near = std::max(near, FindLongestEdge(shape.Points, *elements));
  }
  const PointTree tree(shape.Points);
  for (Eigen::Index i = 0; i < handle.Positions.rows(); ++i)
  {
    const int closest = tree.Nearest(handle.Positions.row(i), 1).front();
    const double distance = (handle.Positions.row(i) - shape.Points.row(closest)).norm();
    if (distance > near)
    {
      throw InvalidInput("point " + std::to_string(i) + " of the handle is off the shape, by " +
        std::to_string(distance));
    }
  }
}

HandleParts FindHandleParts(const BoundaryHandle& handle)
{
  const auto samples = static_cast<int>(handle.Positions.rows());
  const std::vector<int> first = GetFirstSamples(handle);
  const std::vector<std::pair<int, int>> edges = ListEdges(handle);
  DisjointSets components(samples);
  std::vector<char> isLoose(samples, 1);
  for (const auto& [a, b] : edges)
  {
    components.Merge(first[a], first[b]);
    isLoose[first[a]] = isLoose[first[b]] = 0;
  }
  int loose = -1;
  for (int i = 0; i < samples; ++i)
  {
    if (isLoose[first[i]])
    {
      loose = loose < 0 ? i : loose;
      components.Merge(i, loose);
    }
    components.Merge(i, first[i]);
  }
  std::vector<double> lengths(samples, 0.0);
  for (const auto& [a, b] : edges)
  {
    lengths[components.Find(a)] += (handle.Positions.row(a) - handle.Positions.row(b)).norm();
  }
  // Components in the order of their first samples, then, without changing that of equal ones, by
  // length.
  std::vector<int> order;
  std::map<int, int> numbers;
  for (int i = 0; i < samples; ++i)
  {
    if (numbers.emplace(components.Find(i), 0).second)
    {
      order.push_back(components.Find(i));
    }
  }
  const auto key = [&](int component)
  { return loose >= 0 && component == components.Find(loose) ? -1.0 : lengths[component]; };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return key(a) > key(b); });
  HandleParts parts;
  for (const int component : order)
  {
    numbers[component] = parts.Count++;
  }
  for (int i = 0; i < samples; ++i)
  {
    parts.PartOf.push_back(numbers[components.Find(i)]);
  }
  return parts;
}

Eigen::Vector3d ComputePartCentre(const BoundaryHandle& handle, const HandleParts& parts, int part,
  const Eigen::MatrixXd& positions)
{
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  double total = 0.0;
  for (const auto& segment : handle.Segments.rowwise())
  {
    if (parts.PartOf[segment(0)] == part)
    {
      const Eigen::RowVector3d from = positions.row(segment(0)), to = positions.row(segment(1));
      const double length = (to - from).norm();
      sum += length * 0.5 * (from + to);
      total += length;
    }
  }
  if (!(total > 0.0)) // no segments, or all of length 0
  {
    sum.setZero();
    for (Eigen::Index i = 0; i < positions.rows(); ++i)
    {
      if (parts.PartOf[i] == part)
      {
        sum += positions.row(i);
        total += 1.0;
      }
    }
  }
  return (sum / total).transpose();
}

PrescribedRotations PrescribeRotations(
  const BoundaryHandle& handle, const std::vector<FrameRotation>& frames)
{
  const Eigen::Index samples = handle.Positions.rows();
  PrescribedRotations turns{ Eigen::MatrixXd::Zero(samples, 3), Eigen::VectorXi::Zero(samples) };
  const PointTree tree(handle.Positions);
  const std::vector<int> first = GetFirstSamples(handle);
  for (std::size_t i = 0; i < frames.size(); ++i)
  {
    if (!frames[i].Position.allFinite() || !frames[i].Rotation.allFinite())
    {
      throw InvalidInput("row " + std::to_string(i) +
        " of FrameRotations has a number that is not finite; give finite numbers");
    }
    const int sample = first[tree.Nearest(frames[i].Position.transpose(), 1).front()];
    turns.Turns.row(sample) = frames[i].Rotation.transpose();
    turns.IsSet(sample) = 1;
  }
  return turns;
}

void MoveParts(
  const BoundaryHandle& handle, const std::vector<PartMotion>& motions, HandlePose& pose)
{
  if (motions.empty())
  {
    return;
  }
  const HandleParts parts = FindHandleParts(handle);
  for (const PartMotion& motion : motions)
  {
    if (motion.Part < 0 || motion.Part >= parts.Count)
    {
      throw InvalidInput("HandleMotions moves part " + std::to_string(motion.Part) +
        ", but the handle has " + std::to_string(parts.Count) + " part" +
        (parts.Count == 1 ? "" : "s") + "; use a part from 0 to " +
        std::to_string(parts.Count - 1));
    }
    if (!motion.Translation.allFinite() || !motion.Rotation.allFinite() ||
      !(motion.Scale > 0.0 && std::isfinite(motion.Scale)))
    {
      throw InvalidInput("HandleMotions has a scale that is not positive, or a number that is not "
                         "finite, for part " +
        std::to_string(motion.Part) + "; give finite numbers and a positive scale");
    }
    const Eigen::Matrix3d rotation = ToRotation(motion.Rotation);
    // The change of an offset, so that a motion by nothing adds exactly 0.
    const Eigen::Matrix3d change = motion.Scale * rotation - Eigen::Matrix3d::Identity();
    const Eigen::RowVector3d centre =
      ComputePartCentre(handle, parts, motion.Part, pose.Positions).transpose();
    for (std::size_t i = 0; i < parts.PartOf.size(); ++i)
    {
      if (parts.PartOf[i] == motion.Part)
      {
        const auto sample = static_cast<Eigen::Index>(i);
        const Eigen::RowVector3d offset = pose.Positions.row(sample) - centre;
        pose.Positions.row(sample) += motion.Translation.transpose() + offset * change.transpose();
        pose.Rotations[i] = rotation * pose.Rotations[i];
      }
    }
  }
}

} // namespace shape
