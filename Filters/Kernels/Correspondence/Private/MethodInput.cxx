#include "Correspondence/Private/MethodInput.h"

#include "Base/Errors.h"
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
      break;
  }
  return "CommonOrbifold";
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
    " (the second begins at point " + std::to_string(second) + "), and ";
  const std::string remedy =
    ": merge points at the same place with Clean, match the components one by one (Connectivity), ";
  const bool takesSeveral =
    options.Method == Method::FunctionalMap || options.Method == Method::HeatKernel;
  if (!takesSeveral)
  {
    throw InvalidInput(fact + NameOf(options.Method) + " matches one with one" + remedy +
      "or take FunctionalMap with Landmarks on each");
  }
  if (!hasLandmarks)
  {
    throw InvalidInput(fact + "landmarks are found on surfaces of one component" + remedy +
      "or give Landmarks on each");
  }
  if (options.Method == Method::FunctionalMap && topology.Components >= options.NumberOfEigenpairs)
  {
    throw InvalidInput(fact + "NumberOfEigenpairs, " + std::to_string(options.NumberOfEigenpairs) +
      ", tells fewer apart" + remedy + "or raise it");
  }
}

void RequireSphereLike(const Topology& topology, const std::string& name, Method method)
{
  const bool needsClosed = method == Method::CommonSphere || method == Method::CommonOrbifold;
  if (needsClosed && topology.BoundaryLoops > 0)
  {
    throw InvalidInput(name + " has " + Counted(topology.BoundaryLoops, "open loop") +
      " (first at point " + std::to_string(topology.FirstOpenPoint) + "), and " + NameOf(method) +
      " is for closed surfaces: close it with Fill Holes, merge its duplicate points with Clean, "
      "or take ReversibleHarmonic, FunctionalMap or BlendedIntrinsic");
  }
  const int genus = (2 - topology.EulerNumber - topology.BoundaryLoops) / 2;
  if ((needsClosed || method == Method::BlendedIntrinsic) && genus > 0)
  {
    throw InvalidInput(name + " has genus " + std::to_string(genus) + ", and " + NameOf(method) +
      " is for genus 0: cut its handles and fill the holes, or take ReversibleHarmonic or "
      "FunctionalMap");
  }
}

/// The sign of the volume inside a closed surface; 0 if there is hardly one.
int SideOf(const Mesh& mesh)
{
  const double volume = ComputeEnclosedVolume(mesh), size = ComputeLongestBoxEdge(mesh.Points);
  return std::abs(volume) < 1e-9 * size * size * size ? 0 : volume > 0.0 ? 1 : -1;
}

void RequireEnoughLandmarks(const Landmarks& landmarks, Method method)
{
  const auto count = static_cast<int>(landmarks.size());
  const std::string fact = "there " + std::string(count == 1 ? "is " : "are ") +
    Counted(count, "landmark") + " on points of their own, and " + NameOf(method);
  if (method == Method::CommonSphere && count < 2)
  {
    throw InvalidInput(fact +
      " needs two, since spheres turn around one; give two or more, or none to have them found, or "
      "take FunctionalMap or HeatKernel");
  }
  if (method == Method::BlendedIntrinsic && count < 3)
  {
    throw InvalidInput(fact +
      " needs three; give three or more, or none to have them found, or take FunctionalMap or "
      "HeatKernel");
  }
  if (method == Method::CommonOrbifold && (count < 3 || count > 4))
  {
    throw InvalidInput(fact +
      " has as many cones as landmarks; give 3 or 4, or none to have them found, or take "
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
    RequireComponents(topology, name, !landmarks.empty(), options);
    RequireSphereLike(topology, name, options.Method);
    areClosed = areClosed && topology.BoundaryLoops == 0;
  }
  if (areClosed && SideOf(a) * SideOf(b) < 0)
  {
    throw InvalidInput(std::string(SideOf(a) < 0 ? "SurfaceA faces inwards and SurfaceB"
                                                 : "SurfaceB faces inwards and SurfaceA") +
      " outwards, so that left would go to right; turn the former over with Reverse Sense");
  }
  RequireLandmarks(landmarks, a, b);
  if (!landmarks.empty())
  {
    RequireEnoughLandmarks(landmarks, options.Method);
  }
}

} // namespace shape
