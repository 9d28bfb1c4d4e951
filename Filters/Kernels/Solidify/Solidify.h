#pragma once

#include "Base/Progress.h"
#include "Distance/HausdorffDistance.h"
#include "Mesh/Mesh.h"
#include "Solidify/MendSurface.h"
#include "Solidify/SurfaceDefects.h"

namespace shape
{

/// How much is done to a surface.
enum class SolidifyMethod
{
  Automatic, ///< nothing if the surface bounds a solid, else the first of Mend, Solid and Wrap
             ///< that succeeds
  Report,    ///< defects are found, and the surface stays as it is
  Mend,      ///< see MendSurface
  Solid,     ///< see MakeSolid
  Wrap       ///< see WrapSurface
};

struct SolidifyOptions
{
  SolidifyMethod Method = SolidifyMethod::Automatic;
  SurfaceDefectOptions Defects; ///< the tolerances of every method
  double DetailSize = 0.0;      ///< see SolidSurfaceOptions and WrapSurfaceOptions
  double GapSize = 0.0;         ///< see WrapSurfaceOptions
  double SheetThickness = 0.0;  ///< see WrapSurfaceOptions
};

struct SolidifyResult
{
  SolidifyMethod Method = SolidifyMethod::Report; ///< never Automatic
  SurfaceDefects Defects;                         ///< of the input
  /// The surface; the input itself, with the origin Kept, if it has no defects or with Report.
  MendedSurface Mended;
  int Pieces = 0;      ///< number of connected components of the result
  int EulerNumber = 0; ///< of the result
  /// First: the input's triangles with an area. Second: the result. 0 if nothing was changed.
  HausdorffDistances Distances;
};

/// Turns triangles into the boundary of a solid. An input without defects (FindSurfaceDefects) is
/// returned bit for bit, except with Wrap. Throws the exceptions of FindSurfaceDefects and of the
/// method; with Automatic, those of Wrap.
SolidifyResult Solidify(
  const Mesh& surface, const SolidifyOptions& options = {}, const Progress& progress = {});

} // namespace shape
