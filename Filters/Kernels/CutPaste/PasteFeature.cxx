#include "CutPaste/PasteFeature.h"

#include "Base/Errors.h"
#include "CutPaste/Private/PointJoin.h"
#include "CutPaste/Private/SoupJoin.h"
#include "Deform/BoundaryNormals.h"
#include "Geometry/MovedNormals.h"
#include "Geometry/VertexNormals.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

namespace shape
{
namespace
{

double TwiceArea(const Eigen::MatrixXd& polygon)
{
  double sum = 0.0;
  for (Eigen::Index i = 0; i < polygon.rows(); ++i)
  {
    const Eigen::Index j = (i + 1) % polygon.rows();
    sum += polygon(i, 0) * polygon(j, 1) - polygon(j, 0) * polygon(i, 1);
  }
  return sum;
}

/// Throws InvalidInput if the loop crosses or touches itself in the plane, or runs clockwise.
void RequireSimple(const Eigen::MatrixXd& loop)
{
  if (!IsSimplePolygon(loop))
  {
    throw InvalidInput("the feature's loop crosses or touches itself when laid out flat; cut it "
                       "with a smoother loop");
  }
  if (TwiceArea(loop) < 0.0)
  {
    throw InvalidInput("the feature's triangles are oriented opposite to those of the surface from "
                       "which it was cut; reverse them with Reverse Sense");
  }
}

std::vector<std::vector<int>> LoopsOf(const std::vector<FeatureFootprint>& bases)
{
  std::vector<std::vector<int>> loops;
  for (const FeatureFootprint& base : bases)
  {
    loops.push_back(base.Loop);
  }
  return loops;
}

std::vector<std::array<int, 2>> ChordsOf(
  const Eigen::MatrixXi& triangles, const std::vector<FeatureFootprint>& bases)
{
  std::set<std::array<int, 2>> chords;
  for (const FeatureFootprint& base : bases)
  {
    const std::vector<std::array<int, 2>> own = FindLoopChords(triangles, base.Loop);
    chords.insert(own.begin(), own.end());
  }
  return { chords.begin(), chords.end() };
}

/// Closed curves, one for each base.
BoundaryHandle BuildLoopHandle(const Surface& feature, const std::vector<FeatureFootprint>& bases)
{
  BoundaryHandle handle = BuildLoopsHandle(feature.Points(), LoopsOf(bases));
  handle.Normals.resize(handle.Positions.rows(), 3);
  Eigen::Index first = 0;
  for (const FeatureFootprint& base : bases)
  {
    const auto size = static_cast<Eigen::Index>(base.Loop.size());
    if (size < 3 || base.LoopPositions.rows() != size || base.Normals.rows() != size)
    {
      throw InvalidInput("the feature's loop has " + std::to_string(size) + " points, " +
        std::to_string(base.LoopPositions.rows()) + " positions in the plane and " +
        std::to_string(base.Normals.rows()) +
        " normals, but these numbers must be equal and at least 3; cut the feature again");
    }
    handle.Normals.middleRows(first, size) = base.Normals;
    first += size;
  }
  return handle;
}

/// The maximum angle between one of the rotations and the first, in radians.
/// Rotations by an angle t apart have the Frobenius distance sqrt(8) sin(t / 2).
double Spread(const std::vector<Eigen::Matrix3d>& rotations)
{
  double farthest = 0.0;
  for (const Eigen::Matrix3d& rotation : rotations)
  {
    farthest = std::max(farthest, (rotation - rotations[0]).norm());
  }
  return 2.0 * std::asin(std::min(farthest / std::sqrt(8.0), 1.0));
}

/// Returns the maximum arrival time of the points of triangles at the loop.
double ReachOfRing(const Mesh& feature, const TriangleFans& fans, const std::vector<int>& loop,
  const Eigen::VectorXd& times)
{
  double reach = 0.0;
  for (const int point : loop)
  {
    for (int i = fans.First[point]; i < fans.First[point + 1]; ++i)
    {
      for (const int corner : feature.Triangles.row(fans.Triangles[i]))
      {
        reach = std::max(reach, times(corner));
      }
    }
  }
  return reach;
}

/// The angle between the projections to the plane across the tangent: only this part of the
/// deviation can be corrected by a rotation about the loop.
Eigen::VectorXd AnglesAcross(
  const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, const Eigen::MatrixXd& tangents)
{
  Eigen::VectorXd angles(a.rows());
  for (Eigen::Index i = 0; i < a.rows(); ++i)
  {
    const Eigen::RowVector3d one = a.row(i), other = b.row(i), along = tangents.row(i);
    const Eigen::RowVector3d axis = along.stableNormalized();
    angles(i) = std::abs(std::atan2(
                  axis.dot(one.cross(other)), one.dot(other) - axis.dot(one) * axis.dot(other))) *
      180.0 / M_PI;
  }
  return angles;
}

/// Returns the rotations from one pose to another.
PrescribedRotations TurnsBetween(const HandlePose& from, const HandlePose& to)
{
  const auto samples = static_cast<Eigen::Index>(from.Rotations.size());
  PrescribedRotations turns{ Eigen::MatrixXd(samples, 3), Eigen::VectorXi::Ones(samples) };
  for (Eigen::Index i = 0; i < samples; ++i)
  {
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(to.Rotations[i] * from.Rotations[i].transpose()));
    turns.Turns.row(i) = turn.angle() * turn.axis().transpose();
  }
  return turns;
}

/// The distance from the loop within which SeamNormals acts, in mean edges of the loop.
constexpr double TurningWidth = 4.0;

double MeanSide(const BoundaryHandle& curve)
{
  double sum = 0.0;
  for (const auto side : curve.Segments.rowwise())
  {
    sum += (curve.Positions.row(side(1)) - curve.Positions.row(side(0))).norm();
  }
  return sum / static_cast<double>(curve.Segments.rows());
}

} // namespace

