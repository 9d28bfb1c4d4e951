#pragma once

#include "Base/Progress.h"
#include "Harmonic/CertificateTypes.h"
#include "Harmonic/ChargeSet.h"
#include "Harmonic/PiecewiseHarmonicMap.h"
#include "Harmonic/Private/CorePart.h"

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
  /// Adds the tetrahedra that share a point with the core.
  void AddLayer();
  bool IsEmpty() const { return this->CoreTetrahedra.empty(); }

  /// Grows until the ring is certified, and the image of the core's boundary does not cross itself
  /// where it has points with images by f.
  void GrowUntilBounded(const Progress& progress);
  /// Untangles the parts of the core that are new, and returns whether no part has inverted
  /// tetrahedra left.
  bool UntangleParts(const Progress& progress);
  /// Adds layers around the parts that stay inverted. A part does not grow if the image of its
  /// boundary crosses itself, as no larger part can be untangled, either. Returns false if there
  /// are no others, or too little work is left.
  bool GrowInverted(int layers);

  RepairShares Finish() const;

private:
  std::vector<int> TestRing(const Progress& progress);
  std::vector<int> FindCrossings(const Progress& progress);
  void FindParts();
  void GrowAround(std::vector<char> marked, int layers);
  void Close();
  std::vector<char> FindPrescribed() const;
  MapRepair WholeRepair() const;
  double VolumeOf(const std::vector<int>& tetrahedra) const;

  /// Of all Newton steps (UntangleOptions). A part may take half of what is left. Parts grow only
  /// while more than LeastWork is left.
  static constexpr double MaximumWork = 1.6e8, LeastWork = 0.25 * MaximumWork;

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
  std::vector<CorePart> Parts;   ///< of the core
  std::vector<int> PartOf;       ///< for each point: its part, or -1
  double WorkLeft = MaximumWork; ///< for further untangling
};

} // namespace shape
