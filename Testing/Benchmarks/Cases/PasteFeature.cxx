// Features of one model set down on another, drawn at random.
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "Base/Errors.h"
#include "CutPaste/CutFeature.h"
#include "CutPaste/PasteFeature.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Topology.h"
#include "Planar/PlanarLocator.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr const char* DropUsage = R"(FEATURE TARGET SEED

FEATURE, TARGET  OFF files; points at the same position are joined, the longest side of each box is
                 made 1

Cuts a feature at a position drawn with SEED, of a radius drawn between 0.05 and 0.12 of the diagonal;
sets it down where it was cut, then at a position of the target with a rotation drawn likewise, and as
large as 0.05 to 0.1 of the target's diagonal. The feature's triangles and Euler number; inplace: how
far points are off in position, over the diagonal; refused, with the reason, or the Euler numbers of
the target and the result, how many open loops both have, points and edges of the result that are not
manifold, and the angles between the feature's and the target's normals at each point of the loop,
before and after.)";

constexpr const char* DragUsage = R"(FEATURE TARGET TRIANGLES UPDATES

Cuts a feature of about so many triangles and drags it over the target: the seconds of an update in the
mean, and how many positions were refused. Models are read as in paste_feature.)";

/// A feature around a point, cut along a circle of the exponential map.
struct Feature
{
  shape::CutFeatureResult Cut;
  Eigen::RowVector3d Seed;
};

std::optional<Feature> CutAround(const shape::Mesh& surface, int point, double radius)
{
  shape::ExponentialMap map(surface);
  const shape::ExponentialPatch patch =
    map.Around(Eigen::RowVector3d(surface.Points.row(point)), 1.5 * radius);
  const shape::PlanarLocator inPlane(patch.Positions, patch.Corners);
  constexpr int corners = 48;
  Eigen::MatrixXd curve(corners, 3);
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * M_PI * i / corners;
    const shape::SurfacePoint at =
      inPlane.Find(radius * Eigen::RowVector2d(std::cos(angle), std::sin(angle)));
    if (at.Triangle < 0)
    {
      return {};
    }
    curve.row(i).setZero();
    for (int k = 0; k < 3; ++k)
    {
      curve.row(i) +=
        at.Barycentric(k) * surface.Points.row(patch.Points[patch.Corners(at.Triangle, k)]);
    }
  }
  return Feature{ shape::CutFeature(surface, { curve }), surface.Points.row(point) };
}

double Uniform(std::mt19937& random, double low, double high)
{
  return low + (high - low) * std::generate_canonical<double, 32>(random);
}

int RandomPoint(std::mt19937& random, const shape::Mesh& mesh)
{
  return static_cast<int>(Uniform(random, 0.0, 1.0) * static_cast<double>(mesh.Points.rows() - 1));
}

/// How far the loop is from the seed, in the mean.
double LoopRadius(const shape::FeatureFootprint& base)
{
  return base.LoopPositions.rowwise().norm().mean();
}

template <typename Angles>
std::vector<double> ToList(const Angles& angles)
{
  return { angles.begin(), angles.end() };
}

void Require(const std::optional<Feature>& feature)
{
  if (!feature)
  {
    throw shape::SolveFailure("no feature could be cut in 50 draws");
  }
}