double ComputePercentile(const Eigen::VectorXd& values, double share)
{
  if (values.size() == 0)
  {
    return 0.0;
  }
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const auto last = static_cast<double>(sorted.size() - 1);
  return sorted[static_cast<std::size_t>(std::ceil(std::clamp(share, 0.0, 1.0) * last))];
}

FeatureToPaste::FeatureToPaste(const shape::Surface& feature, std::vector<FeatureFootprint> bases,
  const DeformOptions& options, const DeformFields& fields, const Progress& progress)
  : Feature(feature)
  , Stands(std::move(bases))
  , Loop(ConcatenateLoops(LoopsOf(this->Stands)))
  , Cut(SplitEdges(this->Feature.Triangles(), ChordsOf(this->Feature.Triangles(), this->Stands),
      static_cast<int>(this->Feature.Points().rows())))
  , Fans(this->Cut.Triangles,
      this->Feature.Points().rows() + static_cast<Eigen::Index>(this->Cut.Midpoints.size()))
  , Handle(BuildLoopHandle(this->Feature, this->Stands))
  , NormalsBefore(this->LoopNormals(this->WithMidpoints(this->Feature.Points())))
{
  for (const FeatureFootprint& base : this->Stands)
  {
    RequireSimple(base.LoopPositions);
  }
  this->Prepared =
    PrepareDeformation(BuildPointGraph(this->Feature), this->Handle, options, fields, progress);
  // The midpoints are on chords of the loop, at which the front starts.
  Eigen::VectorXd arrivals = Eigen::VectorXd::Zero(this->Fans.First.size() - 1);
  arrivals.head(this->Feature.Points().rows()) = this->Prepared->Arrivals();
  const Mesh cut{ this->WithMidpoints(this->Feature.Points()), this->Cut.Triangles };
  this->NormalReach = ReachOfRing(cut, this->Fans, this->Loop, arrivals);
  this->Turning = std::make_unique<SeamNormals>(
    cut, this->Fans, LoopsOf(this->Stands), arrivals, TurningWidth * MeanSide(this->Handle));
}

