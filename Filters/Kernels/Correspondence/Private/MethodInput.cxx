#include "Correspondence/Private/MethodInput.h"

#include "Base/Errors.h"
#include "Correspondence/CommonBase/BaseGenus.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using Method = CorrespondenceOptions::MethodType;

std::string NameOf(Method method)
{
  switch (method)
  {
    case Method::ReversibleHarmonic:
      return "ReversibleHarmonic";
    case Method::FunctionalMap:
      return "FunctionalMap";
    case Method::GromovWasserstein:
      return "GromovWasserstein";
    case Method::HeatKernel:
      return "HeatKernel";
    case Method::BlendedIntrinsic:
      return "BlendedIntrinsic";
    case Method::CommonSphere:
      return "CommonSphere";
    case Method::CommonOrbifold:
      return "CommonOrbifold";
    case Method::WeightedAverages:
      return "WeightedAverages";
    case Method::GeneralizedMDS:
      return "GeneralizedMDS";
    case Method::CommonBase:
      break;
  }
  return "CommonBase";
}

/// "3 open loops"
std::string Counted(int count, const std::string& what)
{
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

void RequireComponents(const Topology& topology, const std::string& name, bool hasLandmarks,
  const CorrespondenceOptions& options)
{
  if (topology.Components == 1)
  {
    return;
  }
  const auto second = std::find(topology.ComponentId.begin(), topology.ComponentId.end(), 1) -
    topology.ComponentId.begin();
  const std::string fact = name + " has " + Counted(topology.Components, "component") +
    " (the second begins at point " + std::to_string(second) + "), but ";
  const std::string remedy =
    ": merge coincident points with Clean, match the components one by one (Connectivity), ";
  const bool takesSeveral =
    options.Method == Method::FunctionalMap || options.Method == Method::HeatKernel;
  if (!takesSeveral)
  {
    throw InvalidInput(fact + NameOf(options.Method) + " needs one" + remedy +
      "or take FunctionalMap with Landmarks on each");
  }
  if (!hasLandmarks)
  {
    throw InvalidInput(fact + "landmarks can only be found on surfaces with one component" +
      remedy + "or give Landmarks on each");
  }
  if (options.Method == Method::FunctionalMap && topology.Components >= options.NumberOfEigenpairs)
  {
    throw InvalidInput(fact + "NumberOfEigenpairs is only " +
      std::to_string(options.NumberOfEigenpairs) + remedy + "or raise it above their number");
  }
}

void RequireSuitable(const Topology& topology, const std::string& name, Method method)
{
  const bool needsSphere = method == Method::CommonSphere || method == Method::CommonOrbifold;
  const bool needsClosed = needsSphere || method == Method::CommonBase;
  if (needsClosed && topology.BoundaryLoops > 0)
  {
    throw InvalidInput(name + " has " + Counted(topology.BoundaryLoops, "open loop") +
      " (first at point " + std::to_string(topology.FirstOpenPoint) + "), but " + NameOf(method) +
      " needs closed surfaces: close it with Shape Fill Holes, merge its duplicate points with "
      "Clean, "
      "or take ReversibleHarmonic, FunctionalMap or BlendedIntrinsic");
  }
  const int genus = ComputeGenus(topology);
  if ((needsSphere || method == Method::BlendedIntrinsic) && genus > 0)
  {
    throw InvalidInput(name + " has genus " + std::to_string(genus) + ", but " + NameOf(method) +
      " needs genus 0: cut each handle with Clip and close the cuts with Shape Fill Holes, or take "
      "CommonBase, ReversibleHarmonic or FunctionalMap");
  }
}

/// A common base domain needs one genus. Fewer landmarks than this leave it without patches.
void RequireCommonBase(const Surface& a, const Surface& b, const Landmarks& landmarks)
{
  const int genus = ComputeGenus(a.Topology()), other = ComputeGenus(b.Topology());
  if (genus != other)
  {
    throw InvalidInput("SurfaceA has genus " + std::to_string(genus) + " and SurfaceB has genus " +
      std::to_string(other) +
      ", so no map between them is one to one, but CommonBase needs one; close or cut handles with "
      "Shape Solidify, or take ReversibleHarmonic");
  }
  if (genus > MaximumBaseGenus)
  {
    throw InvalidInput("the surfaces have genus " + std::to_string(genus) +
      ", but CommonBase needs genus " + std::to_string(MaximumBaseGenus) +
      " or less; take ReversibleHarmonic or FunctionalMap");
  }
  const std::size_t minimum = genus == 0 ? 3 : 2;
  if (!landmarks.empty() && landmarks.size() < minimum)
  {
    throw InvalidInput("there " + std::string(landmarks.size() == 1 ? "is " : "are ") +
      Counted(static_cast<int>(landmarks.size()), "distinct landmark") + ", but CommonBase needs " +
      std::to_string(minimum) + " for surfaces of genus " + std::to_string(genus) +
      "; give more, or none to have them found");
  }
}

/// The sign of the volume enclosed by a closed surface; 0 if the volume is negligible.
/// Below rounding relative to the box, a flat closed surface has no side.
int SideOf(const Mesh& mesh)
{
  const double volume = ComputeEnclosedVolume(mesh), size = ComputeLongestBoxEdge(mesh.Points);
  return std::abs(volume) < 1e-9 * size * size * size ? 0 : volume > 0.0 ? 1 : -1;
}

void RequireEnoughLandmarks(const Landmarks& landmarks, Method method)
{
  const auto count = static_cast<int>(landmarks.size());
  const std::string fact = "there " + std::string(count == 1 ? "is " : "are ") +
    Counted(count, "distinct landmark") + ", but " + NameOf(method);
  if (method == Method::CommonSphere && count < 2)
  {
    throw InvalidInput(fact +
      " needs two, since one leaves the sphere free to rotate; give two or more, or none to have "
      "them found, or "
      "take FunctionalMap or HeatKernel");
  }
  if ((method == Method::BlendedIntrinsic || method == Method::WeightedAverages) && count < 3)
  {
    throw InvalidInput(fact +
      " needs three; give three or more, or none to have them found, or take FunctionalMap or "
      "HeatKernel");
  }
  if (method == Method::CommonOrbifold && (count < 3))
  {
    throw InvalidInput(fact +
      " needs three, one for each cone; give three or more, or none to have them found, or take "
      "CommonSphere");
  }
}

} // namespace

