#pragma once

#include "IO/CADModel.h"
#include "IO/Private/CADFormat.h"

#include <Eigen/Core>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace shape
{

/// An edge of a triangulated CAD face. Numbers are the same in all faces that have it.
struct CascadeEdge
{
  int Number;                             ///< from 1
  int FirstVertex, LastVertex;            ///< numbers, from 1
  bool IsPoint;                           ///< it has no length, as at the apex of a cone
  bool IsSeam;                            ///< both sides are the same face, as on a cylinder
  std::vector<int> Nodes;                 ///< of the face, along the edge
  std::vector<Eigen::Vector3d> Positions; ///< of these nodes, on the exact curve
};

/// A triangulated CAD face. It has no triangles if the triangulation failed.
struct CascadeFace
{
  int Region; ///< from 0
  int Patch;  ///< from 1; the same in two regions that have it in common
  std::vector<Eigen::Vector3d> Nodes;
  std::vector<std::array<int, 3>> Triangles; ///< nodes, counter-clockwise seen from outside
  std::vector<CascadeEdge> Edges;            ///< a seam occurs twice
};

/// What OpenCASCADE makes of a file. See CADModel for the last members.
struct CascadeModel
{
  std::vector<CascadeFace> Faces;
  std::vector<std::string> PatchNames, RegionNames;
  std::string Unit;
  double Deflection = 0.0, Distance = 0.0;
};

/// Reads and triangulates a file in this process, which must expect a crash, and changes its
/// numeric locale. Throws the exceptions of ReadCAD, if faces have no triangles excepted.
using CascadeReader = CascadeModel (*)(std::string_view, CADFormat, const CADReaderOptions&);

/// Loads OpenCASCADE, unless an earlier call did. Throws InvalidInput if ShapeMap was built without
/// it, and SolveFailure if its libraries are missing.
CascadeReader LoadOpenCascade();

} // namespace shape

/// The CascadeReader of libshape_cascade.so, which LoadOpenCascade looks up by its name.
extern "C" [[gnu::visibility("default")]] shape::CascadeModel ShapeMapReadCascade(
  std::string_view content, shape::CADFormat format, const shape::CADReaderOptions& options);