void Drop(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string from = arguments.NextWord(), to = arguments.NextWord();
  const auto seed = static_cast<unsigned int>(arguments.NextInteger());
  arguments.RequireAllRead();
  const shape::Mesh source = benchmark::ReadOff(from, true), goal = benchmark::ReadOff(to, true);
  std::mt19937 random(seed);
  const double size = shape::ComputeBoxDiagonal(source.Points);
  std::optional<Feature> feature;
  int draws = 0;
  for (; !feature && draws < 50; ++draws)
  {
    try
    {
      feature = CutAround(source, RandomPoint(random, source), Uniform(random, 0.05, 0.12) * size);
    }
    catch (const shape::InvalidInput&) // no circle there
    {
    }
  }
  Require(feature);
  const shape::Mesh& part = feature->Cut.Feature.Surface;
  const shape::FeatureFootprint& base = feature->Cut.Bases.front();
  benchmark::Row row;
  row.Add("draws", draws)
    .Add("triangles", part.Triangles.rows())
    .Add("euler", shape::ComputeTopology(part).EulerNumber)
    .Add("loop", base.Loop.size());
  const shape::PastePlacement elsewhere{ goal.Points.row(RandomPoint(random, goal)),
    Uniform(random, -180.0, 180.0),
    Uniform(random, 0.05, 0.1) * shape::ComputeBoxDiagonal(goal.Points) / LoopRadius(base) };
  try
  {
    const shape::FeatureToPaste paste(part, base);
    shape::PasteTarget home(feature->Cut.Rest.Surface);
    const shape::PastedFeature back =
      paste.PasteOn(home, { feature->Cut.Bases.front().Origin, 0.0, 1.0 });
    const auto inPlace =
      back.Surface.Points.middleRows((back.Target.Points.array() >= 0).count(), part.Points.rows());
    row.Add("inplace", (inPlace - part.Points).cwiseAbs().maxCoeff() / size);
    shape::PasteTarget target(goal);
    const shape::PastedFeature pasted = paste.PasteOn(target, elsewhere);
    const shape::Topology before = shape::ComputeTopology(goal);
    const shape::Topology after = shape::ComputeTopology(pasted.Surface);
    row.Add("conformal", base.ConformalRadius > 0.0)
      .Add("layout", static_cast<int>(pasted.Landings.front().Layout))
      .Add("target", before.EulerNumber)
      .Add("result", after.EulerNumber)
      .Add("openbefore", before.BoundaryLoops)
      .Add("openafter", after.BoundaryLoops)
      .Add("nonmanifold", after.NonManifoldEdges + after.NonManifoldPoints + after.MisorientedEdges)
      .Add("before", ToList(pasted.AnglesBefore))
      .Add("after", ToList(pasted.AnglesAfter));
  }
  catch (const shape::InvalidInput& error)
  {
    row.Add("refused", std::string(error.what()));
  }
  figures.Print(row);
}

void Drag(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string from = arguments.NextWord(), to = arguments.NextWord();
  const int triangles = arguments.NextInteger(), updates = arguments.NextInteger();
  arguments.RequireAllRead();
  const shape::Mesh source = benchmark::ReadOff(from, true), goal = benchmark::ReadOff(to, true);
  std::mt19937 random(1);
  std::optional<Feature> feature;
  shape::ExponentialMap map(source);
  for (int draw = 0; draw < 50 && !feature; ++draw)
  {
    // As large as it must be for so many triangles.
    const int middle = RandomPoint(random, source);
    double low = 0.0, high = 0.5 * shape::ComputeBoxDiagonal(source.Points);
    for (int step = 0; step < 20; ++step)
    {
      const double radius = (low + high) / 2.0;
      const std::size_t within =
        map.Around(Eigen::RowVector3d(source.Points.row(middle)), radius).Triangles.size();
      (static_cast<int>(within) > triangles ? high : low) = radius;
    }
    try
    {
      feature = CutAround(source, middle, low);
    }
    catch (const shape::InvalidInput&) // no circle there
    {
    }
  }
  Require(feature);
  const shape::FeatureToPaste paste(feature->Cut.Feature.Surface, feature->Cut.Bases.front());
  shape::PasteTarget target(goal);
  shape::PastePlacement position;
  position.Scale =
    0.08 * shape::ComputeBoxDiagonal(goal.Points) / LoopRadius(feature->Cut.Bases.front());
  shape::PasteFeatureOptions options;
  options.Dragging = true;
  int refused = 0;
  Eigen::RowVector3d at = goal.Points.row(RandomPoint(random, goal));
  const Eigen::RowVector3d to2 = goal.Points.row(RandomPoint(random, goal));
  const benchmark::Cost cost = benchmark::Measure(
    [&]
    {
      for (int i = 0; i < updates; ++i)
      {
        const double share = static_cast<double>(i) / updates;
        position.Seed = (1.0 - share) * at + share * to2;
        position.Rotation = 360.0 * share;
        try
        {
          paste.PasteOn(target, position, options);
        }
        catch (const shape::InvalidInput&)
        {
          ++refused;
        }
      }
    });
  figures.Print(benchmark::Row()
                  .Add("feature", feature->Cut.Feature.Surface.Triangles.rows())
                  .Add("target", goal.Triangles.rows())
                  .Add("updates", updates)
                  .Add("refused", refused)
                  .Add("cpu", cost.Cpu / updates)
                  .Add("wall", cost.Wall / updates));
}

const benchmark::Entry PasteFeature("paste_feature", { DropUsage, Drop });
const benchmark::Entry DragFeature("drag_feature", { DragUsage, Drag });

} // namespace
