#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

struct CADReaderOptions
{
  /// distance between the triangles and the exact surface, which the triangulation aims at, in the
  /// unit of the file; 0: 0.001 of the diagonal of the bounding box
  double Deflection = 0.0;
  double Angle = 20.0; ///< degrees, 1 to 90: between neighbouring segments of a curve
  /// faces that belong to no solid are joined along edges closer than this, in the unit of the
  /// file; 0: 1e-5 of the diagonal, or the tolerance of the file if that is larger
  double SewingTolerance = 0.0;
};

/// A polyline on an edge between CAD faces.
struct CADEdge
{
  std::vector<int> Points; ///< indices; the first is repeated at the end of a closed curve
  int Number;              ///< from 1: the edge of the file
};

/// The triangulated faces of a CAD file.
struct CADModel
{
  Mesh Surface;            ///< regions have no common points
  Eigen::VectorXi Patches; ///< m: the CAD face of each triangle, from 1
  /// m: from 0: solids in the order of the file, then connected sheets of faces without a solid
  Eigen::VectorXi Regions;
  std::vector<CADEdge> Edges;           ///< without the seams of closed faces, such as cylinders
  std::vector<std::string> PatchNames;  ///< name of each face in the file, or ""
  std::vector<std::string> RegionNames; ///< name of each region in the file, or ""
  std::string Unit;                     ///< "mm", "in", ...; "" if the file has no unit
  double Deflection = 0.0;              ///< the one that was used
  /// largest distance of the exact surface from the triangles' planes, at the centres of triangles
  /// and edges
  double Distance = 0.0;
  int OpenEdges = 0; ///< edges of only one triangle
};

} // namespace shape