void FeatureToPaste::Check(const PastedFeature& pasted) const
{
  RequireFinite(pasted.Surface.Points, "the joined surface");
  const Topology found = ComputeTopology(pasted.Surface);
  const Topology& given = this->Feature.Topology();
  const bool isManifold = given.NonManifoldEdges + given.NonManifoldPoints == 0;
  const int faults = found.NonManifoldEdges + found.NonManifoldPoints;
  if (found.EulerNumber != pasted.EulerNumber || (isManifold && faults > 0))
  {
    throw SolveFailure("the joined surface has " + std::to_string(faults) +
      " edges and points that are not manifold, and Euler number " +
      std::to_string(found.EulerNumber) + " instead of " + std::to_string(pasted.EulerNumber) +
      "; move Seed a little");
  }
}

/// The number of sides of the loops that are no edges of triangles of the feature.
int FeatureToPaste::SidesAcrossGaps() const
{
  std::set<std::pair<int, int>> edges;
  for (const auto& corners : this->Feature.Triangles().rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.insert(std::minmax(corners(k), corners((k + 1) % 3)));
    }
  }
  int count = 0;
  for (const FeatureFootprint& base : this->Stands)
  {
    for (std::size_t i = 0; i < base.Loop.size(); ++i)
    {
      const int a = base.Loop[i], b = base.Loop[(i + 1) % base.Loop.size()];
      count += edges.count(std::minmax(a, b)) == 0 ? 1 : 0;
    }
  }
  return count;
}

Eigen::MatrixXd FeatureToPaste::LoopNormals(const Eigen::MatrixXd& points) const
{
  return ComputeVertexNormals(
    points, this->Cut.Triangles, this->Fans, this->Loop, NormalWeight::Angle);
}

Eigen::MatrixXd FeatureToPaste::WithMidpoints(const Eigen::MatrixXd& points) const
{
  const auto midpoints = static_cast<Eigen::Index>(this->Cut.Midpoints.size());
  Eigen::MatrixXd all(points.rows() + midpoints, 3);
  all.topRows(points.rows()) = points;
  for (Eigen::Index i = 0; i < midpoints; ++i)
  {
    const auto [a, b] = this->Cut.Midpoints[i];
    all.row(points.rows() + i) = 0.5 * (points.row(a) + points.row(b));
  }
  return all;
}

/// The boundary optimisation of section 4.2, which is that of section 4.1: a single angle while the
/// feature is dragged, one angle for each sample when it is released. pose: its frames rotate.
DeformedShape FeatureToPaste::Smoothly(HandlePose& pose, const Eigen::MatrixXd& normals,
  const PasteFeatureOptions& options, const Progress& progress) const
{
  constexpr double rigid = 5.0 * M_PI / 180.0;
  // If all frames rotate alike, the feature moves rigidly and must not change. The normals are
  // blended up to 5 degrees, so nothing jumps while the feature is dragged.
  const double share = std::min(Spread(pose.Rotations) / rigid, 1.0);
  Eigen::MatrixXd wanted(normals.rows(), 3);
  for (Eigen::Index i = 0; i < wanted.rows(); ++i)
  {
    const Eigen::RowVector3d kept =
      (pose.Rotations[i] * this->NormalsBefore.row(i).transpose()).transpose();
    wanted.row(i) = ((1.0 - share) * kept + share * normals.row(i)).stableNormalized();
  }
  BoundaryNormalsOptions search;
  search.SingleAngle = options.Dragging;
  search.Reach = this->NormalReach;
  pose = OptimizeBoundaryNormals(
    *this->Prepared, this->Handle, pose, wanted,
    [this](const DeformedShape& shape)
    { return this->LoopNormals(this->WithMidpoints(shape.Points)); },
    search, progress.Part(0.0, 0.7))
           .Pose;
  DeformedShape deformed =
    this->Prepared->Deform(pose, std::numeric_limits<double>::infinity(), progress.Part(0.7, 1.0));
  deformed.Points = this->WithMidpoints(deformed.Points);
  // A point at a bend of the loop goes to the mean of several positions. Further rounds remove the
  // angle that remains.
  const int rounds = options.Dragging ? 1 : 3;
  for (int round = 0; share > 0.0 && round < rounds; ++round)
  {
    this->Turning->Apply(deformed.Points, normals, share);
  }
  return deformed;
}

