#pragma once

#include "Geometry/Sampling.h"
#include "Harmonic/ChargeSet.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

// What is given to a harmonic volume map, and what it returns: see HarmonicVolumeMap.h.

struct HarmonicVolumeMapOptions
{
  enum class MethodType
  {
    /// A charge close to each point of the boundary, found by iteration with fast sums; where that
    /// leaves too much, the boundary is refined. Features are then met by MultiLevel on top.
    Accelerated = 0,
    MultiLevel = 1, ///< a sum of harmonic maps, each fitted to what the ones before left over
    SingleShot = 2  ///< one map, from one decomposition of all sources and collocation points
  };
  MethodType Method = MethodType::Accelerated;
  double Tolerance = 1e-4; ///< stop when RMSEInside is no more; >= 0
  int MaximumLevels = 12;  ///< most maps that are fitted; >= 1
  /// Accelerated: most points of the refined boundary for each point of the boundary, or for each
  /// of 2500 where there are fewer; >= 1.
  double MostRefined = 4.0;
  /// MultiLevel: the sources are dealt into so many levels, at least 16 to each; >= 1.
  int SourceSubsets = 8;
  /// Stop where two levels of MultiLevel in a row, or one of Accelerated after the first, lower
  /// what is left over by less than this share; Accelerated's iterations (Gmres.h), too; >= 0, < 1.
  double LeastGain = 0.02;
  double FeatureWeight = 20.0;   ///< of features that bring no weights; > 0
  double CollocationRatio = 0.4; ///< points where the map is fitted / points of the boundary; > 0
  double SourceRatio = 0.8;      ///< charges placed at the start / points of the boundary; > 0
  /// Of the farthest charges from the boundary / its longest side; MultiLevel's last subset is
  /// sqrt(subsets) times nearer. 0 = the nearest by the spacing of the points where the map is
  /// fitted.
  double OffsetDistance = 0.0;
  SamplingMode CollocationSampling = SamplingMode::GeometryAdaptive;
  SamplingMode SourceSampling = SamplingMode::GeometryAdaptive;
  double SingularValueThreshold = 1e-5; ///< where the boundary's longest side is 1; > 0
  double MaximumMemory = 4.0;           ///< GiB that one decomposition may take; > 0
  unsigned int Seed = 1;                ///< of the random points of uniform sampling
};

/// Points inside the domain whose images are wanted, in the least-squares sense.
struct VolumeFeatures
{
  Eigen::MatrixXd Points = Eigen::MatrixXd(0, 3);  ///< k x 3
  Eigen::MatrixXd Targets = Eigen::MatrixXd(0, 3); ///< k x 3
  Eigen::VectorXd Weights; ///< k, > 0: weight w counts as w equal rows; empty = FeatureWeight
};

struct HarmonicVolumeMapResult
{
  enum class Stop
  {
    Tolerance,     ///< RMSEInside reached the tolerance
    Levels,        ///< every level asked for was fitted
    NoImprovement, ///< what was left over became hardly less
    Refinement     ///< Accelerated: the boundary would have to be refined more than is allowed
  };
  /// One fitted map. Errors are those of the sum so far, over the whole boundary, divided by the
  /// longest side of the targets' box.
  struct Level
  {
    int Number = 0;            ///< 0: the affine map alone
    int Sources = 0;           ///< columns of the system
    int Collocations = 0;      ///< rows of the system, features included
    double RMSEVertices = 0.0; ///< at the boundary's points
    double RMSEInside = 0.0;   ///< at a place in each triangle (ComputeOffCentres)
    double Maximum = 0.0;      ///< over both
    double Seconds = 0.0;
    bool Kept = true; ///< false: no factor of it lowers what is left, so it is not in the sum
  };
  ChargeSet Map;             ///< in the coordinates of the input
  std::vector<Level> Levels; ///< the last one's errors are those of Map
  Stop Reason = Stop::Levels;
  /// Of the charges nearest to the boundary / its longest side. In a void they may be nearer than
  /// was asked for.
  double OffsetDistance = 0.0;
  double RMSEFeatures = 0.0; ///< of Map at the features, unweighted; 0 without features
  int DeletedSources = 0;    ///< left out of later levels because they were redundant
  int InsertedSources = 0;   ///< added where the fit was worst
  // Of Accelerated:
  int Iterations = 0;          ///< of all levels
  int RefinedPoints = 0;       ///< that the last level's boundary has beyond the given one's
  int PointsWithoutCharge = 0; ///< of the boundary: in gaps too narrow, or without a normal
};

} // namespace shape
