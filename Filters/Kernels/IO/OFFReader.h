#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"

#include <Eigen/Core>

#include <cstdint>
#include <string_view>
#include <vector>

namespace shape
{

/// A surface in the Object File Format.
struct OFFSurface
{
  /// The faces. The kind is cell_kind::Vertex for one point, Line for two points, and PolygonKind
  /// for more.
  Cells Faces;
  static constexpr int PolygonKind = 7; ///< VTK's polygon

  /// Colours from 0 to 255, `Components` (3: RGB, 4: RGBA) for each point or face. Components is 0
  /// if the file has none.
  struct Colors
  {
    int Components = 0;
    std::vector<std::uint8_t> Values;
  };
  Colors PointColors, FaceColors;
  /// Indices of face colours in a colour map, or empty; -1 for faces without an index.
  std::vector<int> FaceColorIndices;
  Eigen::MatrixXd Normals;            ///< n x 3, or empty
  Eigen::MatrixXd TextureCoordinates; ///< n x 2, or empty
};

/**
 * Reads a surface from the content of an OFF file, in text or binary form (Phillips et al. 2007,
 * "Geomview Manual", section "OFF Files").
 *
 * The keyword OFF may have the prefixes ST (texture coordinates), C (colours) and N (normals), and
 * may be missing. In text, each vertex and each face is on a line of its own, and may be followed
 * by a colour, with or without the prefix C. If a number of the colour is above 1, its numbers are
 * from 0 to 255, otherwise from 0 to 1. Faces without a colour among coloured faces are grey (170).
 * If some colours have an alpha value, the other colours are opaque. Binary numbers have 32 bits,
 * most significant byte first.
 *
 * Throws InvalidInput, with the line or the index of the face, if the file has another keyword or
 * ends early, has no vertices, or if a number, count or index is wrong. Throws Aborted.
 */
OFFSurface ReadOFF(std::string_view content, const Progress& progress = {});

} // namespace shape
