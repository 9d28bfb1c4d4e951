#pragma once

#include "Core/Mesh.h"
#include "Core/Progress.h"
#include "Surface/DiskMap.h"

#include <string>

namespace shape
{

struct ParameterizeOptions
{
  /// What the surface is mapped onto.
  enum class DomainType
  {
    Disk = 0,  ///< of a surface with one open loop: shape::DiskMap
    Sphere = 1 ///< of a closed surface of genus 0, the unit sphere: shape::SphereMap
  };
  DomainType Domain = DomainType::Sphere;
  /// Disk: by which weights a point is the mean of its neighbours.
  CombinationWeights Weights = DiskMapOptions().Weights;
  /// Disk: what the open loop becomes.
  DiskOutline Outline = DiskMapOptions().Outline;
  /// Sphere: equal areas against equal angles: 0 = angles alone (a limb shrinks exponentially with
  /// its length over its girth), larger = areas count more; >= 0.
  double AreaWeight = 0.0;
};

struct ParameterizeResult
{
  Eigen::MatrixXd Positions;        ///< n x 3: where each point goes
  std::string Method;               ///< what gave every point its place, in one word
  int Iterations = 0;               ///< of that method; 0 where it solves one linear system
  int ReinsertedPoints = 0;         ///< points that needed a second method
  int FlippedTriangles = 0;         ///< of the image: 0, else it throws
  double LoopLength = 0.0;          ///< Disk: of the open loop, in the surface's units
  double ConformalDistortion = 1.0; ///< mean over the surface's area; 1 keeps every angle
};

/**
 * Maps a surface onto a simple domain without flipping a triangle. The image of a closed surface
 * that faces inwards faces inwards, too: the map mirrors nothing.
 *
 * Throws InvalidInput where the surface is not of the kind that the domain needs, SolveFailure
 * where a triangle would be flipped, Aborted.
 */
ParameterizeResult Parameterize(
  const Mesh& surface, const ParameterizeOptions& options = {}, const Progress& progress = {});

} // namespace shape
