#include "Deform/BoundaryHandle.h"

#include "Base/Errors.h"
#include "Geometry/FitRotation.h"
#include "Mesh/Mesh.h"
#include "Mesh/Topology.h"
#include "Search/PointTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

/// The samples before and after each one on its curves, and around it on the surface.
class Neighbourhood
{
public:
  explicit Neighbourhood(const BoundaryHandle& handle)
    : First(GetFirstSamples(handle))
    , Before(handle.Positions.rows())
    , After(handle.Positions.rows())
    , Around(handle.Positions.rows())
  {
    for (const auto& segment : handle.Segments.rowwise())
    {
      const int a = this->First[segment(0)], b = this->First[segment(1)];
      if (a != b)
      {
        this->After[a].push_back(b);
        this->Before[b].push_back(a);
      }
    }
    for (const auto& triangle : handle.Triangles.rowwise())
    {
      for (int k = 0; k < 3; ++k)
      {
        const int a = this->First[triangle(k)], b = this->First[triangle((k + 1) % 3)];
        this->Around[a].push_back(b);
        this->Around[b].push_back(a);
      }
    }
  }

  bool OnSurface(int sample) const { return !this->Around[this->First[sample]].empty(); }

  /// From the sample before to the sample after; 0 if they are not unique.
  Eigen::Vector3d Tangent(int sample, const Eigen::MatrixXd& positions) const
  {
    const int own = this->First[sample];
    const std::vector<int>&before = this->Before[own], &after = this->After[own];
    if (before.size() + after.size() == 0 || before.size() + after.size() > 2)
    {
      return Eigen::Vector3d::Zero();
    }
    // If both segments begin here, or both end here, the curve runs in their order.
    const int from = !before.empty() ? before.front() : after.size() == 2 ? after.front() : own;
    const int to = !after.empty() ? after.back() : before.size() == 2 ? before.back() : own;
    return (positions.row(to) - positions.row(from)).transpose();
  }

  /// All neighbours; some may be listed twice.
  std::vector<int> All(int sample) const
  {
    const int own = this->First[sample];
    std::vector<int> all = this->Around[own];
    all.insert(all.end(), this->Before[own].begin(), this->Before[own].end());
    all.insert(all.end(), this->After[own].begin(), this->After[own].end());
    return all;
  }

  std::vector<int> First;

private:
  std::vector<std::vector<int>> Before, After, Around;
};

Eigen::Matrix3d MinimumRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  return Eigen::Quaterniond::FromTwoVectors(from, to).toRotationMatrix();
}

/// The share of the handle that each sample represents, so that dense samples get no more weight.
/// The weight of equation 5 for non-uniform sampling: the sum of the lengths of a sample's
/// segments. Triangles count by their area; the size of the handle makes the two comparable.
Eigen::VectorXd Shares(const BoundaryHandle& handle)
{
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(handle.Positions.rows());
  const double size = ComputeBoxDiagonal(handle.Positions);
  for (const auto& segment : handle.Segments.rowwise())
  {
    // A length times the size of the handle is an area, like those of its triangles.
    const double length =
      (handle.Positions.row(segment(0)) - handle.Positions.row(segment(1))).norm() * size;
    shares(segment(0)) += length;
    shares(segment(1)) += length;
  }
  const Mesh surface{ handle.Positions, handle.Triangles };
  shares +=
    handle.Triangles.rows() > 0 ? ComputePointAreas(surface) : Eigen::VectorXd(0.0 * shares);
  if (!(shares.sum() > 0.0))
  {
    shares.setOnes();
  }
  return shares;
}

/// Columns: along the tangent, across the normal, nearest to the normal; false if tangent and
/// normal are parallel, or one is 0.
bool MakeFrame(
  const Eigen::Vector3d& tangent, const Eigen::Vector3d& normal, Eigen::Matrix3d& frame)
{
  const Eigen::Vector3d across = normal.normalized().cross(tangent.normalized());
  // The sine of the angle between tangent and normal; below, the frame is decided by rounding.
  if (!(across.norm() > 1e-6))
  {
    return false;
  }
  frame.col(0) = tangent.normalized();
  frame.col(1) = across.normalized();
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return true;
}

