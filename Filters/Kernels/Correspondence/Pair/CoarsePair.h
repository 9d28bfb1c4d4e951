#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Mesh.h"
#include "Remesh/Coarsening.h"

#include <optional>

namespace shape
{

/// Two surfaces, coarsened where they have more points than methods need to match them:
/// eigenvalues, distances and iterations are found there in a fraction of the time, and the maps
/// are carried to the fine surfaces.
class CoarsePair
{
public:
  /// a, b: as CoarsenSurface takes them; both are kept by reference. landmarks: points of both,
  /// which stay. most: points of the coarse surfaces, about; 0: as they are. Throws InvalidInput,
  /// Aborted.
  CoarsePair(const Mesh& a, const Mesh& b, const Landmarks& landmarks, int maximum,
    const Progress& progress = {});

  const Mesh& A() const { return this->One.Surface(); }
  const Mesh& B() const { return this->Two.Surface(); }
  const Mesh& FineA() const { return this->One.Fine; }
  const Mesh& FineB() const { return this->Two.Fine; }
  bool IsCoarser() const { return this->One.Coarse || this->Two.Coarse; }

  int FinePointOfA(int point) const { return this->One.FinePoint(point); }
  int FinePointOfB(int point) const { return this->Two.FinePoint(point); }

  /// Landmarks of the fine surfaces, as they are on the coarse ones: those given at the start.
  Landmarks OnCoarse(const Landmarks& landmarks) const;
  Landmarks OnFine(const Landmarks& landmarks) const;

  /// Maps of the coarse surfaces on the fine ones. The image of a fine point is the place nearest
  /// to the mean of where the corners of its place on the coarse surface go, walking from there.
  SurfaceMaps OnFine(const SurfaceMaps& maps, const Progress& progress = {}) const;

private:
  struct Side
  {
    const Mesh& Fine;
    std::optional<CoarseSurface> Coarse;
    const Mesh& Surface() const { return this->Coarse ? this->Coarse->Surface : this->Fine; }
    int FinePoint(int point) const { return this->Coarse ? this->Coarse->Points[point] : point; }
    int CoarsePoint(int point) const;
  };

  static SurfacePoints Lifted(
    const SurfacePoints& map, const Side& from, const Side& to, const Progress& progress);

  Side One, Two;
};

} // namespace shape
