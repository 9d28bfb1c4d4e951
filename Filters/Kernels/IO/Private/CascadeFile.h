#pragma once

#include "IO/Private/CADFormat.h"

#include <NCollection_DataMap.hxx>
#include <TopTools_ShapeMapHasher.hxx>
#include <TopoDS_Shape.hxx>

#include <string>
#include <string_view>

namespace shape
{

/// Names by what a shape is, wherever it is placed: keys have no location.
using ShapeNames = NCollection_DataMap<TopoDS_Shape, std::string, TopTools_ShapeMapHasher>;

/// The shapes of a CAD file.
struct CascadeFile
{
  TopoDS_Shape Shape;
  ShapeNames Names; ///< of faces and solids
  std::string Unit; ///< see CADModel
};

/// Reads the content of a file. Throws InvalidInput if OpenCASCADE cannot read it, with its first
/// alarm, and SolveFailure if there is no memory.
CascadeFile ReadCascadeFile(std::string_view content, CADFormat format);

} // namespace shape