void RequireMethodInput(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const CorrespondenceOptions& options)
{
  bool areClosed = true;
  for (const auto& [surface, name] : { std::pair(&a, "SurfaceA"), std::pair(&b, "SurfaceB") })
  {
    const Topology topology = RequireManifold(*surface, name);
    RequireArea(*surface, name);
    RequireComponents(topology, name, !landmarks.empty() || options.IsGuided(), options);
    RequireSuitable(topology, name, options.Method);
    areClosed = areClosed && topology.BoundaryLoops == 0;
  }
  if (areClosed && SideOf(a) * SideOf(b) < 0)
  {
    throw InvalidInput(std::string(SideOf(a) < 0 ? "SurfaceA faces inwards and SurfaceB"
                                                 : "SurfaceB faces inwards and SurfaceA") +
      " outwards, which would exchange left and right; reverse the former with Reverse Sense");
  }
  RequireLandmarks(landmarks, a, b);
  if (options.Method == Method::CommonBase)
  {
    RequireCommonBase(a, b, landmarks);
  }
  if (!landmarks.empty() && !options.UsesTriplets())
  {
    RequireEnoughLandmarks(landmarks, options.Method);
  }
}

PairFeatures OnCoarse(const PairFeatures& given, const CoarsePair& pair)
{
  PairFeatures features{ {}, {}, given.FeatureWeight };
  if (given.OfA.cols() > 0)
  {
    std::vector<int> onA(pair.A().Points().rows()), onB(pair.B().Points().rows());
    for (std::size_t i = 0; i < onA.size(); ++i)
    {
      onA[i] = pair.FinePointOfA(static_cast<int>(i));
    }
    for (std::size_t i = 0; i < onB.size(); ++i)
    {
      onB[i] = pair.FinePointOfB(static_cast<int>(i));
    }
    features.OfA = given.OfA(onA, Eigen::all);
    features.OfB = given.OfB(onB, Eigen::all);
  }
  return features;
}

} // namespace shape
