#include "Surface/Parameterize.h"

#include "Core/Errors.h"
#include "Quality/ConformalDistortion.h"
#include "Surface/SphereMap.h"

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
  if (!(options.AreaWeight >= 0.0))
  {
    throw InvalidInput("AreaWeight is " + std::to_string(options.AreaWeight) +
      "; give 0 for angles, or a positive number for areas");
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
  const Mesh& surface, const ParameterizeOptions& options, const Progress& progress)
{
  const SphereMapResult map = SphereMap(surface, ForSphere(options), progress);
  ParameterizeResult result;
  result.Positions = map.Points;
  if (EnclosedVolume(surface) < 0.0)
  {
    // The image faces outwards: the map would mirror what is inside.
    result.Positions.col(2) *= -1.0;
  }
  result.Method = Word(map.Method);
  result.Iterations = map.Iterations;
  result.ReinsertedPoints = map.Reinserted;
  return result;
}

ParameterizeResult OntoDisk(
  const Mesh& surface, const ParameterizeOptions& options, const Progress& progress)
{
  const DiskMapResult map = DiskMap(surface, { options.Weights, options.Outline }, progress);
  ParameterizeResult result;
  result.Positions = map.Points;
  result.Method = Word(options.Weights);
  result.FlippedTriangles = map.FlippedTriangles;
  result.LoopLength = map.LoopLength;
  return result;
}

} // namespace

ParameterizeResult Parameterize(
  const Mesh& surface, const ParameterizeOptions& options, const Progress& progress)
{
  ParameterizeResult result = options.Domain == ParameterizeOptions::DomainType::Disk
    ? OntoDisk(surface, options, progress)
    : OntoSphere(surface, options, progress);
  const Eigen::VectorXd areas = AreaVectors(surface).rowwise().norm();
  result.ConformalDistortion =
    areas.dot(ConformalDistortion(surface, result.Positions)) / areas.sum();
  return result;
}

} // namespace shape
