#pragma once

#include "Core/Mesh.h"
#include "Core/Progress.h"

#include <string>

namespace shape
{

struct ParameterizeOptions
{
  /// What the surface is mapped onto.
  enum class DomainType
  {
    Sphere = 1 ///< the unit sphere: shape::SphereMap
  };
  DomainType Domain = DomainType::Sphere;
  /// Equal areas against equal angles: 0 = angles alone (a limb shrinks exponentially with its
  /// length over its girth), larger = areas count more; >= 0.
  double AreaWeight = 0.0;
};

struct ParameterizeResult
{
  Eigen::MatrixXd Positions;        ///< n x 3: where each point goes
  std::string Method;               ///< what gave every point its place, in one word
  int Iterations = 0;               ///< of that method
  int ReinsertedPoints = 0;         ///< points that needed a second method
  double ConformalDistortion = 1.0; ///< mean over the surface's area; 1 keeps every angle
};

/**
 * Maps a surface onto a simple domain without flipping a triangle.
 *
 * Throws InvalidInput where the surface is not of the kind that the domain needs, SolveFailure
 * where a triangle would be flipped, Aborted.
 */
ParameterizeResult Parameterize(
  const Mesh& surface, const ParameterizeOptions& options = {}, const Progress& progress = {});

} // namespace shape
