#include "CutPaste/SeamNormals.h"

#include "Search/PointTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// A point of the loop, with the axes along it, into the feature, and upwards.
struct Hinge
{
  RowVector3d Position, Along, Inwards, Up;

  /// By how much a point stands above the tangent plane, radians.
  double AngleOf(const RowVector3d& point) const
  {
    const RowVector3d way = point - this->Position;
    return std::atan2(this->Up.dot(way), this->Inwards.dot(way));
  }

  /// Down by an angle about the loop.
  RowVector3d Turned(const RowVector3d& point, double angle) const
  {
    const RowVector3d way = point - this->Position;
    const double in = this->Inwards.dot(way), up = this->Up.dot(way);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return point + ((cosine - 1.0) * in + sine * up) * this->Inwards +
      ((cosine - 1.0) * up - sine * in) * this->Up;
  }
};

std::vector<Hinge> HingesOf(
  const Eigen::MatrixXd& points, const std::vector<int>& loop, const Eigen::MatrixXd& normals)
{
  const std::size_t size = loop.size();
  std::vector<Hinge> hinges(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    const RowVector3d along =
      points.row(loop[(i + 1) % size]) - points.row(loop[(i + size - 1) % size]);
    Hinge& hinge = hinges[i];
    hinge.Position = points.row(loop[i]);
    hinge.Along = along.stableNormalized();
    hinge.Inwards =
      RowVector3d(normals.row(static_cast<Eigen::Index>(i))).cross(hinge.Along).stableNormalized();
    hinge.Up = hinge.Along.cross(hinge.Inwards);
  }
  return hinges;
}

} // namespace

SeamNormals::SeamNormals(const Mesh& feature, const TriangleFans& fans,
  const std::vector<int>& loop, const Eigen::VectorXd& distances, double width)
  : Loop(loop)
{
  constexpr int nearest = 6;
  std::vector<int> row(feature.Points.rows(), -1); // in the ring
  constexpr int isLoop = -2;
  for (const int point : loop)
  {
    row[point] = isLoop;
  }
  for (int sample = 0; sample < static_cast<int>(loop.size()); ++sample)
  {
    for (int i = fans.First[loop[sample]]; i < fans.First[loop[sample] + 1]; ++i)
    {
      for (const int corner : feature.Triangles.row(fans.Triangles[i]))
      {
        if (row[corner] == isLoop)
        {
          continue;
        }
        if (row[corner] == -1)
        {
          row[corner] = static_cast<int>(this->Ring.size());
          this->Ring.push_back({ corner, 1.0, {}, {} });
        }
        std::vector<int>& samples = this->Ring[row[corner]].Samples;
        if (samples.empty() || samples.back() != sample)
        {
          samples.push_back(sample);
        }
      }
    }
  }
  const PointTree tree(feature.Points(loop, Eigen::all));
  for (int point = 0; point < static_cast<int>(row.size()); ++point)
  {
    if (row[point] == -1 && distances(point) < width)
    {
      const double share = distances(point) / width, left = 1.0 - share * share;
      Turned turned{ point, left * left * left, tree.Nearest(feature.Points.row(point), nearest),
        {} };
      if (feature.Points.row(point) == feature.Points.row(loop[turned.Samples[0]]))
      {
        continue; // another point at that place of the loop: it stays with it
      }
      double sum = 0.0;
      for (const int sample : turned.Samples)
      {
        turned.Weights.push_back(
          1.0 / (feature.Points.row(point) - feature.Points.row(loop[sample])).squaredNorm());
        sum += turned.Weights.back();
      }
      for (double& weight : turned.Weights)
      {
        weight /= sum;
      }
      this->Beyond.push_back(std::move(turned));
    }
  }
}

void SeamNormals::Apply(Eigen::MatrixXd& points, const Eigen::MatrixXd& normals, double share) const
{
  const std::vector<Hinge> hinges = HingesOf(points, this->Loop, normals);
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(hinges.size()));
  Eigen::VectorXd sums = angles;
  for (const Turned& turned : this->Ring)
  {
    const RowVector3d point = points.row(turned.Point);
    RowVector3d position = RowVector3d::Zero();
    double sum = 0.0;
    for (const int sample : turned.Samples)
    {
      const double weight = 1.0 / (point - hinges[sample].Position).squaredNorm();
      if (!std::isfinite(weight))
      {
        continue; // on the loop
      }
      const double angle = hinges[sample].AngleOf(point);
      position += weight * hinges[sample].Turned(point, share * angle);
      sum += weight;
      angles(sample) += weight * angle;
      sums(sample) += weight;
    }
    if (sum > 0.0)
    {
      points.row(turned.Point) = position / sum;
    }
  }
  for (Eigen::Index i = 0; i < angles.size(); ++i)
  {
    angles(i) = sums(i) > 0.0 ? angles(i) / sums(i) : 0.0;
  }
  for (const Turned& turned : this->Beyond)
  {
    const RowVector3d point = points.row(turned.Point);
    RowVector3d position = RowVector3d::Zero();
    for (std::size_t i = 0; i < turned.Samples.size(); ++i)
    {
      const int sample = turned.Samples[i];
      position +=
        turned.Weights[i] * hinges[sample].Turned(point, share * turned.Fade * angles(sample));
    }
    points.row(turned.Point) = position;
  }
}

} // namespace shape
