#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// The ways in which triangles can fail to bound a solid.
enum class DefectKind
{
  NotFinite,          ///< a point with a coordinate that is not finite
  LoosePoint,         ///< a point that no triangle uses
  DuplicatePoint,     ///< a point within the tolerance of an earlier one
  DegenerateTriangle, ///< a triangle with collinear or coincident corners
  DuplicateTriangle,  ///< a triangle on the same three points as an earlier one
  NonManifoldEdge,    ///< an edge with three or more triangles
  NonManifoldPoint,   ///< a point where fans of triangles touch
  MisorientedEdge,    ///< an edge with the same direction in both triangles
  InvertedPiece,      ///< a closed piece that faces the wrong way
  OpenLoop,           ///< a connected chain of edges with one triangle
  SelfIntersection,   ///< two triangles that intersect beyond their common corners and edge
  SmallPiece          ///< a piece smaller than SmallestPiece
};
constexpr int NumberOfDefectKinds = 12;

struct SurfaceDefect
{
  DefectKind Kind;
  /// A point of the defect. It is the middle of an edge, triangle or intersection. For a piece or
  /// an open loop, it is its first point. For NotFinite, it has the coordinate 0 in place of the
  /// one that is not finite.
  Eigen::RowVector3d Position;
};

struct SurfaceDefectOptions
{
  /// Points closer than this are the same point; in the model's units, >= 0. 0 means the fraction
  /// WeldTolerance of the diagonal of the bounding box, which only joins points that differ by
  /// rounding.
  double Tolerance = 0.0;
  /// Pieces whose bounding box has no edge as long as this are defects; in the model's units, >= 0.
  double SmallestPiece = 0.0;
};

struct SurfaceDefects
{
  std::vector<SurfaceDefect> Defects; ///< sorted by kind
  std::array<int, NumberOfDefectKinds> Counts{};
  int Pieces = 0;      ///< number of connected components
  int EulerNumber = 0; ///< points - edges + triangles

  int Count(DefectKind kind) const { return this->Counts[static_cast<std::size_t>(kind)]; }
};

/**
 * Finds everything that keeps triangles from bounding a solid. If nothing is found, the surface is
 * closed, a manifold, oriented outwards, and does not intersect itself. A piece inside another one
 * is a void, and must face inwards (OrientByNesting).
 *
 * Topology is that of the surface whose duplicate points are joined, without duplicate triangles
 * and without triangles that use a point twice. Degenerate triangles are not tested for
 * intersections. At most 1,000,000 intersections are found. If pieces intersect, a piece is
 * inverted if the volume that it encloses is negative.
 *
 * surface: any triangles. Throws InvalidInput if an option is out of range, if an index is out of
 * range, or under the conditions of RequireExtent; Aborted.
 */
SurfaceDefects FindSurfaceDefects(
  const Mesh& surface, const SurfaceDefectOptions& options = {}, const Progress& progress = {});

} // namespace shape
