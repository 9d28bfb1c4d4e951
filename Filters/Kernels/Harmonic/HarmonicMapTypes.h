#pragma once

#include "Geometry/Sampling.h"
#include "Harmonic/ChargeSet.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

// Input, options and result of ComputeHarmonicVolumeMap (HarmonicVolumeMap.h).

struct HarmonicVolumeMapOptions
{
  enum class MethodType
  {
    /// One charge close to each point of the boundary, solved for iteratively with fast sums. If
    /// the error stays above the tolerance, the boundary is refined. Features are then fitted by
    /// MultiLevel on top of this map.
    Accelerated = 0,
    MultiLevel = 1, ///< a sum of harmonic maps, each fitted to the residual of the previous maps
    SingleShot = 2, ///< one map, from one decomposition of all sources and collocation points
    /// no charges: linear finite elements on tetrahedra (FiniteElementMap.h)
    FiniteElements = 3
  };
  MethodType Method = MethodType::Accelerated;
  double Tolerance = 1e-4; ///< stop when RMSEInside is at most this; >= 0
  int MaximumLevels = 12;  ///< maximum number of maps in the sum; >= 1
  /// Accelerated: limits the refinement of the boundary. The refined boundary has at most
  /// MostRefined times max(2500, number of boundary points) points. > 0.
  double MostRefined = 4.0;
  /// Accelerated: distance of the charges from the boundary / spacing of its points; 0.3 to 3. More
  /// than the default smooths the map between the points, so that it folds less near the surface,
  /// but follows the boundary's detail less. RMSEInside of sphere maps at 0.6, 0.75, 0.9, 1.0:
  /// bear_bis 1.9e-4, 1.5e-4, 1.4e-4, 1.4e-4; bunny00 1.1e-4, 8.8e-5, 7.8e-5, 7.6e-5;
  /// retinal 6.0e-4, 5.6e-4, 5.7e-4, 6.5e-4.
  double ChargeDistance = 0.9;
  /// MultiLevel: number of subsets into which the sources are divided; >= 1. The number is reduced
  /// if a subset would otherwise have fewer than 16 sources.
  int SourceSubsets = 8;
  /// Minimum relative decrease of the residual; >= 0, < 1. MultiLevel stops when two levels in a
  /// row decrease it by less than this. Accelerated stops when one level after the first does. This
  /// is also GmresOptions::LeastGain of Accelerated.
  double LeastGain = 0.02;
  double FeatureWeight = 20.0;   ///< weight of features that are given without weights; > 0
  double CollocationRatio = 0.4; ///< number of collocation points / number of boundary points; > 0
  double SourceRatio = 0.8;      ///< initial number of charges / number of boundary points; > 0
  /// Distance of the farthest charges from the boundary / longest side of the boundary's box; >= 0.
  /// The last subset of MultiLevel is sqrt(SourceSubsets) times nearer. If OffsetDistance is 0, the
  /// distance of the nearest charges follows from the spacing of the collocation points.
  double OffsetDistance = 0.0;
  SamplingMode CollocationSampling = SamplingMode::GeometryAdaptive;
  SamplingMode SourceSampling = SamplingMode::GeometryAdaptive;
  double SingularValueThreshold = 1e-5; ///< for a boundary whose longest side is 1; > 0
  double MaximumMemory = 4.0;           ///< maximum memory of one decomposition in GiB; > 0
  unsigned int Seed = 1;                ///< seed of the random points of uniform sampling
  /// FiniteElements: the approximate number of tetrahedra: 1,000 to 100,000,000. It is larger if
  /// the boundary has many triangles.
  int Tetrahedra = 200000;
  SumDevice Device; ///< Accelerated: where its sums over charges are computed
};

/// Points inside the domain with prescribed images. The map fits them in the least-squares sense.
struct VolumeFeatures
{
  Eigen::MatrixXd Points = Eigen::MatrixXd(0, 3);  ///< k x 3
  Eigen::MatrixXd Targets = Eigen::MatrixXd(0, 3); ///< k x 3
  /// k values, each > 0: a weight w has the effect of w equal rows. Empty: all are FeatureWeight.
  Eigen::VectorXd Weights;
};

struct HarmonicVolumeMapResult
{
  enum class Stop
  {
    Tolerance,     ///< RMSEInside reached the tolerance
    Levels,        ///< all MaximumLevels levels were fitted
    NoImprovement, ///< the residual decreased by less than LeastGain
    Refinement     ///< Accelerated: a further refinement would exceed MostRefined
  };
  /// One fitted map. The errors are measured after this map has been added to the sum, over the
  /// whole boundary. They are divided by the longest side of the targets' box.
  struct Level
  {
    int Number = 0;            ///< 0: the affine map alone
    int Sources = 0;           ///< number of columns of the system
    int Collocations = 0;      ///< number of rows of the system, features included
    double RMSEVertices = 0.0; ///< at the boundary's points
    double RMSEInside = 0.0;   ///< at one position inside each triangle (ComputeOffCentres)
    double Maximum = 0.0;      ///< maximum error at both
    /// at all collocation points on the boundary; 0 if there are none, as of FiniteElements
    double RMSECollocations = 0.0;
    double Seconds = 0.0;
    /// false: no positive factor of this map lowers the residual, so it is left out
    bool Kept = true;
  };
  ChargeSet Map;             ///< in the coordinates of the input
  std::vector<Level> Levels; ///< the errors of the last level are those of Map
  Stop Reason = Stop::Levels;
  /// Distance of the nearest charges from the boundary / longest side of the boundary's box. It is
  /// smaller than the requested distance if a void is too narrow.
  double OffsetDistance = 0.0;
  /// root mean square error of Map at the features, unweighted; 0 without features
  double RMSEFeatures = 0.0;
  int DeletedSources = 0;  ///< number of redundant sources left out of later levels
  int InsertedSources = 0; ///< number of sources added near the largest errors
  // Set by Accelerated only:
  int Iterations = 0; ///< total number of iterations of all levels
  /// number of points added to the boundary by refinement, at the last level
  int RefinedPoints = 0;
  /// number of boundary points without a charge, because a gap is too narrow or the point has no
  /// normal
  int PointsWithoutCharge = 0;
};

} // namespace shape
