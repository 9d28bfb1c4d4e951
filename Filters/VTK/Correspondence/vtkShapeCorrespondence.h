/**
 * @class   vtkShapeCorrespondence
 * @brief   map two surfaces onto each other, both ways, with or without landmarks
 *
 * Inputs
 * - SurfaceA, SurfaceB: oriented 2-manifolds that face outwards. Polygons are triangulated
 *   internally. An unstructured grid of solid cells stands for its boundary, such as a polycube of
 *   hexahedra or voxels: the output then has the faces of the boundary and their points.
 *   shape::RequireMethodInput states which methods accept boundaries, handles or several
 *   components. Blocks and distributed pieces are joined before the computation, and each process
 *   gets its own pieces back.
 * - Landmarks (optional): points and polylines on SurfaceA. Their point array `TargetPosition`
 *   gives the corresponding positions on SurfaceB. Each position is replaced by the nearest point
 *   of its surface. If two landmarks have the same point on a surface, only the first landmark is
 *   used. Polylines are sampled at the mean edge length of SurfaceA. For CommonBase, they are
 * curves instead: they follow the edges of both surfaces, and are mapped onto each other. Points of
 * a polyline other than its ends are then no landmarks, unless they are vertex cells. Without this
 * input, the filter finds landmarks itself (shape::FindLandmarks or shape::VoteByMoebiusMaps),
 * which requires surfaces of one component.
 * - TargetLandmarks (optional): points on SurfaceB, paired with the points of Landmarks by order.
 *   They replace the array TargetPosition of Landmarks.
 * - FunctionalMap (optional): a table with a matrix, a functional map from SurfaceA to
 *   SurfaceB. It has the bases of the output FunctionalMap, and replaces the fit to descriptors. In
 *   parallel, the table of the first process is used.
 *
 * If FunctionalMap, DescriptorArrays or RegionArray guide the functional map, no landmarks are
 * found.
 *
 * Outputs: SurfaceA and SurfaceB, each with the precise map onto the other surface. The map
 * consists of the point arrays
 * - `TargetPosition` (double, 3).
 * - `TargetCell` (vtkIdType): the triangle that contains this position. It is a cell index if all
 *   polygons of the other surface are triangles and it has no strips. Otherwise, polygons and
 *   strips are cut into triangles, which are numbered in order after vertices and lines.
 * - `TargetBarycentric` (double, 3): the barycentric coordinates, in the order of the corners.
 * With GromovWasserstein, or landmarks found by MoebiusVotes, both outputs also have
 * - `SampleWeight` (double): the weight of each sample or its share of the votes, and 0 at all
 *   other points. The sum is 1.
 * If ImageOfPoint is a point of SurfaceA, the output SurfaceB also has
 * - `ImageDistribution` (double): the density of this point's image. The sum over all points, times
 *   their areas (a third of the triangles around), is 1. See shape::ComputeImageDistribution.
 *
 * With BlendedIntrinsic, both outputs also have `MapConfidence` (double): the confidence of the
 * map, in [0, 1]. See shape::BlendedIntrinsicResult.
 *
 * With CommonBase, both outputs also have `Patch` (vtkIdType): the patch of the common base domain,
 * the same for corresponding points. With CommonSphere, `SpherePosition` (double, 3): the point on
 * the unit sphere through which the map goes.
 *
 * `MapColors` (unsigned char, 3) are colours for the eye: corresponding points have the same one.
 * With OutputEigenfunctions, also
 * - `Eigenfunctions` (double, k): those of the surface, as shape::SolveLaplaceEigenproblem and
 * Shape Laplace Spectrum compute them on the given surface, however coarse the surfaces were on
 * which the method ran.
 * - `Masses` (double): the area around each point, in which the eigenfunctions are orthonormal.
 * - Field data `Eigenvalues` (double, k), ascending, in 1 / length^2.
 * With CoupledBasisSize k > 0, `CoupledEigenfunctions` (double, k): bases of both surfaces, in
 * which the matrix of the map is nearly diagonal. See shape::CoupleEigenfunctions. SurfaceB has,
 * for each name X of TransferArrays, the point array `XFromA`: Phi_B C Phi_A' M_A X, where Phi are
 * the eigenfunctions, M the masses and C the matrix.
 *
 * Output FunctionalMap, after Facts: with OutputEigenfunctions or TransferArrays, and any method,
 * the matrix C of the map from SurfaceB to SurfaceA (shape::FunctionalMatrix). It takes
 * coefficients of functions on SurfaceA to coefficients on SurfaceB: C = Phi_B' M_B P Phi_A, where
 * P interpolates at TargetPosition of SurfaceB. A row for each eigenfunction of SurfaceB; the
 * columns 0, 1, 2 and so on are those of SurfaceA. Field data: EigenvaluesOfA, EigenvaluesOfB;
 * ScaleOfA, ScaleOfB, the roots of the areas: C times ScaleOfA / ScaleOfB is the matrix of the
 * surfaces scaled to area 1. Otherwise, the table is empty. In parallel, the first process has it.
 *
 * Coupling: a vtkTable, empty except with GromovWasserstein, or if landmarks were found by
 * MoebiusVotes: then the masses are shares of the votes (shape::MoebiusVotes). A row for each entry
 * of the coupling that is greater than SmallestMass:
 * - `SampleOfA`, `SampleOfB` (vtkIdType): points of the inputs. Points of several blocks or pieces
 *   are numbered as joined.
 * - `Mass` (double): the mass that goes from the first to the second. The total mass is 1. The sum
 *   over the rows of a sample is its SampleWeight, up to CouplingError + CouplingOmitted.
 * In parallel, the first process has the rows.
 *
 * BaseDomain: with CommonBase, a polyline on SurfaceA for each path of the base domain. It has the
 * point array `TargetPosition` on SurfaceB, and the cell arrays `LeftPatch`, `RightPatch`
 * (vtkIdType): the patches on both sides, looking along the path from outside. `IsCurve` is 1 for a
 * piece of a given curve. If landmarks were found on handles, the loops there (shape::HandleLoop)
 * follow as further polylines, with the patches -1. `HandleLoop` is 1 for a loop that bounds inside
 * SurfaceA, 2 for one that bounds outside, and 0 for a path. Otherwise, the output is empty. In
 * parallel, the first process has it.
 *
 * Candidates: a vtkTable, empty except with BlendedIntrinsic. A row for each conformal map that is
 * a candidate:
 * - `FirstOfA`, `SecondOfA`, `ThirdOfA`, `FirstOfB`, `SecondOfB`, `ThirdOfB` (vtkIdType): the
 * points of the inputs that the map takes to each other, numbered as in Coupling.
 * - `Weight` (double): the map's weight; 0 if it is not in the group that is blended.
 * - `0`, `1`, `2` and so on (double): its consistency with each candidate, in [0, 1].
 * In parallel, the first process has the rows.
 *
 * Facts, with the prefix Correspondence
 * - .Landmarks: number of landmarks used. .LandmarksFound: 1 if the filter found the landmarks
 *   itself, otherwise 0. .LandmarkTargets: where the positions on SurfaceB come from,
 *   "TargetPosition" or "TargetLandmarks"; only with Landmarks.
 * - .Distortion, .MirroredDistortion, .MirrorImage, .IsometryError (Error), .Alternatives,
 *   .Confidence, .Certain: see shape::AutomaticLandmarksResult. They are -1, and .Alternatives is
 * 0, unless landmarks were found by Distances.
 * - .Congruence: 1 if SurfaceB is SurfaceA, moved and scaled. It is 2 if it is a mirror image, 3 if
 * it is both, because the shape has a mirror symmetry, and 0 if it is neither. .MotionError and
 *   .ReflectionError: see shape::Congruence. They are -1 if no landmarks were found.
 * - .VotingMaps, .VotingConfidence: with landmarks found by MoebiusVotes, the number of Moebius
 * maps that voted, and the mean confidence of the landmarks (shape::MoebiusVotes); otherwise 0 and
 * -1.
 * - .DirichletEnergy, .RoundTrip, .ReversedArea: see shape::SurfaceMapFacts.
 * - .Part: 1 if SurfaceA is treated as a part of SurfaceB, 2 if SurfaceB is treated as a part of
 *   SurfaceA, otherwise 0. .Scale: lengths on SurfaceB divided by those on SurfaceA. .PartShare:
 *   area of the part divided by the area of the other surface, at this scale. See
 *   shape::SurfacePart.
 * - .CoverageOfA, .CoverageOfB: share of the area of each surface that has a partner. A point has a
 *   partner if both maps in turn return it to within 1/50 of the root of the area.
 * - .Mirrored: 1 if ReversedArea exceeds 0.3. The map then exchanges left and right, on all of the
 *   surface or on protrusions.
 * - .CouplingDistortion, .CouplingError: only for GromovWasserstein, otherwise -1. The first
 *   measures how much distances between samples change. The second measures how far the masses of
 *   samples are from their prescribed weights.
 * - .FeatureCost: with GromovWasserstein, the mean squared difference of the FeatureArrays of
 * coupled points, each divided by its range; otherwise -1.
 * - .MaximumDistortion, .RMSDistortion: the largest change of a distance along the surfaces, and
 * the root mean square. .GromovHausdorffUpper, .GromovHausdorffLower, .SamplingError: bounds of the
 *   Gromov-Hausdorff distance. See shape::GromovHausdorffResult. They are -1 unless
 * CompareDistances is on or Method is GeneralizedMDS.
 * - .CouplingOmitted: the mass of the entries that the table Coupling leaves out; otherwise -1.
 * - .CoarsePoints: the method was run on two surfaces, coarser ones if the inputs are large. This
 *   is the number of points of the larger one.
 * - .Patches: with CommonBase, the number of patches of the common base domain; otherwise 0.
 *   .FlippedTriangles, .SymmetricDirichlet, .SymmetricDirichletBack (of SurfaceB),
 *   .MeasureBefore, .MeasureAfter: only for CommonBase, see shape::CommonBaseMap.
 *   .GenusOfA, .GenusOfB: the number of handles of each surface.
 * - .ShortestLoopOfA, .ShortestLoopOfB: if CommonBase found landmarks on handles, the length of the
 *   shortest loop, divided by the root of the area; otherwise -1. The filter warns if it is less
 *   than 0.05.
 * - .Iterations: with ReversibleHarmonic, the number of its iterations; otherwise 0. If one surface
 *   is a part of the other, .Iterations is also 0. The result is then the initial functional map,
 *   because iterations would spread the part over the other surface.
 * - .CandidateMaps, .GroupMaps, .MeanConfidence: with BlendedIntrinsic, the number of candidates,
 *   that of those with a weight, and the mean of MapConfidence of the surface, by area; otherwise
 * 0, 0 and -1.
 * - .CoupledDiagonal: the share of the squared entries of the map's matrix in the coupled bases
 * that is on the diagonal; -1 without them.
 * - .FunctionalMapSize: rows and columns of the output FunctionalMap; 0 if it is empty.
 *
 * The mathematics: shape::ComputeCorrespondence.
 */
