#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"
#include "Remesh/Coarsening.h"

#include <optional>
#include <vector>

namespace shape
{

/// Two surfaces, each coarsened if it has more points than a method needs. Eigenvalues, distances
/// and iterations take a fraction of the time on the coarse surfaces. The maps are then transferred
/// to the fine surfaces.
class CoarsePair
{
public:
  /// A surface, and its coarse copy if it is large.
  struct Side
  {
    Surface Fine;
    std::optional<CoarseSurface> Coarse;

    const Surface& Working() const { return this->Coarse ? this->Coarse->Surface : this->Fine; }
    int FinePoint(int point) const { return this->Coarse ? this->Coarse->Points[point] : point; }
    int CoarsePoint(int point) const; ///< of a point that was kept
    Eigen::MatrixXd Interpolate(const Eigen::MatrixXd& values) const;
  };

  /// Coarsens a surface that has more than `maximum` points; see the constructor. kept: points that
  /// are kept.
  static Side Coarsen(const Surface& surface, const std::vector<int>& kept, int maximum,
    const Progress& progress = {});

  /// From surfaces that were coarsened before.
  CoarsePair(Side a, Side b);

  /// a, b: surfaces that CoarsenSurface accepts. landmarks: pairs whose points are kept. maximum:
  /// the approximate number of points of a coarse surface; if 0, no surface is coarsened. Throws
  /// InvalidInput, Aborted.
  CoarsePair(const Surface& a, const Surface& b, const Landmarks& landmarks, int maximum,
    const Progress& progress = {});

  const Surface& A() const { return this->One.Working(); }
  const Surface& B() const { return this->Two.Working(); }
  const Surface& FineA() const { return this->One.Fine; }
  const Surface& FineB() const { return this->Two.Fine; }
  bool IsCoarser() const { return this->One.Coarse || this->Two.Coarse; }

  int FinePointOfA(int point) const { return this->One.FinePoint(point); }
  int FinePointOfB(int point) const { return this->Two.FinePoint(point); }

  /// Converts landmarks of the fine surfaces to the coarse ones. Each point must belong to a
  /// landmark that was given to the constructor.
  Landmarks OnCoarse(const Landmarks& landmarks) const;
  /// Converts landmarks of the coarse surfaces to the fine ones.
  Landmarks OnFine(const Landmarks& landmarks) const;

  /// Transfers maps of the coarse surfaces to the fine ones. Let x be the position of a fine point
  /// in a triangle of its coarse surface. The images of the triangle's corners are averaged with
  /// the barycentric coordinates of x. The image of the fine point is the position nearest to this
  /// mean, found by a walk from the image of the corner nearest to x.
  SurfaceMaps OnFine(const SurfaceMaps& maps, const Progress& progress = {}) const;

  ///@{
  /// Interpolates values at the points of a coarse surface (n x d) at those of the fine one.
  Eigen::MatrixXd ValuesOnFineA(const Eigen::MatrixXd& values) const;
  Eigen::MatrixXd ValuesOnFineB(const Eigen::MatrixXd& values) const;
  ///@}

private:
  static SurfacePoints Lifted(
    const SurfacePoints& map, const Side& from, const Side& to, const Progress& progress);

  Side One, Two;
};

} // namespace shape
