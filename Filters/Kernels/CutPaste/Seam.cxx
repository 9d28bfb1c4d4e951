#include "CutPaste/Seam.h"

#include "CutPaste/FeatureFootprint.h"
#include "Mesh/EdgeMidpoints.h"
#include "Mesh/HalfEdges.h"
#include "Planar/PlanarDelaunay.h"
#include "Search/PointTree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// A point of the loop with three axes: along the loop, into the feature, and upwards.
struct Hinge
{
  RowVector3d Position, Along, Inwards, Up;

  /// The angle of a point above the tangent plane, in radians.
  /// Inwards and Up span the plane across the loop; the component along the loop does not matter.
  double AngleOf(const RowVector3d& point) const
  {
    const RowVector3d way = point - this->Position;
    return std::atan2(this->Up.dot(way), this->Inwards.dot(way));
  }

  /// Rotates a point down by an angle about the loop.
  RowVector3d Turned(const RowVector3d& point, double angle) const
  {
    const RowVector3d way = point - this->Position;
    const double in = this->Inwards.dot(way), up = this->Up.dot(way);
    const double cosine = std::cos(angle), sine = std::sin(angle);
    // Only the change is added: an angle of 0 returns the point itself.
    return point + ((cosine - 1.0) * in + sine * up) * this->Inwards +
      ((cosine - 1.0) * up - sine * in) * this->Up;
  }
};

/// The tangent at a point is the direction from the previous point to the next one, as in equation
/// 12. Inwards is orthogonal to it and to the target's normal.
std::vector<Hinge> HingesOf(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& loops, const Eigen::MatrixXd& normals)
{
  std::vector<Hinge> hinges;
  for (const std::vector<int>& loop : loops)
  {
    const std::size_t size = loop.size();
    for (std::size_t i = 0; i < size; ++i)
    {
      const RowVector3d along =
        points.row(loop[(i + 1) % size]) - points.row(loop[(i + size - 1) % size]);
      const RowVector3d normal = normals.row(static_cast<Eigen::Index>(hinges.size()));
      Hinge hinge;
      hinge.Position = points.row(loop[i]);
      hinge.Along = along.stableNormalized();
      hinge.Inwards = normal.cross(hinge.Along).stableNormalized();
      hinge.Up = hinge.Along.cross(hinge.Inwards);
      hinges.push_back(hinge);
    }
  }
  return hinges;
}

/// The inner edges of a band that join two points of the ring.
std::vector<std::array<int, 2>> RingChords(const SeamBand& band, int loop)
{
  const Eigen::Index points = loop + band.RingPoints.size();
  std::vector<bool> isRing(points, true);
  std::fill_n(isRing.begin(), loop, false);
  for (const int point : band.RingPoints)
  {
    isRing[point] = true;
  }
  std::vector<std::array<int, 2>> chords;
  const std::vector<HalfEdge> sides = SortHalfEdges(band.Triangles, points);
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    const int low = sides[i].Low(), high = sides[i].High();
    const bool isInner = sides[i + 1].Low() == low && sides[i + 1].High() == high;
    if (isInner && isRing[low] && isRing[high])
    {
      chords.push_back({ low, high });
    }
  }
  return chords;
}

} // namespace

SeamNormals::SeamNormals(const Mesh& feature, const TriangleFans& fans,
  const std::vector<std::vector<int>>& loops, const Eigen::VectorXd& distances, double width)
  : Loops(loops)
{
  const std::vector<int> loop = ConcatenateLoops(loops);
  // Beyond the ring the rotation is already small and smooth; a few samples suffice.
  constexpr int nearest = 6;
  std::vector<int> row(feature.Points.rows(), -1); // in the ring
  // -1 marks the other points that are not in the ring.
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
        continue; // a point that coincides with one of the loop stays
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

/// First the ring, whose triangles determine the normals at the loop; then the points beyond, by
/// the angles found there, which fade out.
void SeamNormals::Apply(Eigen::MatrixXd& points, const Eigen::MatrixXd& normals, double share) const
{
  const std::vector<Hinge> hinges = HingesOf(points, this->Loops, normals);
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

SeamBand TriangulateSeamBand(const Eigen::MatrixXd& loop, const Eigen::MatrixXd& ring)
{
  const auto inner = static_cast<int>(loop.rows()), outer = static_cast<int>(ring.rows());
  Eigen::MatrixXd points(inner + outer, 2);
  points << loop, ring;
  Eigen::MatrixXi segments(inner + outer, 2);
  for (int i = 0; i < inner; ++i)
  {
    segments.row(i) << i, (i + 1) % inner;
  }
  for (int i = 0; i < outer; ++i)
  {
    segments.row(inner + i) << inner + i, inner + (i + 1) % outer;
  }
  PlanarDelaunayOptions options;
  // The band is inside one of the two polygons, the hole in it inside both.
  options.Keep = PlanarDelaunayOptions::KeepType::Oddly;
  const PlanarTriangulation joined = TriangulateInPlane(points, segments, options);
  SeamBand band{ joined.Triangles, joined.SamePoint.tail(outer), {} };
  const CutTriangles cut = SplitEdges(band.Triangles, RingChords(band, inner), inner + outer);
  band.Triangles = cut.Triangles;
  band.Midpoints = cut.Midpoints;
  return band;
}

Eigen::MatrixXd BlendAtSeam(Eigen::MatrixXd values, const Eigen::MatrixXd& points,
  const Eigen::MatrixXd& differences, const Eigen::MatrixXd& loop, const Eigen::VectorXd& distances,
  double width)
{
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (!(distances(i) < width))
    {
      continue;
    }
    const Eigen::VectorXd squares = (loop.rowwise() - points.row(i)).rowwise().squaredNorm();
    Eigen::Index nearest = 0;
    Eigen::RowVectorXd difference;
    if (squares.minCoeff(&nearest) == 0.0)
    {
      difference = differences.row(nearest);
    }
    else
    {
      // Relative to the nearest, so that no weight overflows.
      const Eigen::VectorXd weights = squares(nearest) * squares.cwiseInverse();
      difference = (weights.transpose() * differences) / weights.sum();
    }
    const double share = distances(i) / width, left = 1.0 - share * share;
    values.row(i) += left * left * left * difference;
  }
  return values;
}

} // namespace shape
