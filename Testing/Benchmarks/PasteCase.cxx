// Features of one model set down on another, drawn at random: see Usage.
#include "BenchmarkData.h"
#include "Cost.h"

#include "Base/Errors.h"
#include "CutPaste/CutFeature.h"
#include "CutPaste/PasteFeature.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Topology.h"
#include "Planar/PlanarLocator.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"(paste_case drop FEATURE TARGET SEED
paste_case drag FEATURE TARGET TRIANGLES UPDATES

FEATURE, TARGET  OFF files; points at the same position are joined, the longest side of each box is
                 made 1
drop  cuts a feature at a position drawn with SEED, of a radius drawn between 0.05 and 0.12 of the
      diagonal; sets it down where it was cut, then at a position of the target with a rotation drawn
      likewise, and as large as 0.05 to 0.1 of the target's diagonal. Prints a line: the feature's
      triangles and Euler number; how far points are off in position, over the diagonal; "refused" and
      the reason, or the Euler numbers of the target and the result, how many open loops both have,
      points and edges of the result that are not manifold, and the angles between the feature's and
      the target's normals at each point of the loop, before and after.
drag  cuts a feature of about so many triangles and drags it over the target: prints the seconds of
      an update in the mean, and how many positions were refused.)";

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
    const shape::PlanarPoint at =
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

void Drop(const std::string& from, const std::string& to, unsigned int seed)
{
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
    catch (const shape::InvalidInput& error)
    {
      std::printf("# no cut: %s\n", error.what());
    }
  }
  const shape::Mesh& part = feature->Cut.Feature.Surface;
  const shape::FeatureFootprint& base = *feature->Cut.Base;
  std::printf("draws=%d triangles=%d euler=%d loop=%d ", draws,
    static_cast<int>(part.Triangles.rows()), shape::ComputeTopology(part).EulerNumber,
    static_cast<int>(base.Loop.size()));
  const shape::PastePlacement elsewhere{ goal.Points.row(RandomPoint(random, goal)),
    Uniform(random, -180.0, 180.0),
    Uniform(random, 0.05, 0.1) * shape::ComputeBoxDiagonal(goal.Points) / LoopRadius(base) };
  try
  {
    const shape::FeatureToPaste paste(part, base);
    shape::PasteTarget home(feature->Cut.Rest.Surface);
    const shape::PastedFeature back = paste.PasteOn(home, { feature->Cut.Seed, 0.0, 1.0 });
    std::printf("inplace=%.2g ",
      (back.Surface.Points.middleRows(
         (back.Target.Points.array() >= 0).count(), part.Points.rows()) -
        part.Points)
          .cwiseAbs()
          .maxCoeff() /
        size);
    shape::PasteTarget target(goal);
    const shape::PastedFeature pasted = paste.PasteOn(target, elsewhere);
    const shape::Topology before = shape::ComputeTopology(goal);
    const shape::Topology after = shape::ComputeTopology(pasted.Surface);
    std::printf("conformal=%d%d target=%d result=%d open=%d,%d nonmanifold=%d before=",
      base.ConformalRadius > 0.0 ? 1 : 0, static_cast<int>(pasted.Position.Layout),
      before.EulerNumber, after.EulerNumber, before.BoundaryLoops, after.BoundaryLoops,
      after.NonManifoldEdges + after.NonManifoldPoints + after.MisorientedEdges);
    for (const double angle : pasted.AnglesBefore)
    {
      std::printf("%.2f,", angle);
    }
    std::printf(" after=");
    for (const double angle : pasted.AnglesAfter)
    {
      std::printf("%.2f,", angle);
    }
    std::printf("\n");
  }
  catch (const shape::InvalidInput& error)
  {
    std::printf("refused=%s\n", error.what());
  }
}

void Drag(const std::string& from, const std::string& to, int triangles, int updates)
{
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
  const shape::FeatureToPaste paste(feature->Cut.Feature.Surface, *feature->Cut.Base);
  shape::PasteTarget target(goal);
  shape::PastePlacement position;
  position.Scale = 0.08 * shape::ComputeBoxDiagonal(goal.Points) / LoopRadius(*feature->Cut.Base);
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
  std::printf("feature=%d target=%d updates=%d refused=%d cpu=%.4f wall=%.4f\n",
    static_cast<int>(feature->Cut.Feature.Surface.Triangles.rows()),
    static_cast<int>(goal.Triangles.rows()), updates, refused, cost.Cpu / updates,
    cost.Wall / updates);
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    const std::string mode = argc > 1 ? argv[1] : "";
    if (mode == "drop" && argc == 5)
    {
      Drop(argv[2], argv[3], static_cast<unsigned int>(std::stoul(argv[4])));
      return 0;
    }
    if (mode == "drag" && argc == 6)
    {
      Drag(argv[2], argv[3], std::stoi(argv[4]), std::stoi(argv[5]));
      return 0;
    }
    std::puts(Usage);
  }
  catch (const std::exception& error)
  {
    std::printf("failed: %s\n", error.what());
  }
  return 1;
}
