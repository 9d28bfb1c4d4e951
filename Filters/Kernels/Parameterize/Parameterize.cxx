#include "Parameterize/Parameterize.h"

#include "Base/Errors.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Parameterize/FreeBoundaryMap.h"
#include "Parameterize/HyperbolicOrbifold.h"
#include "Parameterize/OrbifoldInput.h"
#include "Parameterize/OrbifoldTutte.h"
#include "Parameterize/SphereMap.h"
#include "Quality/ConformalDistortion.h"
#include "Quality/MapQuality.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

const char* Word(SphereMapMethod method)
{
  switch (method)
  {
    case SphereMapMethod::ConformalFlow:
      return "ConformalFlow";
    case SphereMapMethod::PositiveFlow:
      return "PositiveFlow";
    case SphereMapMethod::GlobalReinsertion:
      break;
  }
  return "GlobalReinsertion";
}

SphereMapOptions ForSphere(const ParameterizeOptions& options)
{
  if (!(options.AreaWeight >= 0.0) || std::isinf(options.AreaWeight))
  {
    throw InvalidInput("AreaWeight is " + std::to_string(options.AreaWeight) +
      "; give 0 to preserve angles, or a positive number to balance areas as well");
  }
  SphereMapOptions sphere;
  if (options.AreaWeight > 0.0)
  {
    sphere.First = SphereMapMethod::GlobalReinsertion;
    sphere.AreaWeight = options.AreaWeight;
  }
  return sphere;
}

const char* Word(CombinationWeights weights)
{
  switch (weights)
  {
    case CombinationWeights::Uniform:
      return "Uniform";
    case CombinationWeights::Cotangent:
      return "Cotangent";
    case CombinationWeights::MeanValue:
      break;
  }
  return "MeanValue";
}

ParameterizeResult OntoSphere(
  const Surface& surface, const ParameterizeOptions& options, const Progress& progress)
{
  const SphereMapResult map = MapToSphere(surface, ForSphere(options), progress);
  ParameterizeResult result;
  result.Positions = map.Points;
  if (ComputeEnclosedVolume(surface) < 0.0)
  {
    // The sphere map faces outwards, so the image of a surface that faces inwards is mirrored back.
    result.Positions.col(2) *= -1.0;
  }
  result.Method = Word(map.Method);
  result.Iterations = map.Iterations;
  result.ReinsertedPoints = map.Reinserted;
  return result;
}

/// Returns the factor that scales the surface to its image's area.
double ScaleTo(const Eigen::MatrixXd& image, const Surface& surface)
{
  return std::sqrt(ComputeArea({ image, surface.Triangles() }) / ComputeArea(surface));
}

bool IsRefined(const ParameterizeOptions& options)
{
  return options.Refine != RefineType::None;
}

std::string Word(RefineType refine)
{
  static constexpr const char* words[] = { "None", "SymmetricDirichlet",
    "ExponentialSymmetricDirichlet", "AMIPS", "ConformalAMIPS", "Hencky", "ARAP" };
  return words[static_cast<int>(refine)];
}

InjectiveRefinementOptions ForRefinement(const ParameterizeOptions& options)
{
  InjectiveRefinementOptions refinement;
  refinement.Measure = GetMeasure(options.Refine);
  refinement.Exponent = options.RefineExponent;
  return refinement;
}

ParameterizeResult OntoDisk(
  const Surface& surface, const ParameterizeOptions& options, const Progress& progress)
{
  const Progress mapping = progress.Part(0.0, IsRefined(options) ? 0.3 : 1.0);
  const DiskMapResult map = MapToDisk(surface, { options.Weights, options.Outline }, mapping);
  ParameterizeResult result;
  result.Positions = map.Points;
  result.Method = Word(options.Weights);
  result.FlippedTriangles = map.FlippedTriangles;
  result.LoopLength = map.LoopLength;
  if (IsRefined(options))
  {
    InjectiveRefinementOptions refinement = ForRefinement(options);
    refinement.Scale = ScaleTo(map.Points, surface);
    const InjectiveRefinementResult refined = RefineInjectively(surface, map.Points.leftCols(2),
      map.Loop, refinement, progress.Part(0.3, 1.0, "lowering the distortion"));
    result.Positions.leftCols(2) = refined.Points;
    result.Method = Word(options.Refine);
    result.Iterations = refined.Iterations;
    result.MeasureBefore = refined.StartEnergy;
    result.MeasureAfter = refined.Energy;
  }
  return result;
}

