#pragma once

#include "Mesh/Mesh.h"

#include <array>
#include <vector>

namespace shape
{

/// An edge between two triangles.
struct Hinge
{
  int Low, High;
  std::array<int, 2> Triangles;
  double Length;
  bool Sharp;
  double Angle;          ///< interior dihedral angle, in degrees
  bool IsCrease = Sharp; ///< sharp, or on the extension of a crease
};

/// Extends each crease that fades out to another crease, along the shortest path over edges that
/// are less sharp. Without such a path, or if the path would meet that crease at a small angle, the
/// crease ends where it fades out. angle: of sharp edges, in degrees.
void ExtendFadingCreases(const Mesh& mesh, double angle, std::vector<Hinge>& hinges);

} // namespace shape
