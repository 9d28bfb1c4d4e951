#pragma once

#include "Base/Progress.h"
#include "Correspondence/CommonBase/Private/ConeSurface.h"
#include "Distortion/Distortion.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace shape
{

/**
 * Moves the points of two surfaces on the flat surface with cones that both cover, so that the
 * distortion of the map between them falls in both directions, after Smith and Schaefer, "Bijective
 * parameterization with free boundaries", 2015. The energy of a direction is the mean of a measure
 * over the triangles of one surface, for the plane triangles between the images of their corners on
 * the other one. The energies of both directions are added, so neither surface is preferred. Both
 * surfaces are scaled to the area 1.
 *
 * A point changes the images of its own triangles, and those of the other surface's points in these
 * triangles. It moves to the minimum of a quadratic form with the energy's gradient, whose weights
 * are those of Rabinovich and others ("Scalable locally injective mappings", 2017), while the
 * energy falls and no triangle around it is flipped (exact predicates). So the map
 * remains one to one. Points of paths move like all others, and cones stay. Points of curves move
 * along their curve, which is one straight line on the flat surface for both surfaces. Points that
 * divided edges are removed where that turns no triangle over either.
 */
class MapRelaxation
{
public:
  /// One of the two surfaces.
  struct Side
  {
    const PatchedSurface& Patched;
    ConeSurface& Flat;
    std::vector<ConePlace> Places; ///< of each point that is no cone, on the other surface
  };

  /// What is lowered.
  struct Goal
  {
    Distortion Measure = Distortion::SymmetricDirichlet;
    double Exponent = 1.0; ///< of an exponential measure
  };

  MapRelaxation(Side a, Side b);

  void Run(const Goal& goal, const Progress& progress);

  /// Returns the mean of a measure over a surface, 0 for A and 1 for B.
  double Energy(int side, const Goal& goal) const;
  const std::vector<ConePlace>& Places(int side) const { return this->Sides[side].Places; }

private:
  struct Relaxed : Side
  {
    std::vector<std::vector<int>> Held; ///< for each triangle, the other's points in it
    std::vector<int> Next;              ///< for each point of a curve that is no cone, the next one
    Eigen::MatrixXd Points;             ///< in space, scaled
    Eigen::MatrixXd Images;             ///< of the points on the other surface, scaled
    std::vector<Eigen::Matrix2d> Shapes; ///< for each triangle, the inverse of its edges' columns
    std::vector<double> Areas;           ///< of the triangles; 0 if removed
  };
  /// A sum of energies: triangles whose image has no size, or whose energy overflows, come first.
  struct Total
  {
    int Infinite = 0;
    double Sum = 0.0;
    bool operator<(const Total& other) const
    {
      return this->Infinite != other.Infinite ? this->Infinite < other.Infinite
                                              : this->Sum < other.Sum;
    }
  };
  /// The derivative of the energy by the image of a point, and the matrix of the quadratic form.
  struct Terms
  {
    Eigen::Vector3d Slope = Eigen::Vector3d::Zero();
    Eigen::Matrix3d Curvature = Eigen::Matrix3d::Zero();
  };
  /// A point of the other surface in the triangles around a moved point.
  struct HeldPoint
  {
    int Point;
    int Corner;                ///< of the moved point, in the triangle that holds this one
    Eigen::RowVector2d Across; ///< its position in the coordinates of the moved point
    ConePlace Place;           ///< before the move
    Eigen::RowVector3d Image;  ///< before the move
  };
  /// All that changes where a point moves.
  struct Star
  {
    std::vector<int> Corners; ///< of the point
    std::vector<HeldPoint> Held;
    std::vector<int> Others; ///< the triangles of the other surface around the held points
  };

  Relaxed& OtherOf(const Relaxed& side) { return this->Sides[&side == this->Sides.data() ? 1 : 0]; }
  const Relaxed& OtherOf(const Relaxed& side) const
  {
    return this->Sides[&side == this->Sides.data() ? 1 : 0];
  }
  void UpdateShapes(Relaxed& side);
  void UpdateImages(Relaxed& side);
  void UpdateHeld();
  void RemoveSplits(Relaxed& side);
  Eigen::RowVector3d ImageAt(const Relaxed& side, int point) const;
  /// Adds the energy of a triangle. terms: if given, those of a corner are added.
  static void AddEnergy(const Relaxed& side, int triangle, const Goal& goal, Total& total,
    Terms* terms = nullptr, int corner = 0);
  Star StarOf(const Relaxed& side, int point) const;
  Total EnergyOf(const Relaxed& side, const Star& star) const;
  /// Returns the step of a point on the flat surface, in its own coordinates.
  Eigen::RowVector2d StepOf(const Relaxed& side, int point, const Star& star) const;
  /// Returns the direction of the curve at a point, in its coordinates: (1, 0), (0, 1) or (-1, 1),
  /// or the opposite. Nothing if there is no curve.
  std::optional<Eigen::RowVector2d> CurveAt(const Relaxed& side, int point) const;
  /// Locates the held points again after a move. Whether each is in a triangle of the star.
  bool Relocate(const Relaxed& side, Star& star);
  bool Relax(Relaxed& side, int point);

  std::array<Relaxed, 2> Sides;
  Goal Lowered;
};

} // namespace shape
