#pragma once

#include "Distance/SignedDistance.h"
#include "Harmonic/ChargeSet.h"

#include <memory>
#include <vector>

namespace shape
{

/// A volume map as data: a harmonic map for each region of a solid, and the surfaces that bound the
/// solid and its regions.
struct PiecewiseCharges
{
  static constexpr int Void = -1; ///< the region of what is not solid

  std::vector<ChargeSet> Maps = std::vector<ChargeSet>(1); ///< by region; at least 1
  shape::Surface Surface; ///< closed, facing any way: around the solid, voids and inner regions
  /// m: the region that the component of each triangle encloses, 0 for the one around the solid,
  /// Void for the wall of a void; empty where there is one region.
  Eigen::VectorXi Regions;
  double Farthest = 0.0; ///< how far outside the solid the map holds: see FindPointsOutsideDomain
  /// By region, >= 0: in how thick a skin inside the border around it the map of the region that is
  /// around passes into its own; empty = 0.
  Eigen::VectorXd Skins;
};

/// How far outside its domain a map holds (PiecewiseCharges::Farthest): half the distance of its
/// charges, which is `offsetDistance` times the longest side of the boundary's `points` (n x 3).
double ComputeFarthest(double offsetDistance, const Eigen::MatrixXd& points);

/**
 * The volume map that is harmonic in each region by itself:
 *
 *   f(y) = (1 - s(d / t)) f_r(y) + s(d / t) f_p(y)
 *
 * with r the region of y, p the region around it, d the distance to the border between, t the skin
 * of r and s(u) = (1 - u)^2 (1 + 2 u) below 1, else 0. So f is f_r but for the skin, and is
 * continuous across borders, with its first derivative, however well two fitted maps agree there.
 *
 * A region r > 0 is what the components with r enclose, without the regions inside them. A position
 * on a border belongs to the region around it.
 */
class PiecewiseHarmonicMap
{
public:
  /// Throws InvalidInput if a surface is not closed, components touch or cross, or sizes do not
  /// agree; Aborted.
  explicit PiecewiseHarmonicMap(const PiecewiseCharges& charges, const Progress& progress = {});

  int RegionCount() const { return static_cast<int>(this->Maps.size()); }
  const ChargeSet& Map(int region) const { return this->Maps[region]; }
  double Farthest() const { return this->FarthestOutside; }

  /// The surface of the solid and of its voids, facing outwards.
  const SignedDistance& Domain() const { return *this->Solid; }
  /// All surfaces that bound a region.
  Mesh BoundaryOf(int region) const;

  /// The region of each of `points` (n x 3, finite), whether it lies in the solid or not.
  Eigen::VectorXi RegionsAt(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// f at the points: n x 3. Throws Aborted.
  Eigen::MatrixXd Evaluate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// The derivative of f there: n x 9, as shape::Jacobians has it. Throws Aborted.
  Eigen::MatrixXd Jacobians(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// Where in the regions the points lie.
  struct Positions
  {
    Eigen::VectorXi Regions; ///< n
    Eigen::VectorXd Shares;  ///< n: s(d / t), of the map of the region around
    Eigen::MatrixXd Slopes;  ///< n x 3: its gradient
  };
  Positions Locate(const Eigen::MatrixXd& points, const Progress& progress = {}) const;

  /// The region around a region > 0.
  int Parent(int region) const { return this->Parents[region]; }

private:
  void FindParents();

  std::vector<ChargeSet> Maps;
  Eigen::VectorXd Skins;
  double FarthestOutside;
  std::unique_ptr<SignedDistance> Solid;
  std::vector<std::unique_ptr<SignedDistance>> Borders; ///< by region; none around 0
  std::vector<int> Parents;                             ///< by region
  std::vector<int> Order;                               ///< regions > 0, those around first
  std::vector<Mesh> Walls;                              ///< by region: of the voids in it
};

} // namespace shape
