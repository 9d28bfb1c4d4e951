/**
 * @class   vtkShapeCorrespondence
 * @brief   map two surfaces onto each other, both ways, with or without landmarks
 *
 * Inputs
 * - SurfaceA, SurfaceB: oriented 2-manifolds that face outwards. Polygons are triangulated
 *   internally. shape::RequireMethodInput states which methods accept boundaries, handles or
 *   several components. Blocks and distributed pieces are joined first, and each process gets its
 *   own back.
 * - Landmarks (optional): points and polylines on SurfaceA with the point array `TargetPosition`
 *   on SurfaceB. Each point is moved to the nearest point of its surface. If two reach the same
 *   point, only the first is used. Polylines are sampled at the mean edge length of SurfaceA.
 *   Without this input the filter finds landmarks (shape::FindLandmarks) on surfaces of one
 *   component.
 *
 * Outputs: SurfaceA and SurfaceB with the precise map onto the other one, the point arrays
 * - `TargetPosition` (double, 3).
 * - `TargetCell` (vtkIdType): the triangle that contains it. This is a cell of the other surface
 *   if that has neither strips nor larger polygons. Otherwise polygons and strips are cut into
 *   triangles, which are numbered in order after vertices and lines.
 * - `TargetBarycentric` (double, 3): the barycentric coordinates, in the order of the corners.
 *
 * Field data of both, with the prefix Correspondence
 * - .Landmarks: number of landmarks used. .LandmarksFound: 1 if the filter found them.
 * - .Distortion, .MirroredDistortion, .MirrorImage, .Confidence: if the filter found them, see
 *   shape::AutomaticLandmarksResult; otherwise -1.
 * - .DirichletEnergy, .RoundTrip, .ReversedArea: shape::SurfaceMapFacts.
 * - .Part: 1 if SurfaceA is taken as a part of SurfaceB, 2 if SurfaceB is a part of SurfaceA,
 *   otherwise 0. .Scale: lengths on SurfaceB divided by those on SurfaceA. .PartShare: area of the
 *   part divided by that of the other surface. See shape::SurfacePart.
 * - .CoverageOfA, .CoverageOfB: shares of area that have a partner: points that the round trip
 *   returns to within a 50th of the root of the area.
 * - .Mirrored: 1 if ReversedArea exceeds 0.3, that is, if the map exchanges left and right, on all
 *   of the surface or on protrusions.
 * - .CouplingDistortion, .CouplingError: of GromovWasserstein, otherwise -1. The first measures
 *   how well samples preserve their distances, the second how far masses are from their prescribed
 *   weights.
 * - .CoarsePoints: number of points of the larger surface on which the method worked.
 * - .Iterations: of ReversibleHarmonic, otherwise 0. It is also 0 if one surface is a part: the
 *   initial functional map is then the result, since iterations would spread it.
 *
 * A sparse factorisation cannot be interrupted, so an abort takes effect at its end.
 *
 * The mathematics: shape::ComputeCorrespondence.
 */
#ifndef vtkShapeCorrespondence_h
#define vtkShapeCorrespondence_h

#include "vtkShapeAlgorithm.h"

#include "Correspondence/Correspondence.h" // for the options

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
    shape::CorrespondenceOptions::MethodType::CommonOrbifold);
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
  ///@}

protected:
  vtkShapeCorrespondence();
  ~vtkShapeCorrespondence() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeCorrespondence(const vtkShapeCorrespondence&) = delete;
  void operator=(const vtkShapeCorrespondence&) = delete;

  /// Fills output `port` with its surface and the map onto the other one.
  void WriteMap(int port, const shape::SurfacePoints& map, const shape::Mesh& other, int otherPort);

  shape::CorrespondenceOptions Options;
};

#endif