/// The rotation of one sample; normals of length 0 if none are known.
class SampleRotation
{
public:
  SampleRotation(const BoundaryHandle& handle, const Eigen::MatrixXd& positions)
    : Handle(handle)
    , Positions(positions)
    , Near(handle)
    , Whole(FitHandleRotation(handle, positions))
  {
  }

  // On a curve, the frame of tangent and normal determines the rotation. Without normals, the twist
  // is that of the whole handle. On surfaces and at branches, the rotation fits the neighbours'
  // offsets and the normal best.
  Eigen::Matrix3d Of(int sample, const Eigen::Vector3d& normal, const Eigen::Vector3d& moved) const
  {
    const Eigen::Vector3d tangent = this->Near.Tangent(sample, this->Handle.Positions);
    const Eigen::Vector3d along = this->Near.Tangent(sample, this->Positions);
    if (!this->Near.OnSurface(sample) && tangent.norm() > 0.0 && along.norm() > 0.0)
    {
      Eigen::Matrix3d from, to;
      if (MakeFrame(tangent, normal, from) && MakeFrame(along, moved, to))
      {
        return to * from.transpose();
      }
      // A minimum rotation adds no twist about the tangent.
      return MinimumRotation(this->Whole * tangent, along) * this->Whole;
    }
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    double size = 0.0;
    for (const int j : this->Near.All(sample))
    {
      const Eigen::RowVector3d from =
        this->Handle.Positions.row(j) - this->Handle.Positions.row(sample);
      products += (this->Positions.row(j) - this->Positions.row(sample)).transpose() * from;
      size += from.squaredNorm();
    }
    // The normal has as much influence as all neighbours together.
    products += (size > 0.0 ? size : 1.0) * moved * normal.transpose();
    return FitRotation(products, this->Whole);
  }

private:
  const BoundaryHandle& Handle;
  const Eigen::MatrixXd& Positions;
  Neighbourhood Near;
  Eigen::Matrix3d Whole;
};

Eigen::MatrixXd UnitRows(Eigen::MatrixXd rows)
{
  for (auto row : rows.rowwise())
  {
    const double norm = row.norm();
    row /= norm > 0.0 ? norm : 1.0;
  }
  return rows;
}

/// The normals of the handle's own surface, 0 elsewhere.
Eigen::MatrixXd SurfaceNormals(const BoundaryHandle& handle, const Eigen::MatrixXd& positions)
{
  Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(positions.rows(), 3);
  const Eigen::MatrixXd vectors = ComputeAreaVectors(Mesh{ positions, handle.Triangles });
  for (Eigen::Index t = 0; t < handle.Triangles.rows(); ++t)
  {
    for (const int sample : handle.Triangles.row(t))
    {
      normals.row(sample) += vectors.row(t);
    }
  }
  return normals;
}

void RequireSize(const Eigen::MatrixXd& rows, Eigen::Index samples, const std::string& name)
{
  if (rows.rows() != samples || rows.cols() != 3)
  {
    throw InvalidInput("the handle has " + std::to_string(samples) + " points, but its " + name +
      " are " + std::to_string(rows.rows()) + " x " + std::to_string(rows.cols()) +
      "; give three numbers for each point");
  }
  RequireFinite(rows, "the handle's " + name);
}

} // namespace

BoundaryHandle BuildCurveHandle(
  const Eigen::MatrixXd& positions, bool closed, const Eigen::MatrixXd& normals)
{
  const auto samples = static_cast<int>(positions.rows());
  BoundaryHandle handle{ positions, {}, {}, normals };
  handle.Segments.resize(std::max(0, closed ? samples : samples - 1), 2);
  for (int i = 0; i < handle.Segments.rows(); ++i)
  {
    handle.Segments.row(i) << i, (i + 1) % samples;
  }
  return handle;
}

BoundaryHandle BuildLoopsHandle(
  const Eigen::MatrixXd& points, const std::vector<std::vector<int>>& loops)
{
  std::vector<int> all;
  std::vector<Eigen::RowVector2i> segments;
  for (const std::vector<int>& loop : loops)
  {
    const auto start = static_cast<int>(all.size()), count = static_cast<int>(loop.size());
    for (int i = 0; i < count; ++i)
    {
      segments.emplace_back(start + i, start + (i + 1) % count);
    }
    all.insert(all.end(), loop.begin(), loop.end());
  }
  BoundaryHandle handle{ points(all, Eigen::all), Eigen::MatrixXi(segments.size(), 2), {}, {} };
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    handle.Segments.row(static_cast<Eigen::Index>(i)) = segments[i];
  }
  return handle;
}