#ifndef vtkShapeCorrespondence_h
#define vtkShapeCorrespondence_h

#include "vtkShapeAlgorithm.h"

#include "Correspondence/Correspondence.h"          // for the options
#include "Correspondence/Functional/CoupledBases.h" // for the options

#include <string> // for names of arrays
#include <vector> // for names of arrays

class VTKSHAPEFILTERS_EXPORT vtkShapeCorrespondence : public vtkShapeAlgorithm
{
public:
  static vtkShapeCorrespondence* New();
  vtkTypeMacro(vtkShapeCorrespondence, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeCorrespondence.xml. Enumerations and defaults:
  /// shape::CorrespondenceOptions.
  vtkShapeEnumOption(Method, shape::CorrespondenceOptions::MethodType,
    shape::CorrespondenceOptions::MethodType::ReversibleHarmonic,
    shape::CorrespondenceOptions::MethodType::CommonBase);
  vtkShapeEnumOption(Start, shape::CorrespondenceOptions::StartType,
    shape::CorrespondenceOptions::StartType::FunctionalMap,
    shape::CorrespondenceOptions::StartType::LandmarkCells);
  vtkShapeEnumOption(Part, shape::CorrespondenceOptions::PartType,
    shape::CorrespondenceOptions::PartType::Automatic,
    shape::CorrespondenceOptions::PartType::SurfaceB);
  vtkShapeOption(PinLandmarks, bool);
  vtkShapeOption(MaximumIterations, int);
  vtkShapeOption(NumberOfEigenpairs, int);
  vtkShapeOption(Samples, int);
  vtkShapeOption(CoarsePoints, int);
  vtkShapeEnumOptionAs(Options.Functional.Use, Descriptors,
    shape::FunctionalMapOptions::DescriptorType,
    shape::FunctionalMapOptions::DescriptorType::BuiltIn,
    shape::FunctionalMapOptions::DescriptorType::Both);
  vtkShapeOptionAs(Options.Functional.Fit.Size, FunctionalMapSize, int);
  vtkShapeOptionAs(Options.Functional.Descriptors, NumberOfDescriptors, int);
  vtkShapeOptionOf(Options.Functional.Fit, OperatorStride, int);
  vtkShapeOptionOf(Options.Functional.Fit, LaplacianWeight, double);
  vtkShapeOptionOf(Options.Functional.Fit, DescriptorWeight, double);
  vtkShapeOptionOf(Options.Functional.Fit, OrientationWeight, double);
  vtkShapeOptionOf(Options.Functional.Fit, CurveWeight, double);
  vtkShapeOptionOf(Options.Functional.Fit, DisplacementWeight, double);
  vtkShapeOptionOf(Options.Functional.Fit, Displacement, double);
  vtkSetStdStringFromCharMacro(DisplacementArray);
  vtkGetCharFromStdStringMacro(DisplacementArray);
  vtkShapeOptionAs(
    Options.Functional.Refinement.SamplesPerFunction, SamplesPerEigenfunction, double);
  vtkShapeOptionOf(Options.Functional.Fit, OrthonormalityWeight, double);
  vtkShapeOptionOf(Options.Functional.Fit, InverseWeight, double);
  vtkShapeEnumOptionOf(Options.Functional.Fit, Mask, shape::FunctionalMapFitOptions::MaskType,
    shape::FunctionalMapFitOptions::MaskType::Laplacian,
    shape::FunctionalMapFitOptions::MaskType::Resolvent);
  vtkShapeOptionAs(Options.Functional.Refinement.Step, ZoomOutStep, int);
  vtkShapeOptionAs(Options.Functional.Samples, ZoomOutSamples, int);
  vtkShapeOptionOf(Options.Harmonic, Alpha, double);
  vtkShapeOptionOf(Options.Harmonic, FirstAlpha, double);
  vtkShapeOptionOf(Options.Harmonic, AlphaSteps, int);
  vtkShapeOptionOf(Options.Harmonic, BetaStep, double);
  vtkShapeOptionOf(Options.Harmonic, BetaSteps, int);
  vtkShapeOptionOf(Options.Harmonic.Scaling, Dimensions, int);
  vtkShapeOptionAs(Options.Heat.Eigenpairs, HeatEigenpairs, int);
  vtkShapeOptionAs(Options.Heat.Times, HeatTimes, int);
  vtkShapeEnumOptionAs(Options.Base.Measure, BaseMeasure, shape::Distortion,
    shape::Distortion::SymmetricDirichlet, shape::Distortion::ARAP);
  vtkShapeOptionAs(Options.Base.Exponent, BaseExponent, double);
  vtkShapeEnumOption(FindLandmarksBy, shape::CorrespondenceOptions::FinderType,
    shape::CorrespondenceOptions::FinderType::Distances,
    shape::CorrespondenceOptions::FinderType::MoebiusVotes);
  vtkShapeOption(Rank, int);
  vtkShapeOptionAs(Options.Voting.Samples, VotingSamples, int);
  vtkShapeOptionAs(Options.Voting.Generators, VotingGenerators, int);
  vtkShapeOptionAs(Options.Voting.Triples, VotingTriples, int);
  vtkShapeOptionAs(Options.Voting.Tolerance, TripleTolerance, double);
  vtkShapeOptionAs(Options.Voting.Share, VotingShare, double);
  vtkShapeOptionAs(Options.Voting.Energy, VotingEnergy, double);
  vtkShapeOptionOf(Options.Blended, Candidates, int);
  vtkShapeOptionOf(Options.Blended, Agreement, double);
  vtkShapeEnumOptionOf(Options.Blended, CandidatesFrom,
    shape::BlendedIntrinsicOptions::CandidatesType,
    shape::BlendedIntrinsicOptions::CandidatesType::Landmarks,
    shape::BlendedIntrinsicOptions::CandidatesType::Triplets);
  vtkShapeOptionOf(Options.Blended, TripletPoints, int);
  vtkShapeOptionOf(Options.Blended, TripletTolerance, double);
  vtkShapeOptionOf(Options.Blended, TripletMaps, int);
  vtkShapeOptionOf(Options.Blended, GroupShare, double);
  virtual void SetNumberOfDescriptorArrays(int count);
  virtual void SetDescriptorArrays(int index, const std::string& name);
  virtual std::vector<std::string> GetDescriptorArrays() { return this->DescriptorArrays; }
  vtkSetStdStringFromCharMacro(RegionArray);
  vtkGetCharFromStdStringMacro(RegionArray);
  vtkShapeOptionAs(CurveDescriptors, CurveDescriptors, bool);
  vtkShapeOptionAs(OutputEigenfunctions, OutputEigenfunctions, bool);
  vtkShapeOptionAs(Coupled.Size, CoupledBasisSize, int);
  vtkShapeOptionAs(Coupled.Weight, CoupledBasisWeight, double);
  virtual void SetNumberOfTransferArrays(int count);
  virtual void SetTransferArrays(int index, const std::string& name);
  virtual std::vector<std::string> GetTransferArrays() { return this->TransferArrays; }
  vtkShapeOption(CouplingEigenpairs, int);
  vtkShapeEnumOption(CouplingStart, shape::CorrespondenceOptions::CouplingStartType,
    shape::CorrespondenceOptions::CouplingStartType::Best,
    shape::CorrespondenceOptions::CouplingStartType::Rival);
  vtkShapeOptionOf(Options.Coupling, FirstEntropy, double);
  vtkShapeOptionOf(Options.Coupling, Entropy, double);
  vtkShapeOptionOf(Options.Coupling, EntropyFactor, double);
  vtkShapeOptionOf(Options.Coupling, IterationsPerEntropy, int);
  vtkShapeOptionOf(Options.Coupling, SinkhornIterations, int);
  vtkShapeOptionOf(Options.Features, FeatureWeight, double);
  vtkShapeOption(ScalingSamples, int);
  vtkShapeOption(ScalingStarts, int);
  vtkShapeOption(CompareDistances, bool);
  vtkShapeOption(DistanceSamples, int);
  vtkSetMacro(SmallestMass, double);
  vtkGetMacro(SmallestMass, double);
  vtkSetMacro(ImageOfPoint, int);
  vtkGetMacro(ImageOfPoint, int);
  virtual void SetNumberOfFeatureArrays(int count);
  virtual void SetFeatureArrays(int index, const std::string& name);
  virtual std::vector<std::string> GetFeatureArrays() { return this->FeatureArrays; }
  ///@}

protected:
  vtkShapeCorrespondence();
  ~vtkShapeCorrespondence() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeCorrespondence(const vtkShapeCorrespondence&) = delete;
  void operator=(const vtkShapeCorrespondence&) = delete;

  /// Reads the arrays, curves and the matrix that guide a functional map.
  shape::FunctionalGuide ReadGuide(const shape::Surface& a, const shape::Surface& b);
  /// Fills output `port` with the surface of that port, its map onto the other surface, `more`
  /// arrays, whose rows are those of the gathered surface, its eigenfunctions if they are wanted,
  /// and what is transferred to it.
  void WriteMap(int port, const shape::CorrespondenceResult& result, const shape::Mesh& other,
    const std::map<std::string, Eigen::MatrixXd>& more);
  /// Fills the output Coupling. Returns the mass that the table omits, or -1 if there is no
  /// coupling.
  double WriteCoupling(const shape::SampledCoupling& coupling);

  std::vector<std::string> DescriptorArrays, FeatureArrays, TransferArrays;
  std::string RegionArray = "None", DisplacementArray = "None";
  bool CurveDescriptors = false, OutputEigenfunctions = false;
  shape::CorrespondenceOptions Options;
  shape::CoupledBasesOptions Coupled = { 0 }; // no bases by default
  double SmallestMass = 1e-9;
  int ImageOfPoint = -1;
};

#endif
