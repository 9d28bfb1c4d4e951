#pragma once

#include "Distance/SignedDistance.h"
#include "Harmonic/ChargeSet.h"
#include "Harmonic/FiniteElementMap.h"

#include <memory>
#include <vector>

namespace shape
{

/**
 * A part of a solid in which a map f is replaced (RepairMap). In each tetrahedron,
 *
 *   g = h + phi (f - h)
 *
 * with h and phi linear. phi is 0 in the core, where g is linear, and rises to 1 in a ring around
 * it. It is 1 at the faces where the repair borders on the rest of the solid, so g is continuous.
 */
struct MapRepair
{
  FiniteElements Elements; ///< the tetrahedra, and h as Images; none: f is replaced nowhere
  Eigen::VectorXd Shares;  ///< one for each point of Elements: phi, the share of f, 0 to 1
};

/// The data of a volume map: one harmonic map for each region of a solid, and the surfaces that
/// bound the solid and its regions.
struct PiecewiseCharges
{
  static constexpr int Void = -1; ///< the region number of empty space

  std::vector<ChargeSet> Maps = std::vector<ChargeSet>(1); ///< one for each region; at least 1
  /// closed surfaces around the solid, its voids and its inner regions, facing either way
  shape::Surface Surface;
  /// m values: for each triangle, the region that its component encloses. It is 0 for the component
  /// around the solid, and Void for the wall of a void. May be empty if there is one region.
  Eigen::VectorXi Regions;
  double Farthest = 0.0; ///< maximum distance outside the solid at which the map is valid
  SumDevice Device;      ///< where Evaluate and Jacobians sum over charges
  /// For each region, the thickness (>= 0) of the skin inside its border. In the skin the map of
  /// the surrounding region blends into the region's map. Empty: all are 0.
  Eigen::VectorXd Skins;
  MapRepair Repair = {}; ///< may have tetrahedra if there is one region
};

/// Returns the maximum distance outside its domain at which a map is valid
/// (PiecewiseCharges::Farthest). This is half the distance of the map's charges from the boundary.
/// The charges' distance is `offsetDistance` times the longest side of the bounding box of the
/// boundary's `points` (n x 3).
double ComputeFarthest(double offsetDistance, const Eigen::MatrixXd& points);

/**
 * A volume map with one harmonic map in each region:
 *
 *   f(y) = (1 - s(d / t)) f_r(y) + s(d / t) f_p(y)
 *
 * Here r is the region of y, p the region around it, d the distance to the border between them, and
 * t the skin of r. The share s(u) is (1 - u)^2 (1 + 2 u) for u < 1, else 0. Outside the skin, f
 * therefore equals f_r. f and its first derivative are continuous across borders, even if the two
 * fitted maps differ there.
 *
 * With a repair, the map is that of MapRepair in the tetrahedra and within 1e-6 of their longest
 * side around them. There, a point outside the solid takes h and phi from the closest position.
 *
 * Region r > 0 is the space inside the components with number r, except the regions inside it. A
 * position on a border belongs to the outer region.
 */
class PiecewiseHarmonicMap
{
public:
  /// Throws InvalidInput if a surface is not closed, components touch or cross, array sizes do not
  /// agree, or there are several regions and a repair; Aborted.
  explicit PiecewiseHarmonicMap(const PiecewiseCharges& charges, const Progress& progress = {});

  int RegionCount() const { return static_cast<int>(this->Maps.size()); }
  const ChargeSet& Map(int region) const { return this->Maps[region]; }
  double Farthest() const { return this->FarthestOutside; }

  /// The surface of the solid and its voids, facing out of the solid.
  const SignedDistance& Domain() const { return *this->Solid; }
  /// Returns one mesh of all surfaces that bound `region`.
  Mesh BoundaryOf(int region) const;

  /// Returns the region of each of `points` (n x 3, finite), 0 for points outside the solid.
  Eigen::VectorXi RegionsAt(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// Returns f at the points: n x 3. Throws InvalidInput if there is no such device, and Aborted.
  Eigen::MatrixXd Evaluate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// Returns the derivative of f at the points: n x 9, with the columns in the order of
  /// EvaluateJacobians. Throws Aborted.
  Eigen::MatrixXd Jacobians(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// The regions of points, and how the maps are blended there.
  struct Positions
  {
    Eigen::VectorXi Regions; ///< n
    Eigen::VectorXd Shares;  ///< n: s(d / t), the share of the surrounding region's map
    Eigen::MatrixXd Slopes;  ///< n x 3: the gradient of the share
  };
  Positions Locate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  bool HasRepair() const { return this->Repair != nullptr; }

  /// The repair at n points.
  struct RepairPositions
  {
    Eigen::VectorXi Cells;     ///< n: the tetrahedron of each point; -1 outside the repair
    Eigen::MatrixXd Values;    ///< n x 4: h and phi; outside the repair 0 and 1
    Eigen::MatrixXd Gradients; ///< n x 12: of these, in the order of EvaluateJacobians
  };
  /// Needs a repair. Throws Aborted.
  RepairPositions LocateInRepair(
    const Eigen::MatrixXd& points, const Progress& progress = {}) const;
  /// The repair, with the shares as fourth coordinate of the images. Needs a repair.
  const FiniteElements& RepairElements() const { return this->Repair->Elements(); }

  /// Returns the region that surrounds `region`, which must be > 0.
  int Parent(int region) const { return this->Parents[region]; }

private:
  void FindParents();
  struct RepairedValues;
  RepairedValues LocateRepaired(const Eigen::MatrixXd& points, const Progress& progress) const;
  Eigen::MatrixXd EvaluateRepaired(const Eigen::MatrixXd& points, const Progress& progress) const;
  Eigen::MatrixXd RepairedJacobians(const Eigen::MatrixXd& points, const Progress& progress) const;
  Eigen::MatrixXd EvaluateRegion(
    int region, const Eigen::MatrixXd& points, const Progress& progress) const;

  std::vector<ChargeSet> Maps;
  Eigen::VectorXd Skins;
  SumDevice Device;
  double FarthestOutside;
  std::unique_ptr<SignedDistance> Solid;
  std::vector<std::unique_ptr<SignedDistance>> Borders; ///< one for each region; null for region 0
  std::vector<int> Parents;                             ///< one for each region
  std::vector<int> Order;                         ///< regions > 0, outer ones before inner ones
  std::unique_ptr<const FiniteElementMap> Repair; ///< of h and phi; null without a repair
  double RepairTolerance = 0.0;
  std::vector<Mesh> Walls; ///< one for each region: the walls of the voids in it
};

} // namespace shape