std::vector<int> GetFirstSamples(const BoundaryHandle& handle)
{
  const PointTree tree(handle.Positions);
  // Samples at one position differ by rounding only.
  const double tolerance = 1e-9 * ComputeBoxDiagonal(handle.Positions);
  std::vector<int> first;
  for (Eigen::Index i = 0; i < handle.Positions.rows(); ++i)
  {
    first.push_back(tree.Within(handle.Positions.row(i), tolerance).front());
  }
  return first;
}

Eigen::MatrixXd ComputeHandleTangents(
  const BoundaryHandle& handle, const Eigen::MatrixXd& positions)
{
  const Neighbourhood near(handle);
  Eigen::MatrixXd tangents(positions.rows(), 3);
  for (int i = 0; i < static_cast<int>(positions.rows()); ++i)
  {
    tangents.row(i) = near.Tangent(i, positions).transpose();
  }
  return tangents;
}

HandlePose PoseHandle(
  const BoundaryHandle& handle, const Eigen::MatrixXd& positions, const Eigen::MatrixXd& normals)
{
  const Eigen::Index samples = handle.Positions.rows();
  RequireSize(handle.Positions, samples, "positions");
  RequireSize(positions, samples, "target positions");
  const bool before = handle.Normals.size() > 0, after = normals.size() > 0;
  if (before != after)
  {
    throw InvalidInput(std::string("the handle has normals at its ") +
      (before ? "source, but not at its target" : "target, but not at its source") +
      "; give both SourceNormal and TargetNormal, or neither");
  }
  if (before)
  {
    RequireSize(handle.Normals, samples, "source normals");
    RequireSize(normals, samples, "target normals");
  }
  if (positions == handle.Positions && (!before || normals == handle.Normals))
  {
    return GetRestPose(handle); // to the last bit
  }
  const Eigen::MatrixXd from =
    UnitRows(before ? handle.Normals : SurfaceNormals(handle, handle.Positions));
  const Eigen::MatrixXd to = UnitRows(before ? normals : SurfaceNormals(handle, positions));
  const SampleRotation rotation(handle, positions);
  HandlePose pose{ positions, {} };
  for (int i = 0; i < static_cast<int>(samples); ++i)
  {
    pose.Rotations.push_back(rotation.Of(i, from.row(i).transpose(), to.row(i).transpose()));
  }
  return pose;
}

Eigen::Matrix3d FitHandleRotation(const BoundaryHandle& handle, const Eigen::MatrixXd& positions)
{
  const Eigen::VectorXd shares = Shares(handle);
  const auto centred = [&](const Eigen::MatrixXd& rows) -> Eigen::MatrixXd
  {
    const Eigen::RowVector3d centre = shares.transpose() * rows / shares.sum();
    return rows.rowwise() - centre;
  };
  const Eigen::Matrix3d products =
    centred(positions).transpose() * shares.asDiagonal() * centred(handle.Positions);
  return FitRotation(products, Eigen::Matrix3d::Identity());
}

HandlePose GetRestPose(const BoundaryHandle& handle)
{
  return { handle.Positions,
    std::vector<Eigen::Matrix3d>(handle.Positions.rows(), Eigen::Matrix3d::Identity()) };
}

void RotateAboutTangents(
  const BoundaryHandle& handle, const Eigen::VectorXd& angles, HandlePose& pose)
{
  const Eigen::MatrixXd tangents = ComputeHandleTangents(handle, pose.Positions);
  for (Eigen::Index i = 0; i < tangents.rows(); ++i)
  {
    const Eigen::Vector3d axis = tangents.row(i).transpose();
    if (axis.norm() > 0.0)
    {
      pose.Rotations[i] =
        Eigen::AngleAxisd(angles(i), axis.normalized()).toRotationMatrix() * pose.Rotations[i];
    }
  }
}

} // namespace shape
