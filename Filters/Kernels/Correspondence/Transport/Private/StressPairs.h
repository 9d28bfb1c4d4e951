#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A surface whose points have known distances from each other, scaled to area 1.
struct MetricSurface
{
  MetricSurface(const shape::Surface& surface, const Progress& progress);

  shape::Surface Shape;
  Eigen::MatrixXd Distances;                 ///< n x n
  std::vector<int> Samples;                  ///< all points, each the farthest from those before
  std::vector<std::vector<int>> TrianglesAt; ///< for each point
};

/// Pairs of positions on two surfaces, and their distances from all points: the state of
/// generalised multidimensional scaling. Side 0 is A, side 1 is B.
class StressPairs
{
public:
  /// The surfaces must outlive the object.
  StressPairs(const MetricSurface& a, const MetricSurface& b);

  int Count() const { return this->Pairs; }
  const SurfacePoint& Position(int side, int pair) const { return this->Positions[side][pair]; }
  int MovingSide(int pair) const { return this->Moving[pair]; }
  /// The distances of a point from all pairs on its side, as a row.
  auto DistancesOf(int side, int point) const
  {
    return this->Fields[side].row(point).head(this->Pairs);
  }

  /// Adds a pair of points. Later it moves on side `moving`; with -1, it does not move.
  void Add(int pointOfA, int pointOfB, int moving);
  /// Which image an added sample has at first.
  enum class ImageType
  {
    Lowest, ///< at the point with the smallest stress
    Rival   ///< at the lowest one of the other points where the stress has a local minimum
  };
  /// Adds a point of a side. Its image on the other side may move.
  void AddSample(int side, int point, ImageType image = ImageType::Lowest);
  /// Returns the stress at the Rival of a point, which is small if a symmetry exchanges the images.
  /// Without a rival it is infinite.
  double RivalStress(int side, int point) const;
  /// Returns the position on the side opposite to `side` for a point of `side`: first the point
  /// with the smallest stress, then the lowest position around. Pairs near the point count more.
  SurfacePoint FindImage(int side, int point) const;

  /// Moves every image in turn until the stress falls by less than a 1000th; at most `sweeps`
  /// times.
  void Minimize(int sweeps, const Progress& progress = {});
  /// The root mean square change of distances.
  double Stress() const;
  /// Whether most triangles of A have images that face inwards on B (100 triangles are tried).
  bool AreReversed() const;

private:
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  Eigen::RowVectorXd DistancesFrom(int side, const SurfacePoint& position) const;
  Eigen::RowVectorXd NearWeights(const Eigen::RowVectorXd& targets) const;
  Eigen::VectorXd StressAtPoints(
    int side, const Eigen::RowVectorXd& targets, const Eigen::RowVectorXd& weights) const;
  int FindRival(int side, const Eigen::VectorXd& stress) const;
  SurfacePoint Descend(int side, SurfacePoint position, const Eigen::RowVectorXd& targets,
    const Eigen::RowVectorXd& weights) const;
  void Append(const SurfacePoint& onA, const SurfacePoint& onB, int moving);
  void SetPosition(int side, int pair, const SurfacePoint& position);
  SurfacePoint AtPoint(int side, int point) const;

  const MetricSurface* Sides[2];
  Rows Fields[2]; ///< n x at least Pairs: distances from each point of a side to each pair
  std::vector<SurfacePoint> Positions[2];
  std::vector<int> Moving; ///< for each pair, the side on which it moves, or -1
  int Pairs = 0;
};

} // namespace shape
