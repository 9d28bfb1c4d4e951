#include "Correspondence/Private/MethodOptions.h"

#include "Base/Errors.h"

#include <cmath>
#include <string>

namespace shape
{
namespace
{

void RequireAtLeast(int least, int value, const std::string& name)
{
  RequireOption(value >= least, name, value, "at least " + std::to_string(least));
}

void RequireWeight(double value, const std::string& name)
{
  RequireOption(value >= 0.0 && std::isfinite(value), name, value, "at least 0 and finite");
}

void RequirePositive(double value, const std::string& name)
{
  RequireOption(value > 0.0 && std::isfinite(value), name, value, "positive and finite");
}

void RequireShare(double value, const std::string& name)
{
  RequireOption(value > 0.0 && value < 1.0, name, value, "between 0 and 1");
}

} // namespace

void RequireMethodOptions(const CorrespondenceOptions& options)
{
  RequireAtLeast(10, options.NumberOfEigenpairs, "NumberOfEigenpairs");
  RequireOption(options.CoarsePoints == 0 || options.CoarsePoints >= 100, "CoarsePoints",
    options.CoarsePoints, "0 or at least 100");
  RequireAtLeast(0, options.Rank, "Rank");
  RequireAtLeast(10, options.Samples, "Samples");
  RequireAtLeast(1, options.MaximumIterations, "MaximumIterations");

  const FunctionalMapOptions& functional = options.Functional;
  RequireAtLeast(1, functional.Fit.Size, "FunctionalMapSize");
  RequireAtLeast(1, functional.Descriptors, "NumberOfDescriptors");
  RequireAtLeast(1, functional.Fit.OperatorStride, "OperatorStride");
  RequireAtLeast(0, functional.Refinement.Step, "ZoomOutStep");
  RequireAtLeast(10, functional.Samples, "ZoomOutSamples");
  RequireWeight(functional.Fit.LaplacianWeight, "LaplacianWeight");
  RequireWeight(functional.Fit.DescriptorWeight, "DescriptorWeight");
  RequireWeight(functional.Fit.OrientationWeight, "OrientationWeight");
  RequireWeight(functional.Fit.CurveWeight, "CurveWeight");
  RequireWeight(functional.Fit.DisplacementWeight, "DisplacementWeight");
  RequireWeight(functional.Fit.Displacement, "Displacement");
  const double samples = functional.Refinement.SamplesPerFunction;
  RequireOption(samples == 0.0 || (samples >= 1.0 && std::isfinite(samples)),
    "SamplesPerEigenfunction", samples, "0, or at least 1 and finite");
  RequireWeight(functional.Fit.OrthonormalityWeight, "OrthonormalityWeight");
  RequireWeight(functional.Fit.InverseWeight, "InverseWeight");

  const ReversibleHarmonicOptions& harmonic = options.Harmonic;
  RequireShare(harmonic.Alpha, "Alpha");
  RequireShare(harmonic.FirstAlpha, "FirstAlpha");
  RequireAtLeast(0, harmonic.AlphaSteps, "AlphaSteps");
  RequirePositive(harmonic.BetaStep, "BetaStep");
  RequireAtLeast(1, harmonic.BetaSteps, "BetaSteps");
  // EmbeddedSurface has at most 32 dimensions.
  RequireOption(harmonic.Scaling.Dimensions >= 1 && harmonic.Scaling.Dimensions <= 32, "Dimensions",
    harmonic.Scaling.Dimensions, "from 1 to 32");

  RequireCouplingOptions(options.Coupling);
  RequireAtLeast(2, options.CouplingEigenpairs, "CouplingEigenpairs");
  RequireOption(options.Features.FeatureWeight >= 0.0 && options.Features.FeatureWeight <= 1.0,
    "FeatureWeight", options.Features.FeatureWeight, "between 0 and 1");
  RequireAtLeast(8, options.ScalingSamples, "ScalingSamples");
  RequireAtLeast(1, options.ScalingStarts, "ScalingStarts");
  RequireAtLeast(2, options.DistanceSamples, "DistanceSamples");

  RequireAtLeast(2, options.Heat.Eigenpairs, "HeatEigenpairs");
  RequireAtLeast(1, options.Heat.Times, "HeatTimes");
  RequireAtLeast(1, options.Blended.Candidates, "Candidates");
  RequirePositive(options.Blended.Agreement, "Agreement");
  RequireAtLeast(3, options.Blended.TripletPoints, "TripletPoints");
  RequirePositive(options.Blended.TripletTolerance, "TripletTolerance");
  RequireAtLeast(1, options.Blended.TripletMaps, "TripletMaps");
  RequireOption(options.Blended.GroupShare > 0.0 && options.Blended.GroupShare <= 1.0, "GroupShare",
    options.Blended.GroupShare, "above 0, at most 1");
  RequirePositive(options.Base.Exponent, "BaseExponent");

  const MoebiusVotingOptions& voting = options.Voting;
  RequireAtLeast(10, voting.Samples, "VotingSamples");
  RequireAtLeast(3, voting.Generators, "VotingGenerators");
  RequireAtLeast(1, voting.Triples, "VotingTriples");
  RequirePositive(voting.Tolerance, "TripleTolerance");
  RequireOption(
    voting.Share > 0.0 && voting.Share <= 1.0, "VotingShare", voting.Share, "above 0, at most 1");
  RequirePositive(voting.Energy, "VotingEnergy");
}

} // namespace shape