ParameterizeResult WithFreeBoundary(
  const Surface& surface, const ParameterizeOptions& options, const Progress& progress)
{
  FreeBoundaryMapOptions own;
  own.Refine = IsRefined(options);
  if (own.Refine)
  {
    own.Refinement = ForRefinement(options);
  }
  const FreeBoundaryMapResult map = MapWithFreeBoundary(surface, own, progress);
  ParameterizeResult result;
  result.Positions = map.Points;
  result.Method = own.Refine ? Word(options.Refine) : "BoundaryFirst";
  result.Iterations = map.Iterations;
  result.MeasureBefore = map.MeasureBefore;
  result.MeasureAfter = map.MeasureAfter;
  result.LoopLength = map.LoopLength;
  return result;
}

std::string Word(OrbifoldType type)
{
  switch (type)
  {
    case OrbifoldType::Square:
      return "Square";
    case OrbifoldType::Rhombus:
      return "Rhombus";
    case OrbifoldType::Triangle:
      return "Triangle";
    case OrbifoldType::Rectangle:
      break;
  }
  return "Parallelogram";
}

/// Returns the points of the surface nearest to the landmarks.
std::vector<int> NearestPoints(const Surface& surface, const Eigen::MatrixXd& landmarks)
{
  RequireFinite(landmarks, "the Landmarks");
  RequireFinite(surface.Points(), "the surface");
  std::vector<int> points;
  for (const auto& landmark : landmarks.rowwise())
  {
    Eigen::Index nearest = 0;
    (surface.Points().rowwise() - landmark).rowwise().squaredNorm().minCoeff(&nearest);
    points.push_back(static_cast<int>(nearest));
  }
  return points;
}

/// Sets the result of a map of a surface that is cut open. points: k x 2.
void SetCutImage(
  ParameterizeResult& result, CutSurface cut, const Eigen::MatrixXd& points, Eigen::Index uncut)
{
  result.CutPositions = Eigen::MatrixXd::Zero(points.rows(), 3);
  result.CutPositions.leftCols(2) = points;
  result.Positions = result.CutPositions.topRows(uncut);
  result.Cut = std::move(cut);
}

/// The image in the Poincare disk, which preserves angles.
ParameterizeResult OntoHyperbolicOrbifold(
  const Surface& surface, const Eigen::MatrixXd& landmarks, const Progress& progress)
{
  HyperbolicImage image =
    MapToHyperbolicOrbifold(surface, NearestPoints(surface, landmarks), progress.Part(0.0, 0.85));
  const Eigen::MatrixXd points = ProjectToPoincare(image.Points);
  // Straight edges replace the arcs of circles, and might turn over a flat triangle.
  RequireUnflippedTile(image.Cut.Surface, points);
  ParameterizeResult result;
  SetCutImage(result, std::move(image.Cut), points, surface.Points().rows());
  result.Iterations = image.Iterations;
  result.Method = "Hyperbolic";
  return result;
}

ParameterizeResult OntoOrbifold(const Surface& surface, const Eigen::MatrixXd& landmarks,
  const ParameterizeOptions& options, const Progress& progress)
{
  if (landmarks.rows() < 3)
  {
    throw InvalidInput("the Orbifold has 3 or more cones, but there are " +
      std::to_string(landmarks.rows()) + " Landmarks; give 3 or more points near the surface");
  }
  if (landmarks.rows() > 4)
  {
    return OntoHyperbolicOrbifold(surface, landmarks, progress);
  }
  const OrbifoldType type = landmarks.rows() == 4 ? OrbifoldType::Rectangle : options.Tile;
  OrbifoldImage image =
    MapToOrbifold(surface, NearestPoints(surface, landmarks), type, progress.Part(0.0, 0.85));
  if (type == OrbifoldType::Rectangle)
  {
    image.Points = FitToBestParallelogram(image);
  }
  ParameterizeResult result;
  SetCutImage(result, std::move(image.Cut), image.Points, surface.Points().rows());
  result.FlippedTriangles = image.FlippedTriangles;
  result.Method = Word(type);
  return result;
}

