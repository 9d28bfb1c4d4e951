#pragma once

#include "Base/Progress.h"
#include "Harmonic/CertificateTypes.h"
#include "Harmonic/ChargeSet.h"
#include "Harmonic/PiecewiseHarmonicMap.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A repair and the shares of the solid's volume that RepairMapResult describes.
struct RepairShares
{
  MapRepair Repair;
  double InvertedShare = 0.0, CoreShare = 0.0, RingShare = 0.0;
};

/// The tetrahedra of a solid, and which of them are the core.
class RepairCore
{
public:
  RepairCore(const ChargeSet& map, FiniteElements elements, const Progress& progress);

  /// Adds the tetrahedra that meet a box that is not certified.
  void AddFolds(const MapCertificate& certificate, const Progress& progress);
  /// Adds layers of the tetrahedra that share a point with the core.
  void Grow(int layers);
  bool IsEmpty() const { return this->CoreTetrahedra.empty(); }
  bool IsWhole() const { return this->CoreTetrahedra.size() == this->InCore.size(); }

  /// Grows until the ring is certified, and the image of the core's boundary does not cross itself
  /// where it has points with images by f.
  void GrowUntilBounded(const Progress& progress);
  /// Whether that image crosses itself elsewhere. Then no inner points make all tetrahedra
  /// positive.
  bool Crosses() const { return this->HasCrossing; }
  /// Untangles the core, and returns whether none of its tetrahedra stays inverted.
  bool UntangleCore(const Progress& progress);

  RepairShares Finish() const;

private:
  std::vector<int> TestRing(const Progress& progress);
  std::vector<int> FindCrossings();
  void Close();
  std::vector<char> FindPrescribed() const;
  MapRepair WholeRepair() const;
  double VolumeOf(const std::vector<int>& tetrahedra) const;

  const ChargeSet& Map;
  FiniteElements Elements;     ///< of the whole solid; Images: prescribed at its boundary
  Eigen::MatrixXd Values;      ///< f at the points
  std::vector<char> InCore;    ///< for each tetrahedron
  std::vector<char> AtCore;    ///< for each point: whether it belongs to the core
  std::vector<char> AtSurface; ///< for each point
  /// For each tetrahedron, its corners in the core as bits, when it was certified in the ring; or
  /// 0. Nothing else changes.
  std::vector<char> Certified;
  std::vector<int> CoreTetrahedra, RingTetrahedra;
  bool HasCrossing = false;
  /// The core as Untangle made it.
  FiniteElements Core;
  std::vector<int> CorePoints; ///< of Elements; these are the first points of Core
};

} // namespace shape
