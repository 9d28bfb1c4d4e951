/**
 * @class   vtkShapeMapErrorCurve
 * @brief   how far a map between surfaces is from the true one, as a cumulative curve
 *
 * Input: a surface with the map array (double, 3): where its points go. Target: the surface that
 * they go to. Truth: any data set whose points are places on Input and whose map array says where
 * on Target they truly go; an array named by SymmetryArray, where it is there, says where a
 * symmetry of the shape takes that: the errors are then those to the truth with the lesser mean, of
 * the two as wholes. Blocks and distributed pieces of each are joined first.
 *
 * Output: a table, on one process: `Error`, ascending, the length of the shortest path along
 * Target, exact on its triangles, over what Normalisation says, and `Share`, of the places that
 * have at most this error. Field data: MapErrorCurve.Mean, .Median, .Percentile95, .Maximum and
 * .AreaUnderCurve (the mean share of errors up to LargestError) of the curve; .Unit, what errors
 * were divided by; .Mirrored, 1 where they are to the symmetric truth; .UnreachedPlaces, on another
 * component than their truth: in no row, but among all in Share; .LargestGap, from a place of the
 * Truth to its surface, in their units; .Coverage, the share of Target's area that the image lies
 * on (nearer than a hundredth of the root of the area). Where Target has the map array, too, its
 * map back to Input: .RoundTripMean and .RoundTripMaximum, how far points of Input come back from
 * themselves, over the root of its area.
 *
 * Measures of the map's cells, such as conformal distortion and Dirichlet energy, are Shape Map
 * Quality's.
 *
 * The mathematics: shape::ComputeMapErrorCurve, shape::ComputeRoundTripErrors,
 * shape::ComputeCoverage.
 */
#ifndef vtkShapeMapErrorCurve_h
#define vtkShapeMapErrorCurve_h

#include "vtkShapeAlgorithm.h"

#include "Correspondence/Evaluate/MapErrorCurve.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeMapErrorCurve : public vtkShapeAlgorithm
{
public:
  static vtkShapeMapErrorCurve* New();
  vtkTypeMacro(vtkShapeMapErrorCurve, vtkShapeAlgorithm);

  ///@{
  /// The point array (3 components) of Input and Truth, and of Target, that says where points go.
  /// Default: TargetPosition.
  vtkSetStdStringFromCharMacro(MapArray);
  vtkGetCharFromStdStringMacro(MapArray);
  ///@}

  ///@{
  /// The point array (3 components) of Truth with the symmetric truth. Default:
  /// SymmetricTargetPosition.
  vtkSetStdStringFromCharMacro(SymmetryArray);
  vtkGetCharFromStdStringMacro(SymmetryArray);
  ///@}

  ///@{
  /// 0 = None: errors in the units of Target. 1 = SquareRootOfArea, 2 = GeodesicDiameter: over
  /// that of Target. Default: SquareRootOfArea.
  vtkShapeEnumOption(Normalisation, shape::MapErrorCurveOptions::NormalisationType,
    shape::MapErrorCurveOptions::NormalisationType::None,
    shape::MapErrorCurveOptions::NormalisationType::GeodesicDiameter);
  ///@}

  ///@{
  /// Up to which error AreaUnderCurve goes. Default: 0.25.
  vtkShapeOption(LargestError, double);
  ///@}

protected:
  vtkShapeMapErrorCurve();
  ~vtkShapeMapErrorCurve() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeMapErrorCurve(const vtkShapeMapErrorCurve&) = delete;
  void operator=(const vtkShapeMapErrorCurve&) = delete;

  std::string MapArray = "TargetPosition";
  std::string SymmetryArray = "SymmetricTargetPosition";
  shape::MapErrorCurveOptions Options;
};

#endif