/// Throws InvalidInput if the domain does not fit the surface; the message names one that does.
void RequireDomain(const Surface& surface, ParameterizeOptions::DomainType domain)
{
  using Domain = ParameterizeOptions::DomainType;
  const Topology topology = RequireManifold(surface, "the surface");
  const bool isForClosed = domain == Domain::Sphere || domain == Domain::Orbifold;
  if (topology.Components > 1)
  {
    throw InvalidInput("the surface has " + std::to_string(topology.Components) +
      " components; keep one with Connectivity / Extract Largest, or merge points at the same "
      "position with Clean");
  }
  if (!isForClosed && topology.BoundaryLoops == 0)
  {
    throw InvalidInput("the surface is closed; choose the Domain Sphere or Orbifold, or cut it "
                       "open first, for example with Clip");
  }
  if (topology.BoundaryLoops > (isForClosed ? 0 : 1) && domain != Domain::FreeBoundary)
  {
    throw InvalidInput("the surface has " + std::to_string(topology.BoundaryLoops) +
      (topology.BoundaryLoops == 1 ? " open loop" : " open loops") + " (first at point " +
      std::to_string(topology.FirstOpenPoint) + "), but the Domain needs " +
      (isForClosed
          ? "a closed surface; choose FreeBoundary, close the surface with Shape Fill Holes, or "
            "merge its duplicate points with Clean"
          : "one; choose FreeBoundary, or close all but the outer one with Shape Fill Holes"));
  }
}

ParameterizeResult Onto(const Surface& surface, const Eigen::MatrixXd& landmarks,
  const ParameterizeOptions& options, const Progress& progress)
{
  using Domain = ParameterizeOptions::DomainType;
  if (options.Domain != Domain::Orbifold && landmarks.rows() > 0)
  {
    throw InvalidInput(
      "Landmarks are the cones of the Orbifold; choose that Domain, or leave Landmarks empty");
  }
  RequireDomain(surface, options.Domain);
  switch (options.Domain)
  {
    case Domain::Disk:
      return OntoDisk(surface, options, progress);
    case Domain::FreeBoundary:
      return WithFreeBoundary(surface, options, progress);
    case Domain::Orbifold:
      return OntoOrbifold(surface, landmarks, options, progress);
    case Domain::Sphere:
      break;
  }
  return OntoSphere(surface, options, progress);
}

} // namespace

ParameterizeResult Parameterize(const Surface& surface, const Eigen::MatrixXd& landmarks,
  const ParameterizeOptions& options, const Progress& progress)
{
  RequireOption(options.RefineExponent > 0.0 && std::isfinite(options.RefineExponent),
    "RefineExponent", options.RefineExponent, "positive");
  ParameterizeResult result = Onto(surface, landmarks, options, progress.Part(0.0, 0.9));
  const bool isCut = options.Domain == ParameterizeOptions::DomainType::Orbifold;
  const Mesh& mapped = isCut ? result.Cut.Surface : surface.AsMesh();
  const Eigen::MatrixXd& image = isCut ? result.CutPositions : result.Positions;
  progress(0.9);
  // The mean distortion, weighted by the surface's area: twice the areas serve as weights.
  const Eigen::VectorXd areas = ComputeAreaVectors(mapped).rowwise().norm();
  result.ConformalDistortion = areas.dot(ComputeConformalDistortion(mapped, image)) / areas.sum();
  progress(0.93);
  if (options.Domain != ParameterizeOptions::DomainType::Sphere)
  {
    // A free boundary has the size of minimum distortion. The other domains have a fixed size, so
    // the surface is scaled to the image's area.
    const bool hasOwnSize = options.Domain == ParameterizeOptions::DomainType::FreeBoundary;
    const SimplexElements<2> elements =
      BuildTriangleElements(mapped, hasOwnSize ? 1.0 : ScaleTo(image, mapped));
    progress(0.97);
    result.Energy = std::min(
      LargestMeasure, elements.Energy(image.leftCols(2), Distortion::SymmetricDirichlet, 1.0));
  }
  return result;
}

ParameterizeResult Parameterize(
  const Surface& surface, const ParameterizeOptions& options, const Progress& progress)
{
  return Parameterize(surface, Eigen::MatrixXd(0, 3), options, progress);
}

} // namespace shape
