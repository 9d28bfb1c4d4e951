/**
 * @class   vtkShapeCorrespondence
 * @brief   which point of one surface corresponds to which point of another one, both ways
 *
 * Inputs
 * - SurfaceA, SurfaceB: oriented 2-manifolds (polygons are triangulated inside), facing outwards;
 *   which methods take borders, handles or several components: shape::RequireMethodInput.
 *   Blocks and distributed pieces are joined first; each process gets its own back.
 * - Landmarks (optional): points and polylines on SurfaceA with the point array `TargetPosition` on
 *   SurfaceB. Each stands for the nearest point of its surface, of two that stand for one the
 * first; along lines more are put in, a mean edge of SurfaceA apart. Without them the filter finds
 * its own (shape::FindLandmarks), on surfaces of one component.
 *
 * Outputs: SurfaceA and SurfaceB with the precise map onto the other one, the point arrays
 * - `TargetPosition` (double, 3),
 * - `TargetCell` (vtkIdType): the triangle that it lies in, a cell of the other surface where that
 *   has no strips and no polygons of more corners; else counted after its vertices and lines with
 *   polygons and strips cut into triangles in order,
 * - `TargetBarycentric` (double, 3): the place in it, by the order of its corners.
 *
 * Field data of both
 * - Correspondence.Landmarks: how many were used; Correspondence.LandmarksFound: 1 where the filter
 *   found them,
 * - Correspondence.Distortion, .MirroredDistortion, .MirrorImage, .Confidence, where it found them,
 *   else -1: how well samples keep their distances, how well they would in the mirror image,
 *   whether SurfaceB is rather one, and how clear the choice was; see
 *   shape::AutomaticLandmarksResult,
 * - Correspondence.DirichletEnergy, .RoundTrip, .ReversedArea: shape::SurfaceMapFacts,
 * - Correspondence.Part: 1 where SurfaceA is taken for a part of SurfaceB, 2 where SurfaceB is for
 *   one of SurfaceA, else 0; .Scale: lengths on SurfaceB over those on SurfaceA; .PartShare: of the
 *   whole's area; see shape::SurfacePart,
 * - Correspondence.CoverageOfA, .CoverageOfB: shares of area that come back: what has a partner,
 * - Correspondence.Mirrored: 1 where the map exchanges sides, of all or of limbs, else 0: where
 *   ReversedArea is more than 0.3,
 * - Correspondence.CouplingDistortion, .CouplingError: of GromovWasserstein, else -1: how well
 *   samples keep their distances, and how far masses are from the weights that they should have,
 * - Correspondence.CoarsePoints: of the larger surface that the method worked on,
 * - Correspondence.Iterations: of ReversibleHarmonic, else 0; 0 also where a part is mapped into
 * the whole by the functional map that it starts from, which iterations would spread.
 *
 * Sparse factorisations are one library call each: an abort takes effect at the end of one.
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
  /// 0 = ReversibleHarmonic, 1 = FunctionalMap, 2 = GromovWasserstein, 3 = HeatKernel, 4 =
  /// BlendedIntrinsic, 5 = CommonSphere, 6 = CommonOrbifold. Default: ReversibleHarmonic.
  vtkShapeEnumOption(Method, shape::CorrespondenceOptions::MethodType,
    shape::CorrespondenceOptions::MethodType::ReversibleHarmonic,
    shape::CorrespondenceOptions::MethodType::CommonOrbifold);
  ///@}

  ///@{
  /// What ReversibleHarmonic starts from: 0 = FunctionalMap, 1 = LandmarkCells. Default:
  /// FunctionalMap.
  vtkShapeEnumOption(Start, shape::CorrespondenceOptions::StartType,
    shape::CorrespondenceOptions::StartType::FunctionalMap,
    shape::CorrespondenceOptions::StartType::LandmarkCells);
  ///@}

  ///@{
  /// Which surface is a part of the other one, for FunctionalMap and the start of
  /// ReversibleHarmonic: 0 = Automatic, by distances along them, 1 = None, 2 = SurfaceA, 3 =
  /// SurfaceB. Default: Automatic.
  vtkShapeEnumOption(Part, shape::CorrespondenceOptions::PartType,
    shape::CorrespondenceOptions::PartType::Automatic,
    shape::CorrespondenceOptions::PartType::SurfaceB);
  ///@}

  ///@{
  /// ReversibleHarmonic: whether given landmarks go to their partners exactly. Default: on.
  vtkShapeOption(PinLandmarks, bool);
  ///@}

  ///@{
  /// ReversibleHarmonic: iterations at most; at least 1. Default: 100.
  vtkShapeOption(MaximumIterations, int);
  ///@}

  ///@{
  /// FunctionalMap, and the start of ReversibleHarmonic: eigenfunctions of each surface at most; at
  /// least 10. Default: 120.
  vtkShapeOption(NumberOfEigenpairs, int);
  ///@}

  ///@{
  /// GromovWasserstein: points of each surface that are compared; at least 10. Default: 500.
  vtkShapeOption(Samples, int);
  ///@}

  ///@{
  /// Surfaces of more points are mapped on coarse ones of about so many, and the maps carried over;
  /// ReversibleHarmonic of two fifths as many as there are, where that is less but at least 2000,
  /// and refined. CommonSphere and CommonOrbifold take all points. 0: never; else at least 100.
  /// Default: 8000.
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