/// positions, normals: those of the target at the points of the loops.
/// Offsets within the feature grow with Scale, so the feature is deformed at its original size to a
/// pose divided by Scale.
FeatureToPaste::Deformed FeatureToPaste::DeformTo(const Eigen::MatrixXd& positions,
  const Eigen::MatrixXd& normals, double scale, const PasteFeatureOptions& options,
  const Progress& progress) const
{
  constexpr double all = std::numeric_limits<double>::infinity();
  const HandlePose posed = PoseHandle(this->Handle, positions / scale, normals);
  HandlePose pose = posed;
  BiasFrames(this->Handle, this->Handle.Normals, options.Frames, pose);
  Eigen::MatrixXd wanted = normals;
  for (Eigen::Index i = 0; i < wanted.rows() && options.Frames.BiasWeight > 0.0; ++i)
  {
    wanted.row(i) = (pose.Rotations[i] * this->Handle.Normals.row(i).transpose()).transpose();
  }
  const Eigen::MatrixXd tangents = ComputeHandleTangents(this->Handle, pose.Positions);
  Deformed result;
  result.AnglesBefore = AnglesAcross(
    this->LoopNormals(this->WithMidpoints(this->Prepared->Deform(pose, this->NormalReach).Points)),
    wanted, tangents);
  if (options.OptimizeNormals)
  {
    result.Shape = this->Smoothly(pose, wanted, options, progress);
  }
  else
  {
    result.Shape = this->Prepared->Deform(pose, all, progress);
    result.Shape.Points = this->WithMidpoints(result.Shape.Points);
  }
  result.AnglesAfter = AnglesAcross(this->LoopNormals(result.Shape.Points), wanted, tangents);
  result.Shape.Points *= scale;
  result.Turns = TurnsBetween(posed, pose);
  return result;
}

const FeatureFootprint& FeatureToPaste::SingleBase(
  const std::string& target, const std::string& remedy) const
{
  if (this->Stands.size() > 1)
  {
    throw InvalidInput("the target " + target +
      ", to which only one loop can be joined, but the feature has " +
      std::to_string(this->Stands.size()) + " loops to join; set Loops to One, or " + remedy);
  }
  return this->Stands.front();
}

/// Completes the result on a target that is no manifold.
template <typename Landing>
void FeatureToPaste::Finish(const Landing& landing, Deformed deformed, const SurfaceLocator& target,
  PastedFeature& result) const
{
  RequireFinite(result.Surface.Points, "the result");
  result.AnglesBefore = std::move(deformed.AnglesBefore);
  result.AnglesAfter = std::move(deformed.AnglesAfter);
  result.Facts = this->Prepared->Facts();
  result.Loop = { landing.Positions, landing.Normals, std::move(deformed.Turns) };
  LoopOnTarget& there = result.Landings.front();
  there.Seed = landing.Seed;
  there.Positions = landing.Positions;
  there.Normals = landing.Normals;
  there.Cover.Positions = target.Find(landing.Positions);
}

// Section 4.2 of the paper:
// 1. Map the loops to the target by the exponential maps of both (PasteTarget::Land).
// 2. Deform the feature to follow its loops, with frames that rotate the bases' normals to the
//    target's.
// 3. Optimise the frames, and remove the remaining angles at the loops (Smoothly).
// 4. Remove the covered triangles, and join both by the bands (JoinFeatureAndTarget).
// 5. Check that the result is a manifold with the expected Euler number.
PastedFeature FeatureToPaste::PasteOn(PasteTarget& target, const PastePlacement& placement,
  const PasteFeatureOptions& options, const Progress& progress) const
{
  std::vector<LoopOnTarget> landings = target.Land(this->Stands, placement, !options.Dragging,
    progress.Part(0.0, 0.3, "placing the base on the target"));
  Eigen::MatrixXd positions(this->Loop.size(), 3), normals(this->Loop.size(), 3);
  Eigen::Index row = 0;
  bool fits = true;
  for (const LoopOnTarget& landing : landings)
  {
    positions.middleRows(row, landing.Positions.rows()) = landing.Positions;
    normals.middleRows(row, landing.Normals.rows()) = landing.Normals;
    row += landing.Positions.rows();
    fits = fits && landing.Join.Triangles.rows() == 0;
  }
  Deformed deformed = this->DeformTo(
    positions, normals, placement.Scale, options, progress.Part(0.3, 0.9, "deforming the feature"));
  // If the loops replace the rings, point for point, no edge can exist twice.
  const auto given = static_cast<int>(this->Feature.Points().rows());
  PastedFeature result = JoinFeatureAndTarget(target.Surface(),
    fits ? SplitEdges(this->Feature.Triangles(), {}, given) : this->Cut, this->Stands, landings,
    deformed.Shape.Points.topRows(fits ? given : deformed.Shape.Points.rows()));
  result.AnglesBefore = std::move(deformed.AnglesBefore);
  result.AnglesAfter = std::move(deformed.AnglesAfter);
  result.Facts = this->Prepared->Facts();
  result.Loop = { std::move(positions), std::move(normals), std::move(deformed.Turns) };
  // Disks are removed from the target, and the feature is joined along their circles.
  // A side across a gap of the feature is an edge of the band, if there is one, but of no triangle
  // of the feature.
  result.EulerNumber = target.EulerNumber() - static_cast<int>(landings.size()) +
    this->Feature.Topology().EulerNumber - (fits ? 0 : this->SidesAcrossGaps());
  result.Landings = std::move(landings);
  if (!options.Dragging)
  {
    this->Check(result);
  }
  progress(1.0);
  return result;
}

// As on a manifold, but points are joined, and no triangles (JoinFeatureAndPoints).
PastedFeature FeatureToPaste::PasteOn(PointTarget& target, const Eigen::MatrixXd& normals,
  const PastePlacement& placement, const PasteFeatureOptions& options,
  const Progress& progress) const
{
  const FeatureFootprint& base = this->SingleBase("is a point cloud", "use a surface as target");
  const LoopOnPoints landing =
    target.Land(base, placement, progress.Part(0.0, 0.3, "placing the base on the target"));
  Deformed deformed = this->DeformTo(landing.Positions, landing.Normals, placement.Scale, options,
    progress.Part(0.3, 0.9, "deforming the feature"));
  const Eigen::MatrixXd points = deformed.Shape.Points.topRows(this->Feature.Points().rows());
  PastedFeature result = JoinFeatureAndPoints(target, base, landing, points,
    MoveNormals(this->Feature, points, normals, deformed.Shape.Rotations));
  this->Finish(landing, std::move(deformed), target.Closest(), result);
  progress(1.0);
  return result;
}

// As on a manifold, but the soup is cut along the loop and needs no band (JoinFeatureAndSoup).
PastedFeature FeatureToPaste::PasteOn(SoupTarget& target, const PastePlacement& placement,
  const PasteFeatureOptions& options, const Progress& progress) const
{
  const FeatureFootprint& base =
    this->SingleBase("is a polygon soup", "repair the target with Shape Solidify");
  const LoopOnSoup landing =
    target.Land(base, placement, progress.Part(0.0, 0.4, "placing the base on the target"));
  Deformed deformed = this->DeformTo(landing.Positions, landing.Normals, placement.Scale, options,
    progress.Part(0.4, 0.9, "deforming the feature"));
  PastedFeature result = JoinFeatureAndSoup(this->Feature.Triangles(), base, landing,
    deformed.Shape.Points.topRows(this->Feature.Points().rows()));
  this->Finish(landing, std::move(deformed), target.Closest(), result);
  progress(1.0);
  return result;
}

} // namespace shape
